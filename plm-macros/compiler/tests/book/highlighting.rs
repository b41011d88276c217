//! Colours of declarations: one list of patterns, for the highlighter of the book and for editors.

use std::collections::BTreeSet;
use std::path::Path;

use plm_compiler::words;

use super::same;

/// A pattern, with its scope in TextMate's grammars and its class in highlight.js (empty: no colour). Of two patterns that match
/// at a place the first one counts.
struct Pattern {
    scope: &'static str,
    class: &'static str,
    matches: String,
}

/// Words that are names as often, and say something in front of a colon alone.
const NAMES_TOO: [&str; 3] = ["angle", "axis", "depth"];

/// Words of Rust that stand in front of a mechanism.
const OF_RUST: [&str; 3] = ["crate", "pub", "use"];

fn any_of<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: BTreeSet<&str> = words.into_iter().filter(|word| !NAMES_TOO.contains(word)).collect();
    let words: Vec<&str> = words.into_iter().collect();
    format!(r"\b(?:{})\b", words.join("|"))
}

fn patterns() -> Vec<Pattern> {
    let pattern = |scope, class, matches: &str| Pattern { scope, class, matches: matches.to_owned() };
    let name = r"[A-Za-z_]\w*";
    let indices = r"(?:\s*\[[^\]]*\])*";
    let keywords = [words::items(), words::inner(), OF_RUST.to_vec()].concat();
    vec![
        pattern("variable.other.member.plm", "", &format!(r"\.\s*{name}")),
        pattern("constant.numeric.plm", "number", r"\b\d[\d_]*(?:\.\d[\d_]*)?(?:[eE][+-]?\d+)?"),
        pattern("support.function.plm", "built_in", &format!(r"{}(?=\s*\()", any_of(words::functions()))),
        pattern("keyword.other.plm", "keyword", &any_of(keywords)),
        pattern("variable.parameter.plm", "", &format!(r"\b{name}(?:\.{name}|\s*\[[^\]]*\])*(?=\s*:(?!:))")),
        pattern("entity.name.type.part.plm", "title", &format!(r"\b[a-z_]\w*(?=\s+{name}{indices}\s*\()")),
        pattern("constant.language.plm", "literal", &any_of(words::constants())),
        pattern("keyword.other.unit.plm", "string", &any_of(words::units())),
        pattern("entity.name.type.plm", "title", r"\b[A-Z]\w*(?=\s*\{)"),
    ]
}

/// A text in quotes of JSON; that of JavaScript is the same.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

fn for_the_book() -> String {
    let rows = patterns();
    let rows = rows.iter().map(|of| format!("    [{}, {}],\n", quoted(of.class), quoted(&of.matches)));
    let head = "// Written by `cargo xtask bless book` from the tables of the compiler: classes of highlight.js and what has them.\n";
    format!("{head}const plmPatterns = [\n{}];\n", rows.collect::<String>())
}

fn for_editors() -> String {
    let rows = patterns();
    let rows = rows
        .iter()
        .map(|of| format!("    {{ \"name\": {}, \"match\": {} }}", quoted(of.scope), quoted(&of.matches)));
    format!(
        r##"{{
  "comment": "Written by `cargo xtask bless book` from the tables of the compiler.",
  "name": "plm",
  "scopeName": "source.plm",
  "fileTypes": ["plm"],
  "patterns": [
    {{ "name": "comment.line.documentation.plm", "match": "//[/!].*$" }},
    {{ "name": "comment.line.double-slash.plm", "match": "//.*$" }},
    {{ "include": "#comment" }},
    {{ "name": "string.quoted.double.plm", "begin": "\"", "end": "\"" }},
    {{ "begin": "\\{{", "end": "\\}}", "patterns": [{{ "include": "$self" }}] }},
{}
  ],
  "repository": {{
    "comment": {{
      "name": "comment.block.plm", "begin": "/\\*", "end": "\\*/", "patterns": [{{ "include": "#comment" }}]
    }}
  }}
}}
"##,
        rows.collect::<Vec<_>>().join(",\n")
    )
}

#[test]
fn the_colours_of_declarations_are_those_of_the_compilers_words() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    same(&root.join("docs/theme/words.js"), &for_the_book());
    same(&root.join("editors/vscode/syntaxes/plm.tmLanguage.json"), &for_editors());
}
