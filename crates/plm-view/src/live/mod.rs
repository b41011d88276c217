//! A mechanism as WebAssembly: its declaration in a crate of its own, which cargo builds.
//!
//! The crate stands in a folder of the caller's and is built again only where something changed. What it exports are
//! functions of numbers; `shim.rs.txt` lists them.

use std::path::Path;

pub use crate::package::Unbuilt;
use crate::package::{Output, Package};

/// The functions that a module exports, for a mechanism called `NAME`.
const SHIM: &str = include_str!("shim.rs.txt");

/// Sources of a module.
#[derive(Clone, Debug)]
pub struct Module<'a> {
    /// Name of the mechanism's type.
    pub name: &'a str,
    /// Its declaration in the language of `mechanism!`.
    pub declaration: &'a str,
    /// Files that it names, and where they are.
    pub files: &'a [(&'a str, &'a str)],
    /// The folder of the package `plm-planar`.
    pub plm: &'a Path,
}

impl Module<'_> {
    /// Builds the module in a folder and gives its bytes.
    ///
    /// # Errors
    /// [`Unbuilt`]: cargo is not there or fails, with what it says; where the target is missing, with the line that installs
    /// it. Or a file cannot be written or read.
    pub fn build(&self, folder: impl AsRef<Path>) -> Result<Vec<u8>, Unbuilt> {
        let source =
            format!("plm::mechanism! {{\n{}\n}}\n{}", self.declaration, SHIM.replace("NAME", self.name));
        let package = Package {
            name: "plm-live",
            output: Output::Module,
            source: &source,
            files: self.files,
            plm: self.plm,
            features: &[],
            bare: None,
        };
        package.build(folder.as_ref())
    }
}
