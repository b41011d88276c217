//! Pictures of the pages on synthesis: a coupler curve through the points of an ellipse, Burmester's curves, shares of tolerances.
//!
//! ```console
//! cargo run --release --example synthesis    # to docs/src/images/synthesis
//! ```
//!
//! It prints the declaration of the linkage of the ellipse, which the playground opens.
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod figures;

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (path, svg) in figures::all()? {
        let path = root.join(path);
        fs::create_dir_all(path.parent().unwrap_or(root))?;
        fs::write(path, svg)?;
    }
    println!("{}", figures::declaration()?);
    Ok(())
}
