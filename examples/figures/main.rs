//! The drawn figures of the book: parts from the examples of their pages, demos from their declarations.
//!
//! `cargo run --example figures` writes them to `docs/src/images/`; a test compares them with what is there. It fails if a part of the library has no figure.

mod blocks;
mod draw;

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (path, svg) in draw::all(root)? {
        let path = root.join(path);
        fs::create_dir_all(path.parent().unwrap_or(root))?;
        fs::write(path, svg)?;
    }
    draw::missing().map_or(Ok(()), |missing| Err(missing.into()))
}
