//! A mechanism as WebAssembly: its declaration in a crate of its own, which cargo builds.
//!
//! The crate stands in a folder of the caller's and is built again only where something changed. What it exports are
//! functions of numbers; `shim.rs.txt` lists them.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::error::write_file;

/// The target for which a module is built.
const TARGET: &str = "wasm32-unknown-unknown";
/// The functions that a module exports, for a mechanism called `NAME`.
const SHIM: &str = include_str!("shim.rs.txt");

/// What a module is made of.
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

/// Why there is no module, in words.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct Unbuilt(String);

impl fmt::Debug for Unbuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Unbuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the live module cannot be built: {}", self.0)
    }
}

impl std::error::Error for Unbuilt {}

impl Module<'_> {
    /// Builds the module in a folder and gives its bytes.
    ///
    /// # Errors
    /// [`Unbuilt`]: cargo is not there or fails, with what it says; where the target is missing, with the line that installs
    /// it. Or a file cannot be written or read.
    pub fn build(&self, folder: impl AsRef<Path>) -> Result<Vec<u8>, Unbuilt> {
        let folder = folder.as_ref();
        self.write(folder)?;
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--release", "--quiet", "--target", TARGET, "--manifest-path"]);
        cargo.arg(folder.join("Cargo.toml")).arg("--target-dir").arg(folder.join("target"));
        // What the caller's own build was told is not for this one.
        for variable in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_TARGET", "CARGO_MANIFEST_DIR"] {
            cargo.env_remove(variable);
        }
        let output = cargo.output().map_err(|error| Unbuilt(format!("cargo cannot be run: {error}")))?;
        if !output.status.success() {
            return Err(Unbuilt(explained(&String::from_utf8_lossy(&output.stderr))));
        }
        let module: PathBuf = [TARGET, "release", "plm_live.wasm"].iter().collect();
        let path = folder.join("target").join(module);
        fs::read(&path).map_err(|error| Unbuilt(format!("{}: {error}", path.display())))
    }

    /// Writes the crate; what is as it was keeps its time.
    fn write(&self, folder: &Path) -> Result<(), Unbuilt> {
        let plm = self.plm.display().to_string();
        let manifest = format!(
            "[package]\nname = \"plm-live\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[lib]\ncrate-type = [\"cdylib\"]\n\n\
             [dependencies]\nplm = {{ package = \"plm-planar\", path = {plm:?} }}\n\n\
             [profile.release]\nopt-level = \"s\"\nlto = true\ncodegen-units = 1\npanic = \"abort\"\nstrip = true\n\n[workspace]\n"
        );
        let source =
            format!("plm::mechanism! {{\n{}\n}}\n{}", self.declaration, SHIM.replace("NAME", self.name));
        renew(&folder.join("Cargo.toml"), manifest.as_bytes())?;
        renew(&folder.join("src/lib.rs"), source.as_bytes())?;
        for (name, path) in self.files {
            let bytes = fs::read(path).map_err(|error| Unbuilt(format!("{path}: {error}")))?;
            renew(&folder.join(name), &bytes)?;
        }
        Ok(())
    }
}

/// Writes a file unless it holds that already.
fn renew(path: &Path, bytes: &[u8]) -> Result<(), Unbuilt> {
    if fs::read(path).is_ok_and(|present| present == bytes) {
        return Ok(());
    }
    write_file(path, Ok(bytes.to_vec())).map_err(|error| Unbuilt(error.to_string()))
}

/// What cargo said, and what to do where the target is missing.
fn explained(said: &str) -> String {
    if said.contains("can't find crate for `core`") || said.contains("can't find crate for `std`") {
        return format!("the target is not installed; this line installs it: rustup target add {TARGET}");
    }
    said.trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::explained;

    #[test]
    fn a_missing_target_is_told_with_the_line_that_installs_it() {
        let said = "error[E0463]: can't find crate for `core`\n  = note: the `wasm32-unknown-unknown` target may not be installed";
        assert!(explained(said).ends_with("rustup target add wasm32-unknown-unknown"));
        assert_eq!(explained("error: something else\n"), "error: something else");
    }
}
