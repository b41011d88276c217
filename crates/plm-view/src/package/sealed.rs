//! A static library that is one object, which exports nothing but its own functions.
//!
//! A static library of Rust contains Rust's library, whose names collide with those in another supplier's library (`rust_eh_personality` is
//! defined twice). Linkers of ELF combine all into one object, and objcopy makes the other names local. Other systems keep the output of
//! Rust: there a shared library has the same effect.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use super::{Output, Package, Unbuilt, command};

/// Are libraries of this machine ELF?
const IS_ELF: bool = cfg!(all(unix, not(target_vendor = "apple")));

/// How a program has a library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linkage {
    /// In itself.
    Static,
    /// Beside it.
    Shared,
}

impl Package<'_> {
    /// As [`build`](Self::build), of [`Output::Static`]: the library of a linkage, of which nothing is seen but what begins with one
    /// of `prefixes` and a `_`. Each has a function `size`. For machines without an operating system it is as Rust makes it.
    ///
    /// # Errors
    /// As [`build`](Self::build); cc, objcopy or ar are not there or fail, with what they say.
    pub fn build_library(
        &self,
        folder: &Path,
        linkage: Linkage,
        prefixes: &[&str],
    ) -> Result<Vec<u8>, Unbuilt> {
        let built = self.build(folder)?;
        let library = match (self.bare, linkage) {
            (None, Linkage::Shared) => {
                let path = folder.with_file_name("target/release").join(Output::Shared.file(self.name));
                fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
            }
            (None, Linkage::Static) if IS_ELF => sealed(&folder.join("sealed"), &built, prefixes),
            _ => Ok(built),
        };
        library.map_err(|why| Unbuilt { what: self.output.what(), why })
    }
}

fn sealed(folder: &Path, built: &[u8], prefixes: &[&str]) -> Result<Vec<u8>, String> {
    let told = |error: std::io::Error| format!("{}: {error}", folder.display());
    // What another build has left would be put together with this.
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).map_err(told)?;
    fs::write(folder.join("all.a"), built).map_err(told)?;
    let mut link: Vec<String> = ["-r", "-nostdlib", "-o", "one.o", "all.a"].map(str::to_owned).into();
    link.extend(prefixes.iter().map(|prefix| format!("-Wl,-u,{prefix}_size")));
    // The linker takes groups that two libraries have in common once, but each object's own names are local then.
    let groups = ["-Wl,--force-group-allocation".to_owned()];
    run("CC", "cc", folder, link.iter().chain(&groups)).or_else(|_| run("CC", "cc", folder, &link))?;
    let mut hide = vec!["--wildcard".to_owned()];
    hide.extend(prefixes.iter().map(|prefix| format!("--keep-global-symbol={prefix}_*")));
    hide.extend(["one.o", "sealed.o"].map(str::to_owned));
    run("OBJCOPY", "objcopy", folder, &hide)?;
    // Neither times nor users, so that the same library has the same bytes.
    run("AR", "ar", folder, &["rcsD", "sealed.a", "sealed.o"].map(str::to_owned))?;
    fs::read(folder.join("sealed.a")).map_err(told)
}

/// Runs a tool, or that of a variable, in a folder.
fn run<'a>(
    variable: &str,
    tool: &str,
    folder: &Path,
    words: impl IntoIterator<Item = &'a String>,
) -> Result<(), String> {
    let own = std::env::var_os(variable).unwrap_or_else(|| tool.into());
    let output = command(own).args(words).current_dir(folder).output();
    let output = output.map_err(|error| match error.kind() {
        ErrorKind::NotFound => format!(
            "{tool} is missing, which hides what two libraries of Rust have in common; it belongs to binutils ({variable} names another one)"
        ),
        _ => format!("{tool} cannot be run: {error}"),
    })?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("{tool}: {}", String::from_utf8_lossy(&output.stderr).trim()))
}
