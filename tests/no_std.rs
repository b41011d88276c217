//! A mechanism runs without std, allocation or a reachable panic, and gives the bits of the same program with std.
//!
//! The programs are those of the package `tests/no_std`; it tells how each property is proved by linking.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))]
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Builds one of the two programs; its path, or what cargo said.
fn build(program: &str, features: &str) -> Result<PathBuf, String> {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_std");
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/no_std/Cargo.toml");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--bin", program, "--features", features])
        .arg("--manifest-path")
        .arg(manifest)
        .arg("--target-dir")
        .arg(&target)
        .env_remove("RUSTFLAGS")
        // What is built in steps is optimised in smaller parts, in which more panics seem to be reachable.
        .env_remove("CARGO_INCREMENTAL")
        .output()
        .unwrap();
    if output.status.success() {
        Ok(target.join("release").join(program))
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

fn lines(output: &Output) -> Vec<&str> {
    assert!(output.status.success(), "{output:?}");
    str::from_utf8(&output.stdout).unwrap().lines().collect()
}

#[test]
fn the_program_without_std_links_and_gives_the_same_bits() {
    let bare = build("bare", "").unwrap_or_else(|said| panic!("{said}"));
    let bare = Command::new(bare).output().unwrap();
    let twin = build("twin", "std").unwrap_or_else(|said| panic!("{said}"));
    let twin = Command::new(twin).output().unwrap();

    let (bare, twin) = (lines(&bare), lines(&twin));
    assert!(bare.len() > 100, "only {} numbers", bare.len());
    assert!(bare.iter().all(|line| line.len() == 16), "{bare:?}");
    assert_eq!(bare, twin);
}

#[test]
fn a_panic_that_can_be_reached_does_not_link() {
    let said = build("bare", "panic").expect_err("a division by a number that may be zero links");
    assert!(said.contains("a_panic_can_be_reached"), "{said}");
}
