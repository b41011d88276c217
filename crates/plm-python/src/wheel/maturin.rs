//! A package as a wheel of Python, and as a source distribution for other machines. maturin packs both: it knows what each system
//! wants.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use plm_view::package::{Package, Unbuilt, command, renew};

/// Name and bytes of a file.
type Built = (String, Vec<u8>);
/// Further texts: name and contents.
type Texts = [(String, String)];

/// Folders of plm that are compiled for a package.
const FOLDERS: [&str; 7] = [
    "src",
    "plm-macros",
    "plm-runtime",
    "crates/plm-foreign",
    "crates/plm-python",
    "crates/plm-run",
    "crates/plm-studies",
];
const FILES: [&str; 4] = ["Cargo.toml", "README.md", "LICENSE-APACHE", "LICENSE-MIT"];
/// Packages of plm that no mechanism needs in Python, and the features that want them.
const PACKAGES_LEFT_OUT: [&str; 8] =
    ["plm-cli", "plm-draw", "plm-dynamic", "plm-import", "plm-jit", "plm-program", "plm-source", "plm-view"];
const FEATURES_LEFT_OUT: [&str; 7] = ["batch", "dynamic", "jit", "optimise", "synthesis", "view", "wheel"];
/// Folders in it that are not.
const LEFT_OUT: [&str; 9] =
    ["tests", "benches", "examples", "target", "python", "dynamic", "optimise", "study", "synthesis"];

/// Builds a wheel of a package and of further texts, name and contents, in a folder; gives its name and its bytes. No path of this
/// machine is in it.
///
/// # Errors
/// [`Unbuilt`]: maturin is not there, with the line that installs it, or fails, with what it and cargo say. Or a file
/// cannot be written or read.
pub(super) fn wheel(package: &Package<'_>, folder: &Path, texts: &Texts) -> Result<Built, Unbuilt> {
    try_wheel(package, folder, texts).map_err(|why| Unbuilt::new("wheel", why))
}

/// Makes a source distribution of a package, of further texts, and of what of plm it needs, in a folder; of the same versions of other
/// packages as were taken for the wheel in `built`. Gives its name and its bytes. pip builds it on other machines, by Rust.
///
/// # Errors
/// As [`wheel`].
pub(super) fn source_distribution(
    package: &Package<'_>,
    folder: &Path,
    built: &Path,
    texts: &Texts,
) -> Result<Built, Unbuilt> {
    try_source(package, folder, built, texts).map_err(|why| Unbuilt::new("source distribution", why))
}

fn try_wheel(package: &Package<'_>, folder: &Path, texts: &Texts) -> Result<Built, String> {
    package.write(folder).map_err(|error| error.to_string())?;
    write_all(folder, texts)?;
    let mut maturin = command("maturin".into());
    // Missing tools are reported first.
    maturin.arg("--version").output().map_err(|error| missing(&error))?;
    let mut maturin = command("maturin".into());
    maturin.args(["build", "--release", "--quiet", "--manifest-path"]).arg(folder.join("Cargo.toml"));
    maturin.arg("--target-dir").arg(folder.with_file_name("target"));
    let [target, flags] = without_paths(package, folder)?;
    maturin.args(["--target", &target, "--config", &flags]);
    made(maturin, &folder.join("wheels"))
}

fn try_source(package: &Package<'_>, folder: &Path, built: &Path, texts: &Texts) -> Result<Built, String> {
    // A file that is needed no more would be packed too.
    let _ = fs::remove_dir_all(folder);
    // Where plm comes from a registry its crates stand apart, and other machines get them from there too.
    let is_checkout = package.plm.join(FOLDERS[1]).is_dir();
    let (source, workspace) = if is_checkout {
        ("path = \"plm\"".to_owned(), "exclude = [\"plm\"]\n")
    } else {
        (format!("version = \"={}\"", env!("CARGO_PKG_VERSION")), "")
    };
    package.write_with(folder, &source, workspace).map_err(|error| error.to_string())?;
    write_all(folder, texts)?;
    copy(&built.join("Cargo.lock"), &folder.join("Cargo.lock"))?;
    if is_checkout {
        copy_plm(package.plm, &folder.join("plm"))?;
    }
    let mut maturin = command("maturin".into());
    maturin.args(["sdist", "--manifest-path"]).arg(folder.join("Cargo.toml"));
    made(maturin, &folder.join("dist"))
}

/// Copies what of plm a package needs.
fn copy_plm(from: &Path, to: &Path) -> Result<(), String> {
    for file in FILES {
        copy(&from.join(file), &to.join(file))?;
    }
    FOLDERS.iter().try_for_each(|below| copy_all(&from.join(below), &to.join(below)))
}

/// The target that is this machine, and flags by which rustc leaves the places of its sources out of what it compiles. They go
/// with a target that is named, so that the compiler of plm, which runs here, is shared with other packages.
fn without_paths(package: &Package<'_>, folder: &Path) -> Result<[String; 2], String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = command(rustc).args(["--print=host-tuple", "--print=sysroot"]).output();
    let output = output.map_err(|error| format!("rustc cannot be run: {error}"))?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let [host, sysroot] = said.lines().collect::<Vec<_>>()[..] else {
        return Err(format!("rustc does not tell its host: {}", String::from_utf8_lossy(&output.stderr)));
    };
    let folder = fs::canonicalize(folder).map_err(|error| unread(folder, &error))?;
    let own = [(PathBuf::from(sysroot), "rust"), (package.plm.to_owned(), "plm"), (folder, package.name)];
    let cargo = cargo_home().map(|home| (home, "cargo"));
    let flags = cargo.into_iter().chain(own).map(|(from, to)| {
        // A text of TOML as Rust writes it: backslashes are doubled.
        format!("{:?}", format!("--remap-path-prefix={}={to}", from.display()))
    });
    let flags: Vec<String> = flags.collect();
    Ok([host.to_owned(), format!("target.{host}.rustflags=[{}]", flags.join(", "))])
}

/// Folder in which cargo keeps sources.
fn cargo_home() -> Option<PathBuf> {
    let home = || std::env::var_os("HOME").or_else(|| std::env::var_os("USERPROFILE"));
    let named = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    named.or_else(|| home().map(|home| Path::new(&home).join(".cargo")))
}

/// Why maturin cannot be run.
fn missing(error: &std::io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "maturin is missing; this line installs it: pip install maturin".to_owned(),
        _ => format!("maturin cannot be run: {error}"),
    }
}

/// Name and bytes of the file that maturin writes to an empty folder of its own.
fn made(mut maturin: Command, folder: &Path) -> Result<Built, String> {
    // One of another version may lie there.
    let _ = fs::remove_dir_all(folder);
    let output = maturin.arg("--out").arg(folder).output().map_err(|error| missing(&error))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    let unread = |error| unread(folder, &error);
    let file = fs::read_dir(folder).map_err(unread)?.next().ok_or("maturin has written nothing")?;
    let file = file.map_err(unread)?;
    let bytes = fs::read(file.path()).map_err(unread)?;
    Ok((file.file_name().to_string_lossy().into_owned(), bytes))
}

/// A manifest of plm where nothing of it but what a mechanism needs is there.
fn alone(manifest: &str) -> String {
    let (mut text, mut table) = (String::new(), "");
    let is_of =
        |line: &str, names: &[&str]| line.split_once(" = ").is_some_and(|(name, _)| names.contains(&name));
    for line in manifest.lines() {
        if line.starts_with('[') {
            table = line.trim();
        }
        if table == "[features]" && is_of(line, &FEATURES_LEFT_OUT) {
            // The name stays, since sources ask for it.
            text.extend(line.split_once(" = ").map(|(name, _)| format!("{name} = []\n")));
            continue;
        }
        let is_left_out = match table {
            "[workspace]" => !(line.starts_with('[') || line.starts_with("resolver")),
            "[dev-dependencies]" => true,
            "[features]" => false,
            table => {
                let is_table_left_out = table.starts_with("[[") || table.starts_with("[profile");
                is_table_left_out || is_of(line, &PACKAGES_LEFT_OUT)
            }
        };
        if !is_left_out {
            text.push_str(line);
            text.push('\n');
        }
    }
    text
}

fn write_all(folder: &Path, texts: &Texts) -> Result<(), String> {
    for (name, text) in texts {
        renew(&folder.join(name), text.as_bytes()).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Copies a file; of a manifest what is alone.
fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let mut bytes = fs::read(from).map_err(|error| unread(from, &error))?;
    if from.ends_with("Cargo.toml") {
        bytes = alone(&String::from_utf8_lossy(&bytes)).into_bytes();
    }
    renew(to, &bytes).map_err(|error| error.to_string())
}

/// Copies a folder of sources.
fn copy_all(from: &Path, to: &Path) -> Result<(), String> {
    for entry in fs::read_dir(from).map_err(|error| unread(from, &error))? {
        let entry = entry.map_err(|error| unread(from, &error))?;
        let (name, path) = (entry.file_name(), entry.path());
        if !path.is_dir() {
            copy(&path, &to.join(&name))?;
        } else if !LEFT_OUT.iter().any(|left_out| name == *left_out) {
            copy_all(&path, &to.join(&name))?;
        }
    }
    Ok(())
}

fn unread(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    use super::{FOLDERS, PACKAGES_LEFT_OUT, alone};

    /// The folder of the workspace.
    fn root() -> &'static Path {
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
    }

    #[test]
    fn every_package_of_plm_is_copied_or_left_out() {
        let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
        let members = manifest.lines().filter_map(|line| line.trim().strip_prefix('"')?.strip_suffix("\","));
        // Those of folders that are copied as a whole are copied with them.
        let names = members.map(|member| member.strip_prefix("crates/").unwrap_or(member));
        let packages: BTreeSet<&str> =
            names.filter(|member| !member.contains(['/', '.']) && *member != "xtask").collect();
        let copied = FOLDERS.iter().map(|folder| folder.strip_prefix("crates/").unwrap_or(folder));
        let known: BTreeSet<&str> = copied.chain(PACKAGES_LEFT_OUT).filter(|name| *name != "src").collect();
        assert!(packages.len() > 4);
        assert_eq!(packages, known);
    }

    #[test]
    fn features_that_want_what_is_left_out_are_left_out() {
        let own = alone(&fs::read_to_string(root().join("Cargo.toml")).unwrap());
        for package in PACKAGES_LEFT_OUT {
            assert!(!own.contains(&format!("\"dep:{package}\"")), "{package} is asked for by a feature");
        }
    }

    #[test]
    fn a_manifest_names_nothing_that_is_left_out() {
        let manifest = concat!(
            "[workspace]\nresolver = \"3\"\nmembers = [\n    \".\",\n]\n\n",
            "[workspace.dependencies]\nplm-math = { path = \"m\" }\nplm-jit = { path = \"j\" }\nplm-view = { path = \"plm-view\" }\n\n",
            "[features]\nstd = []\nbatch = [\"dep:plm-studies\"]\nview = [\"dep:plm-view\"]\nfmi = []\n\n[dev-dependencies]\nserde_json = \"1\"\n\n",
            "[[test]]\nname = \"lanes\"\n\n[lints]\nworkspace = true\n\n[profile.release]\ndebug = true\n",
        );
        let known = concat!(
            "[workspace]\nresolver = \"3\"\n",
            "[workspace.dependencies]\nplm-math = { path = \"m\" }\n\n",
            "[features]\nstd = []\nbatch = []\nview = []\nfmi = []\n\n",
            "[lints]\nworkspace = true\n\n",
        );
        assert_eq!(alone(manifest), known);
    }
}
