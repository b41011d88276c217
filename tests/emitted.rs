//! The text that the compiler emits for eight mechanisms, word for word.
//!
//! Beside each declaration, `tests/snapshots/*.plm`, stands its emitted code, formatted. A change of emission shows in these files,
//! line by line: `PLM_BLESS=1 cargo test --test emitted` writes them anew. The test `bits` compiles and runs them.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

#[path = "snapshots/blessed.rs"]
mod blessed;

use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use plm_compiler::compile;
use plm_compiler::token::Sources;

use blessed::{blessed, folder};

/// The mechanisms, each with what it stands for.
const MECHANISMS: [(&str, &str); 8] = [
    ("arm_on_jack", "states of hydraulics, a limit that is hit"),
    ("bouncer", "conditions, a requirement, an input"),
    ("chain", "elimination body by body"),
    ("double_pendulum", "a tree"),
    ("driven_crank", "prescribed motion, a ground that moves"),
    ("four_bar", "a dyad, and charts"),
    ("plate_on_three_pins", "a group for Newton's iteration"),
    ("slider_crank", "absolute coordinates"),
];

/// What is emitted for a declaration, formatted as the repository is.
fn emitted(name: &str) -> String {
    let mut sources = Sources::new();
    let declaration = fs::read_to_string(folder().join(name).with_extension("plm")).unwrap();
    sources.add_text(name, &declaration);
    let expansion = compile(&mut sources);
    let messages: Vec<String> =
        expansion.diagnostics.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    formatted(&expansion.code.unwrap().text())
}

fn formatted(code: &str) -> String {
    let config = Path::new(env!("CARGO_MANIFEST_DIR")).join("rustfmt.toml");
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config-path"])
        .arg(config)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    rustfmt.stdin.take().unwrap().write_all(code.as_bytes()).unwrap();
    let output = rustfmt.wait_with_output().unwrap();
    assert!(output.status.success(), "rustfmt does not take what is emitted");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn emitted_code_is_as_it_was_blessed() {
    let compared = MECHANISMS.map(|(name, _)| blessed(&format!("{name}.rs"), &emitted(name)));
    let changed: Vec<String> = compared.into_iter().filter_map(Result::err).collect();
    assert!(changed.is_empty(), "PLM_BLESS=1 takes what is emitted now\n{}", changed.join("\n"));
}
