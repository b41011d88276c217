//! Resources: each that is listed is there, each example compiles, and the skill is true.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::{answers, call, request};
use crate::{folder, plm};

fn listed() -> Vec<String> {
    let said = answers(&folder(), &[], &[request(1, "resources/list", &json!({}))]);
    let all = said[0]["result"]["resources"].as_array().unwrap();
    all.iter().map(|own| own["uri"].as_str().unwrap().to_owned()).collect()
}

fn texts(uris: &[String]) -> Vec<String> {
    let reads = uris.iter().map(|uri| request(1, "resources/read", &json!({ "uri": uri })));
    let said = answers(&folder(), &[], &reads.collect::<Vec<_>>());
    assert_eq!(said.len(), uris.len());
    let text =
        |answer: &Value| answer["result"]["contents"][0]["text"].as_str().unwrap_or_default().to_owned();
    said.iter().map(text).collect()
}

#[test]
fn every_resource_can_be_read_by_its_name() {
    let uris = listed();
    assert_eq!(uris.iter().collect::<BTreeSet<_>>().len(), uris.len(), "names that stand for two");
    for (folder, least) in [("book", 240), ("part", 90), ("example", 100)] {
        let count = uris.iter().filter(|uri| uri.starts_with(&format!("plm://{folder}/"))).count();
        assert!(count >= least, "{count} of {folder}");
    }
    for (uri, text) in uris.iter().zip(texts(&uris)) {
        assert!(text.len() > 20, "{uri}: {text:?}");
        assert!(!text.contains("{{#include"), "{uri}: a program that is not there");
    }
    let said =
        answers(&folder(), &[], &[request(1, "resources/read", &json!({ "uri": "plm://part/revolut" }))]);
    let message = said[0]["error"]["message"].as_str().unwrap();
    assert!(message.ends_with("`plm://part/revolute` is one"), "{message}");
}

#[test]
fn every_example_compiles_without_a_word() {
    let uris: Vec<String> = listed().into_iter().filter(|uri| uri.starts_with("plm://example/")).collect();
    let calls = texts(&uris).into_iter().map(|text| call(1, "check", &json!({ "text": text })));
    let said = answers(&folder(), &[], &calls.collect::<Vec<_>>());
    for (uri, answer) in uris.iter().zip(said) {
        let found = &answer["result"]["structuredContent"];
        let is_silent = found["diagnostics"] == json!([]) && found["messages"] == json!([]);
        assert!(is_silent, "{uri}: {answer}");
    }
}

/// The skill has the head that agents read, declarations that compile, and names of commands and resources that are there.
#[test]
fn the_skill_is_true() {
    let skill = &texts(&["plm://skill".to_owned()])[0];
    let head = skill.strip_prefix("---\n").and_then(|rest| rest.split_once("\n---\n")).unwrap().0;
    assert!(head.contains("name: plm\n"), "{head}");
    let about = head.lines().find_map(|line| line.strip_prefix("description: ")).unwrap();
    assert!((50..1024).contains(&about.len()), "{about}");
    let declarations: Vec<&str> =
        skill.split("```plm\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(!declarations.is_empty());
    for declaration in declarations {
        let said = plm(&["check", "-"], declaration);
        assert!(said.code == 0 && said.errors.is_empty(), "{said:?}");
    }
    let help = plm(&["help"], "").output;
    let named = skill.split("`plm ").skip(1).filter_map(|rest| rest.split([' ', '`']).next());
    for command in named {
        assert!(help.contains(&format!("  plm {command} ")), "plm {command}");
    }
    let (uris, words) = (listed(), skill.split('`').skip(1).step_by(2));
    for uri in words.filter(|word| word.starts_with("plm://") && !word.contains('…')) {
        assert!(uris.iter().any(|own| own == uri), "{uri}");
    }
}
