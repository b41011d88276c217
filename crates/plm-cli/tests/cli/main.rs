//! The program `plm`: its words, what it reads, what it writes where, and its exit code.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod check;
mod drag;
mod drawings;
mod export;
mod export_links;
mod export_models;
mod extension;
mod files;
mod fmt;
mod identify;
mod import;
mod import_loops;
mod inputs;
mod json;
mod lsp;
mod mcp;
mod modes;
mod report;
mod run;
mod told;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Exit code, standard output and standard error.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Said {
    pub(crate) code: i32,
    pub(crate) output: String,
    pub(crate) errors: String,
}

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// An empty folder for files of a test, another one each time.
pub(crate) fn folder() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{number}"));
    // What an earlier run has left is no part of this one.
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs the program in a folder with an input.
pub(crate) fn plm_in(folder: &Path, words: &[&str], input: &[u8]) -> Said {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm"));
    command.args(words).current_dir(folder);
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let output = std::thread::scope(|scope| {
        // A program that ends early does not read all of it.
        scope.spawn(move || stdin.write_all(input).is_ok());
        child.wait_with_output().unwrap()
    });
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Said { code: output.status.code().unwrap(), output: text(output.stdout), errors: text(output.stderr) }
}

pub(crate) fn plm(words: &[&str], input: &str) -> Said {
    plm_in(Path::new("."), words, input.as_bytes())
}
