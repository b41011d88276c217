//! The book's index of source files and the picture of the crates are those that `cargo xtask index` writes.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

#[path = "../xtask/src/index.rs"]
mod index;

use std::fs;
use std::path::Path;

#[test]
fn the_index_and_the_picture_are_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let texts = [(index::PAGE, index::page(root).unwrap()), (index::PICTURE, index::picture(root).unwrap())];
    for (path, text) in texts {
        let found = fs::read_to_string(root.join(path)).unwrap_or_default();
        assert!(found == text, "{path} is not up to date: `cargo xtask index` writes it");
    }
}
