//! The book's list of source files is the one that the files give.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

#[path = "../xtask/src/index.rs"]
mod index;

fn same(path: &str, made: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let shown = index::read(&root.join(path)).unwrap_or_default();
    assert!(shown == made, "{path} is not what the sources give: run `cargo xtask index`");
}

#[test]
fn the_list_of_files_is_current() {
    let made = index::page(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap();
    same(index::PAGE, &made);
}
