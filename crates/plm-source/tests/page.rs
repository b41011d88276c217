//! The example of the book's page on C source: its declaration, its program, and what that prints.

#![allow(clippy::unwrap_used, reason = "a test ends where something is missing")]

use std::fs;
use std::path::Path;
use std::process::Command;

use plm_dynamic::Mechanism;
use plm_source::Precision;

/// The text of the page's only block in a language.
fn block<'a>(page: &'a str, language: &str) -> &'a str {
    let (_, after) = page.split_once(&format!("```{language}\n")).unwrap();
    after.split_once("```").unwrap().0
}

#[test]
fn the_example_of_the_book_prints_what_the_book_says() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/running/c-source.md");
    let page = fs::read_to_string(page).unwrap();
    let mechanism = Mechanism::from_text(block(&page, "plm")).unwrap();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("page");
    fs::create_dir_all(&folder).unwrap();
    let files = plm_source::c(&mechanism, Precision::Double).unwrap();
    for file in &files {
        assert!(page.contains(&format!("written: pendulum/{}", file.name)), "{}", file.name);
        fs::write(folder.join(&file.name), &file.text).unwrap();
    }
    fs::write(folder.join("main.c"), block(&page, "c")).unwrap();
    let made = Command::new("cc")
        .args(["-std=c99", "-O2", "-Wall", "-Werror", "main.c", "pendulum.c", "-o", "main"])
        .current_dir(&folder)
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let ran = Command::new(folder.join("main")).output().unwrap();
    let said = String::from_utf8(ran.stdout).unwrap();
    assert!(page.contains(&format!("./main\n{said}```")), "{said}");
}
