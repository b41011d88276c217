//! A package that is written beside the caller's, and built by cargo: a mechanism in another form.
//!
//! It stands in a folder of the caller's and is built again only where something changed.

mod sealed;

use std::ffi::OsString;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub use self::sealed::Linkage;

use crate::error::{Error, write_file};

/// Kind of output that cargo builds from a package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// A module of WebAssembly, small.
    Module,
    /// A static library of this machine, fast, and a shared one beside it ([`Package::build_library`]): both are of the same code.
    Static,
    /// A shared library of this machine, fast.
    Shared,
    /// The part of a wheel that is not Python: `plm_python` builds it.
    Extension,
}

/// A package.
#[derive(Clone, Debug)]
pub struct Package<'a> {
    /// Its name, in letters, digits, `_` and `-`.
    pub name: &'a str,
    /// Kind of its output.
    pub output: Output,
    /// Its library.
    pub source: &'a str,
    /// Files that the source names, and where they are.
    pub files: &'a [(&'a str, &'a str)],
    /// The folder of the package `plm-planar`.
    pub plm: &'a Path,
    /// Its features that the source needs.
    pub features: &'a [&'a str],
    /// The target without an operating system that it is for, if it is for one, as rustc calls it: without std.
    pub bare: Option<&'a str>,
}

/// Reason why something was not built.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct Unbuilt {
    what: &'static str,
    why: String,
}

impl Unbuilt {
    /// An error: what was not built, and why.
    pub fn new(what: &'static str, why: String) -> Self {
        Self { what, why }
    }
}

impl fmt::Debug for Unbuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Unbuilt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the {} cannot be built: {}", self.what, self.why)
    }
}

impl std::error::Error for Unbuilt {}

impl Output {
    fn what(self) -> &'static str {
        match self {
            Self::Module => "live module",
            Self::Static => "static library",
            Self::Shared => "shared library",
            Self::Extension => "wheel",
        }
    }

    /// Its kind in a manifest, the level of optimisation, and the symbols that are stripped.
    fn manifest(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Module => ("cdylib", "\"s\"", "true"),
            // Of a static library the linker needs the symbols.
            Self::Static => ("staticlib\", \"cdylib", "3", "\"debuginfo\""),
            Self::Shared | Self::Extension => ("cdylib", "3", "true"),
        }
    }

    /// The target for which it is built; this machine where none is named.
    fn target(self) -> Option<&'static str> {
        (self == Self::Module).then_some("wasm32-unknown-unknown")
    }

    /// Option of the linker that sets the name by which programs look for a shared library; without it that is the path of the build.
    fn soname(self, name: &str) -> Vec<String> {
        let file = Self::Shared.file(name);
        let word = match (self, std::env::consts::OS) {
            (Self::Static | Self::Shared, "linux") => format!("-Wl,-soname,{file}"),
            (Self::Static | Self::Shared, "macos") => format!("-Wl,-install_name,@rpath/{file}"),
            _ => return Vec::new(),
        };
        ["--".to_owned(), "-C".to_owned(), format!("link-arg={word}")].into()
    }

    /// The name of the file that cargo writes.
    fn file(self, name: &str) -> String {
        use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
        let name = name.replace('-', "_");
        match self {
            Self::Module => format!("{name}.wasm"),
            Self::Static if cfg!(target_env = "msvc") => format!("{name}.lib"),
            Self::Static => format!("lib{name}.a"),
            Self::Shared | Self::Extension => format!("{DLL_PREFIX}{name}{DLL_SUFFIX}"),
        }
    }
}

impl Package<'_> {
    /// Builds it in a folder and gives the bytes of what cargo made. What several packages need is built once, in the folder
    /// `target` beside theirs.
    ///
    /// # Errors
    /// [`Unbuilt`]: cargo is not there or fails, with what it says; where a target is missing, with the line that installs
    /// it. Or a file cannot be written or read.
    pub fn build(&self, folder: &Path) -> Result<Vec<u8>, Unbuilt> {
        self.try_build(folder).map_err(|why| Unbuilt { what: self.output.what(), why })
    }

    fn try_build(&self, folder: &Path) -> Result<Vec<u8>, String> {
        self.write(folder).map_err(|error| error.to_string())?;
        let (own, target) = (folder.with_file_name("target"), self.bare.or(self.output.target()));
        let mut cargo = command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["rustc", "--release", "--quiet", "--manifest-path"]).arg(folder.join("Cargo.toml"));
        cargo.arg("--target-dir").arg(&own);
        cargo.args(target.iter().flat_map(|target| ["--target", target]));
        cargo.args(self.bare.map_or_else(|| self.output.soname(self.name), |_| Vec::new()));
        let output = cargo.output().map_err(|error| format!("cargo cannot be run: {error}"))?;
        if !output.status.success() {
            return Err(explained(&String::from_utf8_lossy(&output.stderr), target));
        }
        let below: PathBuf = target.into_iter().chain(["release"]).collect();
        let path = own.join(below).join(self.output.file(self.name));
        fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// Writes it; an unchanged file keeps its time.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
        self.write_with(folder, &format!("path = {:?}", self.plm.display().to_string()), "")
    }

    /// Writes it with what its manifest says of where plm is, a path or a version, and further lines of its workspace.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write_with(
        &self,
        folder: &Path,
        plm: &str,
        workspace: &str,
    ) -> Result<(), Box<dyn std::error::Error>> {
        let (kind, level, strip) = self.output.manifest();
        let kind = if self.bare.is_some() { "staticlib" } else { kind };
        let features = self.features;
        let (version, library, panic, further) = match self.output {
            // A panic becomes an exception.
            Output::Extension => (version(), "name = \"_native\"\n", "unwind", PYO3),
            _ => ("0.0.0".to_owned(), "", "abort", ""),
        };
        let has_std = self.bare.is_none();
        // The compiler of plm is stripped in none, so that all in a folder share it.
        let manifest = format!(
            "[package]\nname = \"{}\"\nversion = \"{version}\"\nedition = \"2024\"\n\n\
             [lib]\n{library}crate-type = [\"{kind}\"]\n\n\
             [profile.release]\nopt-level = {level}\nlto = true\ncodegen-units = 1\npanic = \"{panic}\"\nstrip = {strip}\n\n\
             [profile.release.build-override]\nstrip = false\n\n\
             [workspace]\n{workspace}\n[dependencies]\n\
             plm = {{ package = \"plm-planar\", {plm}, default-features = {has_std}, \
             features = {features:?} }}\n{further}",
            self.name
        );
        renew(&folder.join("Cargo.toml"), manifest.as_bytes())?;
        renew(&folder.join("src/lib.rs"), self.source.as_bytes())?;
        for (name, path) in self.files {
            let bytes = fs::read(path).map_err(|error| format!("{path}: {error}"))?;
            renew(&folder.join(name), &bytes)?;
        }
        Ok(())
    }
}

/// Dependency of a wheel beside plm: one wheel for all versions of Python from 3.9.
const PYO3: &str = "pyo3 = { version = \"0.30\", features = [\"abi3-py39\"] }\n";

/// The version of the package that cargo runs.
#[must_use]
pub fn version() -> String {
    std::env::var("CARGO_PKG_VERSION").unwrap_or_else(|_| "0.0.0".to_owned())
}

/// The folder of the package `plm-planar`: above the folder of this one in a checkout, beside it where cargo keeps sources of a registry.
pub fn plm() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = own.parent().unwrap_or(own);
    let beside =
        [concat!("plm-planar-", env!("CARGO_PKG_VERSION")), "plm-planar"].map(|name| crates.join(name));
    let found = beside.into_iter().find(|folder| folder.join("Cargo.toml").exists());
    found.unwrap_or_else(|| crates.parent().unwrap_or(crates).to_owned())
}

/// A program of a build; settings of the caller's own build are removed.
pub fn command(program: OsString) -> Command {
    let mut command = Command::new(program);
    for variable in [
        "RUSTFLAGS",
        "CARGO_ENCODED_RUSTFLAGS",
        "RUSTC_WORKSPACE_WRAPPER",
        "CARGO_BUILD_TARGET",
        "CARGO_MANIFEST_DIR",
    ] {
        command.env_remove(variable);
    }
    command
}

/// Writes a file unless it holds that already, with the folders above it.
///
/// # Errors
/// When it cannot be written.
pub fn renew(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    if fs::read(path).is_ok_and(|present| present == bytes) {
        return Ok(());
    }
    write_file(path, Ok(bytes.to_vec()))
}

/// A zip of these entries, name and contents, in their order.
///
/// # Errors
/// When an entry is too large for a zip.
pub fn archive(entries: impl IntoIterator<Item = (String, Vec<u8>)>) -> std::io::Result<Vec<u8>> {
    crate::results::zipped(entries)
}

/// Messages of cargo, or how to install a missing target.
fn explained(said: &str, target: Option<&str>) -> String {
    let missing = said.contains("can't find crate for `core`") || said.contains("can't find crate for `std`");
    match target.filter(|_| missing) {
        Some(target) => {
            format!("the target is not installed; this line installs it: rustup target add {target}")
        }
        None => said.trim().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::explained;

    #[test]
    fn a_missing_target_is_told_with_the_line_that_installs_it() {
        let target = Some("wasm32-unknown-unknown");
        let said = "error[E0463]: can't find crate for `core`\n  = note: the `wasm32-unknown-unknown` target may not be installed";
        assert!(explained(said, target).ends_with("rustup target add wasm32-unknown-unknown"));
        assert_eq!(explained("error: something else\n", target), "error: something else");
    }
}
