//! The picture of the architecture is what the manifests give; packages have what they need; counts are those of what is counted.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::path::Path;

#[path = "../src/architecture.rs"]
mod architecture;
#[path = "files/contract.rs"]
mod contract;
#[path = "files/counts.rs"]
mod counts;
#[path = "files/packages.rs"]
mod packages;
#[path = "../src/workspace.rs"]
mod workspace;

/// The folder of the workspace.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

#[test]
fn the_picture_of_the_architecture_is_current() {
    let (path, made) = (architecture::PICTURE, architecture::picture(root()).unwrap());
    let shown = workspace::read(&root().join(path)).unwrap_or_default();
    assert!(shown == made, "{path} is not what the manifests give: run `cargo xtask architecture`");
}
