//! Modules of a crate may depend on each other in circles of three at most, so that each room can be read by itself.
//!
//! A module is a file or a folder beside `lib.rs`; it depends on those that its sources name after `crate::`, and at its top after
//! `super::`. Names that `lib.rs` exports again count for the module that has them. Large modules are looked at as crates are: `mod.rs`
//! is their `lib.rs`, and their path stands after `crate::`.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The sources that are looked at.
const CRATES: [&str; 19] = [
    "src",
    "crates/plm-cli/src",
    "crates/plm-foreign/src",
    "crates/plm-import/src",
    "crates/plm-jit/src",
    "plm-macros/cas/src",
    "plm-macros/compiler/src",
    "crates/plm-program/src",
    "crates/plm-python/src",
    "crates/plm-dynamic/src",
    "crates/plm-run/src",
    "plm-runtime/math/src",
    "plm-runtime/src",
    "crates/plm-studies/src",
    "crates/plm-studies/src/analysis",
    "crates/plm-studies/src/optimise",
    "crates/plm-studies/src/synthesis",
    "crates/plm-view/src",
    "crates/plm-view/src/sketch",
];
const LARGEST: usize = 3;

/// Who depends on whom.
type Graph = BTreeMap<String, BTreeSet<String>>;

#[test]
fn modules_depend_on_each_other_in_small_circles() {
    let found: Vec<String> = CRATES
        .iter()
        .flat_map(|source| {
            let graph = graph(&Path::new(env!("CARGO_MANIFEST_DIR")).join(source));
            let large = circles(&graph).into_iter().filter(|circle| circle.len() > LARGEST);
            large.map(|circle| format!("{source}: {}", circle.join(", "))).collect::<Vec<_>>()
        })
        .collect();
    assert!(found.is_empty(), "circles of more than {LARGEST} modules:\n{}", found.join("\n"));
}

#[test]
fn a_circle_is_found() {
    let of = |edges: &[(&str, &str)]| {
        let mut graph = Graph::new();
        for (from, to) in edges {
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        circles(&graph).into_iter().map(|circle| circle.len()).max()
    };
    assert_eq!(of(&[("a", "b"), ("b", "c"), ("c", "d"), ("d", "a"), ("a", "e")]), Some(4));
    assert_eq!(of(&[("a", "b"), ("b", "c"), ("a", "c")]), Some(1));
}

/// Sets of modules each of which can be reached from every other.
fn circles(graph: &Graph) -> Vec<Vec<String>> {
    let reached = |from: &str| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
        while let Some(module) = open.pop() {
            for to in graph.get(&module).into_iter().flatten() {
                if seen.insert(to.clone()) {
                    open.push(to.clone());
                }
            }
        }
        seen
    };
    let all: BTreeMap<&String, BTreeSet<String>> = graph.keys().map(|from| (from, reached(from))).collect();
    let circle = |of: &String| -> Vec<String> {
        let returns = |other: &&String| *other == of || all.get(other).is_some_and(|seen| seen.contains(of));
        graph
            .keys()
            .filter(|other| *other == of || all[of].contains(*other))
            .filter(returns)
            .cloned()
            .collect()
    };
    all.keys().map(|of| circle(of)).collect::<BTreeSet<_>>().into_iter().collect()
}

fn graph(source: &Path) -> Graph {
    let modules: Vec<(String, PathBuf)> = entries(source)
        .into_iter()
        .filter_map(|path| Some((path.file_stem()?.to_str()?.to_owned(), path)))
        .filter(|(name, _)| !["lib", "main", "mod"].contains(&name.as_str()))
        .collect();
    let names: BTreeSet<&str> = modules.iter().map(|(name, _)| name.as_str()).collect();
    let (root, prefix) = root(source);
    let exported = exported(&fs::read_to_string(root).unwrap());
    let mut graph = Graph::new();
    for (module, path) in &modules {
        let depends = graph.entry(module.clone()).or_default();
        for file in files(path) {
            let text = code(&fs::read_to_string(&file).unwrap());
            let is_top = file == *path || file == path.join("mod.rs");
            let mut named = after(&prefix, &text);
            if is_top {
                named.extend(after("super::", &text));
            }
            let to = named.iter().map(|name| exported.get(name).unwrap_or(name));
            depends.extend(to.filter(|to| names.contains(to.as_str()) && *to != module).cloned());
        }
    }
    graph
}

/// The file that names the modules of a folder, and the path of its modules in their crate.
fn root(source: &Path) -> (PathBuf, String) {
    if source.ends_with("src") {
        return (source.join("lib.rs"), "crate::".to_owned());
    }
    let folders: Vec<&str> = source.components().map(|part| part.as_os_str().to_str().unwrap()).collect();
    let crate_at = folders.iter().rposition(|folder| *folder == "src").unwrap();
    (source.join("mod.rs"), format!("crate::{}::", folders[crate_at + 1..].join("::")))
}

/// Code without comments, and without the tests at its end.
fn code(text: &str) -> String {
    let lines = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]"));
    lines.map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The first names after a prefix: one, or those in braces.
fn after(prefix: &str, text: &str) -> Vec<String> {
    let mut names = Vec::new();
    for (at, _) in text.match_indices(prefix) {
        let before = text[..at].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':' || c == '$') {
            continue;
        }
        let rest = &text[at + prefix.len()..];
        match rest.strip_prefix('{') {
            Some(list) => names.extend(firsts(list)),
            None => names.push(word(rest).to_owned()),
        }
    }
    names
}

/// The first names of the paths in a list in braces.
fn firsts(list: &str) -> Vec<String> {
    let (mut depth, mut names, mut path) = (0, Vec::new(), String::new());
    for c in list.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(core::mem::take(&mut path)),
            _ if depth == 0 => path.push(c),
            _ => {}
        }
    }
    names.push(path);
    names.iter().map(|path| word(path.trim_start()).to_owned()).collect()
}

fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
    &text[..end]
}

/// Names that `lib.rs` exports again, with the module that has them.
fn exported(text: &str) -> BTreeMap<String, String> {
    let (mut names, text) = (BTreeMap::new(), code(text));
    for rest in text.split("use ").skip(1) {
        let path = rest.split(';').next().unwrap_or_default();
        let Some((module, inner)) = path.split_once("::") else { continue };
        let inner = inner.trim_start_matches('{').trim_end_matches('}');
        for name in inner.split(',').filter_map(|name| name.rsplit("::").next()) {
            names.insert(word(name.trim()).to_owned(), module.to_owned());
        }
    }
    names
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect()
}

/// The sources of a module: a file, or all in a folder.
fn files(path: &Path) -> Vec<PathBuf> {
    if path.is_dir() {
        return entries(path).iter().flat_map(|path| files(path)).collect();
    }
    if path.extension().is_some_and(|extension| extension == "rs") {
        vec![path.to_owned()]
    } else {
        Vec::new()
    }
}
