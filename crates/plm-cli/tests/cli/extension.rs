//! The extension of Visual Studio Code: files that it names, words, version.

use std::fs;

use plm_compiler::words;
use serde_json::Value;

use super::{plm, root};

fn json(file: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(root().join("editors/vscode").join(file)).unwrap()).unwrap()
}

#[test]
fn the_extension_is_whole_and_of_the_workspaces_version() {
    let package = json("package.json");
    assert_eq!(package["version"], env!("CARGO_PKG_VERSION"));
    let contributes = &package["contributes"];
    let mut files = vec![package["main"].as_str().unwrap().to_owned()];
    for language in contributes["languages"].as_array().unwrap() {
        files.push(language["configuration"].as_str().unwrap().to_owned());
        json(language["configuration"].as_str().unwrap());
    }
    for grammar in contributes["grammars"].as_array().unwrap() {
        let file = grammar["path"].as_str().unwrap();
        files.push(file.to_owned());
        assert_eq!(json(file)["scopeName"], grammar["scopeName"]);
    }
    for file in files {
        assert!(root().join("editors/vscode").join(&file).is_file(), "{file}");
    }
    // The client starts a command that exists, and reads settings that are declared.
    let client = fs::read_to_string(root().join("editors/vscode/extension.js")).unwrap();
    let settings = contributes["configuration"]["properties"].as_object().unwrap();
    for key in settings.keys() {
        assert!(client.contains(&format!("settings.get('{}')", key.strip_prefix("plm.").unwrap())), "{key}");
    }
    assert!(client.contains("args: ['lsp']") && plm(&["help", "lsp"], "").code == 0);
}

#[test]
fn the_grammar_has_the_words_of_the_language() {
    let grammar = json("syntaxes/plm.tmLanguage.json");
    let patterns = grammar["patterns"].as_array().unwrap();
    let words_of = |scope: &str| {
        let pattern = patterns.iter().find(|pattern| pattern["name"] == scope).unwrap();
        let text = pattern["match"].as_str().unwrap();
        let (_, list) = text.split_once("(?:").unwrap();
        list.split_once(')').unwrap().0.split('|').map(str::to_owned).collect::<Vec<_>>()
    };
    let has_all = |scope: &str, words: &[&str]| {
        let known = words_of(scope);
        // Words that are names as often have no colour.
        let missing = words
            .iter()
            .filter(|word| !known.iter().any(|of| of == *word) && !["angle", "axis", "depth"].contains(word));
        assert_eq!(missing.collect::<Vec<_>>(), Vec::<&&str>::new(), "{scope}");
    };
    has_all("keyword.other.plm", &[words::items(), words::inner()].concat());
    has_all("support.function.plm", &words::functions());
    has_all("keyword.other.unit.plm", &words::units());
}
