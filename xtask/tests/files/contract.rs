//! The contract of generated code is one module, and has what emission names and nothing else.

use std::fs;
use std::path::Path;

use super::workspace;

/// The text of all sources in a folder and below.
fn sources(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            text += &sources(&path);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text += &workspace::read(&path).unwrap();
        }
    }
    text
}

/// The items of the contract, as paths inside of its module.
fn items(contract: &str) -> Vec<String> {
    let (mut items, mut module) = (Vec::new(), String::new());
    let code: Vec<&str> = contract.lines().filter(|line| !line.starts_with("//")).collect();
    let code = code.join("\n");
    for statement in code.split("pub ").skip(1) {
        if let Some(name) = statement.strip_prefix("mod ") {
            module = format!("{}::", name.split([' ', '{']).next().unwrap());
        } else if let Some(path) = statement.strip_prefix("use crate::") {
            let path = path.split(';').next().unwrap();
            let names = match path.split_once('{') {
                Some((_, names)) => names.trim_end_matches('}'),
                None => path.rsplit("::").next().unwrap(),
            };
            let names = names.split(',').map(str::trim).filter(|name| !name.is_empty());
            items.extend(names.map(|name| format!("{module}{name}")));
        }
    }
    items
}

/// Does a text have a path, with nothing after it that makes it another one?
fn has(text: &str, path: &str) -> bool {
    let ends = |rest: &str| !rest.starts_with(|next: char| next.is_alphanumeric() || next == '_');
    text.match_indices(path).any(|(at, _)| ends(&text[at + path.len()..]))
}

#[test]
fn the_contract_of_generated_code_has_what_is_emitted() {
    let root = super::root();
    let items = items(&workspace::read(&root.join("plm-runtime/src/generated.rs")).unwrap());
    assert!(items.len() > 100, "items were read: {items:?}");
    let emission = sources(&root.join("plm-macros/compiler/src"));
    let imported = emission.split("use #path::runtime::generated::{").skip(1);
    let imported: Vec<&str> = imported.filter_map(|rest| rest.split('}').next()).collect();
    let imported = imported.join(" ");
    let is_named = |item: &String| {
        // Two of its modules have names of their own in emitted code.
        let is_short = item.starts_with("absolute::") || item.starts_with("described::");
        let is_table = item
            .strip_prefix("compact::")
            .is_some_and(|name| emission.contains(&format!("table(\"{name}\"")));
        is_table
            || has(&emission, &format!("rt::{item}"))
            || has(&imported, item)
            || item == "lanes::Two"
            || is_short && has(&emission, item)
    };
    let idle: Vec<&String> = items.iter().filter(|item| !is_named(item)).collect();
    assert!(idle.is_empty(), "items of plm-runtime/src/generated.rs that no emitted code names: {idle:?}");
}

#[test]
fn emitted_code_names_the_runtime_by_its_contract_alone() {
    let root = super::root();
    let emission = sources(&root.join("plm-macros/compiler/src/emit"));
    let loose = emission
        .match_indices("path::runtime")
        .filter(|(at, path)| !emission[at + path.len()..].starts_with("::generated"));
    assert_eq!(loose.count(), 0, "emitted paths into plm-runtime beside plm_runtime::generated");
}
