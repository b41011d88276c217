//! Libraries of a mechanism for other languages, built by cargo.

use std::env;
use std::error::Error;
use std::fmt;
use std::path::{Path, PathBuf};

use plm_foreign::fmi::{self, Exchanged, Version};
use plm_foreign::{Foreign, Names, declared};
use plm_view::package::{self, Output, Package, archive, renew};

use super::Library;

/// A library has the mechanism as declared: this parameter has no default.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct NoDefault(&'static str);

/// Reads like its `Display`, since a `main` that returns it shows this one.
impl fmt::Debug for NoDefault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for NoDefault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the parameter `{}` has no default, and a library needs one", self.0)
    }
}

impl Error for NoDefault {}

/// Writes a static library of a mechanism, its headers for C and C++, and what pkg-config and CMake read, into a folder; gives the
/// files, the library first. [`Library`] has more to choose.
///
/// cargo builds it in `target/plm/packages`. It has the mechanism as declared: what was set in this one is not in it.
///
/// # Errors
/// [`NoDefault`]; cargo is not there or fails, with what it says; a file cannot be written.
pub fn library<M: Foreign>(mechanism: &M, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    Library::new(M::TABLES.name).with(mechanism)?.write(folder)
}

/// Writes an FMU of a mechanism for FMI 3.0, model exchange and co-simulation; gives the file.
///
/// cargo builds it in `target/plm/packages`. It has the mechanism as declared: what was set in this one is not in it.
///
/// # Errors
/// As [`library`].
pub fn fmu<M: Exchanged>(mechanism: &M, file: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    fmu_of(Version::Three, mechanism, file)
}

/// As [`fmu`], for a version of FMI. The library in it has the functions of both, and is built once for them.
///
/// # Errors
/// As [`library`].
pub fn fmu_of<M: Exchanged>(
    version: Version,
    mechanism: &M,
    file: &Path,
) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let (name, mut text, mut code) = (Names::lower(M::TABLES.name).to_string(), String::new(), String::new());
    fmi::description(version, &declared(mechanism), &mut text)?;
    fmi::source::<M>(&mut code)?;
    let built = build::<M>(&name, &code)?;
    let binary = format!("binaries/{}/{name}{}", platform(version), env::consts::DLL_SUFFIX);
    let entries = [("modelDescription.xml".to_string(), text.into_bytes()), (binary, built)];
    renew(file, &archive(entries)?)?;
    Ok(vec![file.into()])
}

/// This machine as a version of FMI calls it: 2.0 (2.3) has names of its own for those of x86.
fn platform(version: Version) -> String {
    let system = match env::consts::OS {
        "macos" => "darwin",
        other => other,
    };
    match (version, env::consts::ARCH, system) {
        (Version::Two, "x86_64", "windows") => "win64".into(),
        (Version::Two, "x86", "windows") => "win32".into(),
        (Version::Two, "x86_64", system) => format!("{system}64"),
        (Version::Two, "x86", system) => format!("{system}32"),
        (_, machine, system) => format!("{machine}-{system}"),
    }
}

/// Has every parameter a default?
pub(super) fn complete<M: Foreign>() -> Result<(), NoDefault> {
    let missing = M::TABLES.parameters.iter().find(|parameter| parameter.default.is_none());
    missing.map_or(Ok(()), |parameter| Err(NoDefault(parameter.name)))
}

/// Builds a package of a mechanism.
fn build<M: Foreign>(name: &str, source: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    complete::<M>()?;
    let plm = &package::plm();
    let (output, files, features) = (Output::Shared, M::FILES, &["fmi"]);
    let package = Package { name, output, source, files, plm, features, bare: None };
    let folder = Path::new("target/plm/packages");
    if !folder.join("target/release").exists() {
        eprintln!("building plm and {name} in {}: the first FMU takes some minutes", folder.display());
    }
    Ok(package.build(&folder.join(format!("{name}-fmu")))?)
}
