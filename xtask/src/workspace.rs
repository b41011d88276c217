//! The crates of the workspace, by their manifests.

use std::fs;
use std::path::Path;

/// A crate of the workspace.
pub(crate) struct Package {
    /// Its name in its manifest.
    pub(crate) name: String,
    /// Its folder, from the root.
    pub(crate) folder: String,
}

/// The crates of the workspace, in the order of the manifest at the root; those of tests are left out.
///
/// # Errors
/// A manifest that cannot be read, or that has no name.
pub(crate) fn packages(root: &Path) -> Result<Vec<Package>, String> {
    let members = members(root)?.into_iter();
    Ok(members.filter(|package| !package.folder.starts_with("tests/")).collect())
}

/// All members that the manifest at the root lists.
///
/// # Errors
/// As [`packages`].
pub(crate) fn members(root: &Path) -> Result<Vec<Package>, String> {
    let workspace = read(&root.join("Cargo.toml"))?;
    let members = workspace.split_once("members = [").and_then(|(_, rest)| rest.split_once(']'));
    let (members, _) = members.ok_or("Cargo.toml has no list of members")?;
    members.split('"').skip(1).step_by(2).map(|folder| package(root, folder)).collect()
}

fn package(root: &Path, folder: &str) -> Result<Package, String> {
    let manifest = read(&root.join(folder).join("Cargo.toml"))?;
    let name = manifest.lines().find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'));
    let name = name.ok_or_else(|| format!("{folder}/Cargo.toml has no name"))?.to_owned();
    Ok(Package { name, folder: folder.to_owned() })
}

/// A file's text, with its path in the error.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}
