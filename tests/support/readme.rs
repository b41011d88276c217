//! README: its code, its error, its commands and its pictures are what it says, and fit where it is read.

use std::fs;
use std::path::Path;

#[path = "../../crates/plm-program/examples/four_bar.rs"]
#[allow(dead_code, reason = "the example has a `main`")]
mod four_bar;

/// Characters of a line of code that GitHub shows without a scroll bar.
const WIDEST: usize = 96;
/// Bytes of a picture at most: who reads the README waits for it.
const LARGEST: u64 = 500_000;

fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Blocks of code with their kinds.
fn blocks(readme: &str) -> Vec<(&str, &str)> {
    let fenced = readme.split("```").skip(1).step_by(2);
    fenced.map(|block| block.split_once('\n').unwrap()).collect()
}

fn block<'a>(readme: &'a str, kind: &str, number: usize) -> &'a str {
    blocks(readme).into_iter().filter(|(of, _)| *of == kind).nth(number).expect(kind).1
}

fn declaration(code: &str) -> &str {
    let from = code.find("plm::mechanism!").unwrap();
    &code[from..from + code[from..].find("\n}}\n").unwrap()]
}

#[test]
fn the_declaration_is_that_of_the_example() {
    let readme = text("README.md");
    let code = block(&readme, "rust", 0);
    assert_eq!(declaration(code), declaration(&text("crates/plm-program/examples/four_bar.rs")));
    assert_eq!(block(&readme, "text", 0).trim(), four_bar::quarter().unwrap());
}

/// rustc says it of the test's file; of the README's code in `src/main.rs` it names another line.
#[test]
fn the_error_is_what_rustc_prints() {
    let readme = text("README.md");
    let line =
        block(&readme, "rust", 0).lines().position(|line| line.contains("revolute pin_d(")).unwrap() + 1;
    let case = text("tests/ui/assembly/short_rocker.rs");
    let tested = case.lines().position(|line| line.contains("revolute pin_d(")).unwrap() + 1;
    let printed = text("tests/ui/assembly/short_rocker.stderr");
    let expected = printed
        .replace(&format!("assembly/short_rocker.rs:{tested}:"), &format!("src/main.rs:{line}:"))
        .replace(&format!("{tested} |"), &format!("{line} |"));
    assert_eq!(block(&readme, "text", 1), expected);
    // The case is the README's declaration with a shorter rocker.
    let (short, long) =
        ("port c: (2.5, 0) cm; port d: (-2.5, 0) cm;", "port c: (12.5, 0) cm; port d: (-12.5, 0) cm;");
    assert_eq!(declaration(&case).replace(short, long), declaration(block(&readme, "rust", 0)));
}

#[test]
fn code_fits_without_a_scroll_bar() {
    let readme = text("README.md");
    for (kind, code) in blocks(&readme) {
        for line in code.lines() {
            assert!(line.chars().count() <= WIDEST, "{} characters: {line}", line.chars().count());
            assert!(
                kind != "sh" || line.starts_with('#') || !line.contains('#'),
                "a comment has its own line: {line}"
            );
        }
    }
}

#[test]
fn pictures_are_there_and_small() {
    let readme = text("README.md");
    let quoted = ["src=\"", "srcset=\""]
        .into_iter()
        .flat_map(|mark| readme.split(mark).skip(1))
        .map(|rest| rest.split('"').next());
    let linked = readme.split("![").skip(1).map(|rest| rest.split("](").nth(1)?.split(')').next());
    let pictures: Vec<&str> = quoted.chain(linked).map(Option::unwrap).collect();
    assert!(pictures.len() >= 3, "{pictures:?}");
    for picture in pictures {
        let about = fs::metadata(Path::new(env!("CARGO_MANIFEST_DIR")).join(picture)).expect(picture);
        assert!(about.len() < LARGEST, "{picture} has {} bytes", about.len());
    }
}
