//! Source files: each is a module, and says what it is.

use std::fs;

use super::{fail_with, files, is_emitted, shown};

/// A file that no module names is never compiled.
#[test]
fn every_source_file_is_a_module() {
    let mut wrong = Vec::new();
    for file in files(&["rs"])
        .into_iter()
        .filter(|file| shown(file).contains("src/") && !shown(file).starts_with("tests/"))
    {
        let stem = file.file_stem().unwrap().to_str().unwrap();
        let folder = file.parent().unwrap();
        if ["lib", "main", "bare", "twin"].contains(&stem) {
            continue;
        }
        let (name, above) = if stem == "mod" {
            (folder.file_name().unwrap().to_str().unwrap(), folder.parent().unwrap())
        } else {
            (stem, folder)
        };
        let parents = ["mod.rs", "lib.rs", "main.rs", "bare.rs"].map(|parent| above.join(parent));
        let named = parents.into_iter().chain([above.with_extension("rs")]).any(|parent| {
            fs::read_to_string(parent).is_ok_and(|text| text.contains(&format!("mod {name};")))
        });
        if !named {
            wrong.push(shown(&file));
        }
    }
    fail_with("source files that no module names", &wrong);
}

/// The first lines of a file say what it does.
#[test]
fn every_source_file_says_what_it_is() {
    let mut wrong = Vec::new();
    for file in files(&["rs"]).into_iter().filter(|file| !is_emitted(file)) {
        let text = fs::read_to_string(&file).unwrap();
        if shown(&file).contains("src/") && !text.starts_with("//! ") {
            wrong.push(shown(&file));
        }
    }
    fail_with("files without `//!` at the top", &wrong);
}
