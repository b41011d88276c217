//! A mechanism runs without std, allocation or a reachable panic, and gives the bits of the same program with std.
//!
//! The program is that of the package `tests/no_std`; it tells how each property is proved by linking.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(unexpected_cfgs, reason = "the package of the scene has features of its own")]

#[path = "no_std/src/scene.rs"]
mod scene;

use std::path::{Path, PathBuf};
use std::process::Command;

/// Builds the program without std; its path, or what cargo said.
fn build(features: &str) -> Result<PathBuf, String> {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_std");
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/no_std/Cargo.toml");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--bin", "bare", "--features", features])
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
        Ok(target.join("release/bare"))
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

#[test]
fn the_program_without_std_links_and_gives_the_same_bits() {
    let bare = build("").unwrap_or_else(|said| panic!("{said}"));
    let bare = Command::new(bare).output().unwrap();
    assert!(bare.status.success(), "{bare:?}");
    let bare: Vec<&str> = str::from_utf8(&bare.stdout).unwrap().lines().collect();

    let mut own = Vec::new();
    scene::run(|bits| own.push(format!("{bits:016x}"))).unwrap();
    assert!(own.len() > 100, "only {} numbers", own.len());
    assert_eq!(bare, own);
}

#[test]
fn a_panic_that_can_be_reached_does_not_link() {
    let said = build("panic").expect_err("a division by a number that may be zero links");
    assert!(said.contains("a_panic_can_be_reached"), "{said}");
}
