//! `plm fmt` over every declaration of the repository: tests, examples, parts, the book.

use std::fs;
use std::path::{Path, PathBuf};

use plm_compiler::compile;
use plm_compiler::token::Sources;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::{Said, folder, plm, plm_in, root};

/// Files of the repository below a folder with one of these endings.
fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() && !["target", ".git", "node_modules"].contains(&name.as_str()) {
            found.extend(files(&path, endings));
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Every declaration, with a name for its copy.
fn declarations() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for path in files(&root(), &[".plm", ".rs", ".md"]) {
        let text = fs::read_to_string(&path).unwrap();
        let (number, ending) = (all.len(), path.extension().unwrap().to_str().unwrap());
        match ending {
            "md" => {
                let blocks = text
                    .split("```plm")
                    .skip(1)
                    .filter_map(|block| block.split_once('\n')?.1.split_once("```"));
                all.extend(
                    blocks
                        .enumerate()
                        .map(|(at, (block, _))| (format!("{number}-{at}.plm"), block.to_owned())),
                );
            }
            "rs" if !["mechanism!", "parts!", "scene!"].iter().any(|call| text.contains(call)) => {}
            // Mechanisms of tests from text.
            "rs" => all.push((format!("{number}.rs"), text.replace("scene! {", "mechanism! {"))),
            _ => all.push((format!("{number}.{ending}"), text)),
        }
    }
    all
}

/// The texts of all tokens, by a reader that is not the formatter's.
fn tokens(stream: TokenStream, all: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                let brackets = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                all.push(brackets[0].to_owned());
                tokens(group.stream(), all);
                all.push(brackets[1].to_owned());
            }
            leaf => all.push(leaf.to_string()),
        }
    }
}

fn read(text: &str) -> Option<Vec<String>> {
    let mut all = Vec::new();
    tokens(text.parse().ok()?, &mut all);
    Some(all)
}

/// Comments as they stand, without what is in front of them.
fn comments(text: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| line.split_once("//"))
        .map(|(_, comment)| comment.trim_end().to_owned())
        .collect()
}

#[test]
fn the_layout_of_every_declaration_keeps_its_tokens_and_is_one() {
    let folder = folder();
    let all = declarations();
    for (name, text) in &all {
        fs::write(folder.join(name), text).unwrap();
    }
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    let once = plm_in(&folder, &[&["fmt"], &names[..]].concat(), b"");
    let is_known = |line: &str| line.starts_with("plm: ") && line.contains(": line ");
    assert!(once.output.is_empty() && once.errors.lines().all(is_known), "{}", once.errors);
    let mut changed = Vec::new();
    for (name, text) in &all {
        let made = fs::read_to_string(folder.join(name)).unwrap();
        if once.errors.contains(&format!("plm: {name}: line ")) {
            assert!(made == *text && read(text).is_none(), "{name} has a layout");
        } else if made != *text {
            assert!(read(&made) == read(text), "{name}: other tokens\n{made}");
            assert_eq!(comments(&made), comments(text), "{name}");
            changed.push(name.as_str());
        }
    }
    // Those that have not changed are the same a second time.
    let twice = plm_in(&folder, &[&["fmt", "--check"], &changed[..]].concat(), b"");
    assert_eq!(twice, Said { code: 0, output: String::new(), errors: String::new() }, "a second time");
    let changed = changed.len();
    // The style is that in which declarations are written.
    assert!(
        all.len() > 800 && changed > 20 && changed * 8 < all.len(),
        "{changed} of {} declarations change",
        all.len()
    );
}

#[test]
fn parts_and_examples_have_the_layout() {
    let root = root();
    let folders = ["plm-macros/compiler/parts", "examples/gallery", "examples/tasks", "examples/manual"];
    let files: Vec<PathBuf> =
        folders.iter().flat_map(|folder| files(&root.join(folder), &[".plm", ".rs"])).collect();
    let names: Vec<&str> = files.iter().map(|file| file.to_str().unwrap()).collect();
    let said = plm(&[&["fmt", "--check"], &names[..]].concat(), "");
    assert_eq!(said, Said { code: 0, output: String::new(), errors: String::new() });
}

/// The code without the declaration itself, which it holds as it was written.
fn code(text: &str) -> String {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let code = compile(&mut sources).code.unwrap().text();
    code.lines().filter(|line| !line.contains("DECLARATION")).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_code_of_a_declaration_does_not_depend_on_its_layout() {
    for path in files(&root().join("tests/snapshots"), &[".plm"]) {
        let text = fs::read_to_string(&path).unwrap();
        let squeeze = |line: &str| {
            if line.trim_start().starts_with("//") {
                return line.to_owned();
            }
            line.replace("    ", "  ").replace(" = ", "=").replace(" + ", "+").replace(": ", " :")
        };
        let squeezed: String = text.lines().map(|line| squeeze(line) + "\n").collect();
        let made = plm(&["fmt", "-"], &squeezed).output;
        assert_ne!(made, squeezed);
        assert_eq!(made, plm(&["fmt", "-"], &text).output, "{}", path.display());
        assert_eq!(code(&made), code(&text), "{}", path.display());
    }
}

#[test]
fn what_cannot_be_laid_out_is_left_as_it_is() {
    let folder = folder();
    let wrong = "pub P {\n  body b { mass: (1 kg; }\n";
    fs::write(folder.join("wrong.plm"), wrong).unwrap();
    fs::write(folder.join("loose.plm"), "pub P{}\n").unwrap();
    let said = plm_in(&folder, &["fmt", "wrong.plm", "loose.plm"], b"");
    assert_eq!(
        (said.code, said.errors.as_str()),
        (1, "plm: wrong.plm: line 2: the bracket `}` has no partner\n")
    );
    assert_eq!(fs::read_to_string(folder.join("wrong.plm")).unwrap(), wrong);
    assert_eq!(fs::read_to_string(folder.join("loose.plm")).unwrap(), "pub P {}\n");
    // Time grows with the length alone.
    fs::write(folder.join("comments.plm"), "//\n".repeat(200_000)).unwrap();
    assert_eq!(plm_in(&folder, &["fmt", "--check", "comments.plm"], b"").code, 0);
    let said = plm_in(&folder, &["fmt", "--check", "-"], b"pub P{}");
    assert_eq!((said.code, said.output.as_str()), (1, "<stdin>\n"));
}
