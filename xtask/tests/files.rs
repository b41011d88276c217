//! The book's list of source files and the picture of the architecture are those that the sources give; packages have what they need.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

#[path = "../src/architecture.rs"]
mod architecture;
#[path = "files/contract.rs"]
mod contract;
#[path = "../src/index.rs"]
mod index;
#[path = "files/packages.rs"]
mod packages;

/// The folder of the workspace.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

fn same(path: &str, made: &str) {
    let shown = index::read(&root().join(path)).unwrap_or_default();
    assert!(shown == made, "{path} is not what the sources give: run `cargo xtask index`");
}

#[test]
fn the_list_of_files_is_current() {
    let made = index::page(root()).unwrap();
    same(index::PAGE, &made);
}

#[test]
fn the_picture_of_the_architecture_is_current() {
    let made = architecture::picture(root()).unwrap();
    same(architecture::PICTURE, &made);
}
