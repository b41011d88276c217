//! Packages as the registry would have them: what they hold, and a user's first program built of them in an empty folder.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::Result;
use crate::place::{Place, Task};

/// The largest file that a package may hold, in bytes.
const LARGEST: u64 = 200_000;
/// Files that every package must hold, besides its README.
const FILES: [&str; 3] = ["Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT"];
/// The package that users name.
const PLM: &str = "plm-planar";
/// Output of the program in its README: the same bits on every machine.
const PRINTED: &str = "0.761883 rad, [-45.60926972753451, -79.02384099541798] N";

/// A declaration of which `plm export` makes a whole program, which has options.
const PENDULUM: &str = "\
pub Pendulum {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
    revolute hinge(ground.o, bob.pivot);
}
";

/// A folder outside the repository, where cargo finds no workspace and no settings of ours; it goes with this value.
struct Empty(PathBuf);

impl Empty {
    fn new() -> Result<Self> {
        let folder = std::env::temp_dir().join(format!("plm-packages-{}", std::process::id()));
        fs::create_dir_all(&folder).map_err(|why| format!("{}: {why}", folder.display()))?;
        Ok(Self(folder))
    }
}

impl Drop for Empty {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A package, unpacked.
struct Package {
    name: String,
    folder: PathBuf,
}

/// Packs all crates that are published, looks at what they hold, and runs the program of the README in an empty folder.
pub(super) fn all(place: &Place) -> Result {
    let empty = Empty::new()?;
    let packages = packed(place, &empty.0)?;
    let mut wrong = Vec::new();
    for package in &packages {
        wrong.extend(faults(package)?);
    }
    if !wrong.is_empty() {
        return Err(format!("packages that cannot be published:\n{}", wrong.join("\n")));
    }
    let printed = readme(place, &empty.0, &packages)?.text()?;
    if printed.trim_end() != PRINTED {
        return Err(format!("the program of the README prints\n{printed}\nand not\n{PRINTED}"));
    }
    place.say(&format!("{} packages; the program of the README runs in an empty folder", packages.len()))
}

/// The program of `plm export`, and packages that it builds beside itself, of what the registry would have: a library for C, and a page
/// that is live.
pub(super) fn programs(place: &Place) -> Result {
    let empty = Empty::new()?;
    settings(&empty.0, &packed(place, &empty.0)?)?;
    let (file, folder) = (empty.0.join("pendulum.plm"), empty.0.join("user"));
    fs::write(&file, PENDULUM).map_err(|why| format!("{}: {why}", file.display()))?;
    place.command("cargo run --quiet -p plm-cli -- export").arg(&file).arg("--rust").arg(&folder).run()?;
    let options: [&[&str]; 3] = [&["--until", "1"], &["--c", "library"], &["--view", "live.html", "--live"]];
    for options in options {
        let run = place.command("cargo run --quiet --target-dir").arg(place.target.join("packages/user"));
        run.in_folder(&folder.to_string_lossy()).arg("--").args(options).run()?;
    }
    Ok(())
}

/// Members of the workspace that are never published.
fn unpublished(place: &Place) -> Result<Vec<String>> {
    let text = place.command("cargo metadata --no-deps --format-version 1").text()?;
    let metadata: Value = serde_json::from_str(&text).map_err(|why| format!("cargo metadata: {why}"))?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
    // No registry is allowed.
    let never = packages.iter().filter(|package| package["publish"] == json!([]));
    Ok(never.filter_map(|package| Some(package["name"].as_str()?.to_owned())).collect())
}

/// Packages of all crates that are published, unpacked in a folder.
fn packed(place: &Place, folder: &Path) -> Result<Vec<Package>> {
    let target = place.target.join("packages");
    let pack = place.command("cargo package --workspace --no-verify --allow-dirty --target-dir").arg(&target);
    let unpublished = unpublished(place)?;
    pack.args(unpublished.iter().flat_map(|name| ["--exclude", name.as_str()])).run()?;
    let version = version(&place.root)?;
    let packages = target.join("package");
    let failed = |why: std::io::Error| format!("{}: {why}", packages.display());
    let mut unpacked = Vec::new();
    for entry in fs::read_dir(&packages).map_err(failed)? {
        let file = entry.map_err(failed)?.path();
        let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        // Of other versions there may be packages from before.
        if let Some(name) = name.strip_suffix(&format!("-{version}.crate")) {
            place.command("tar -xzf").arg(&file).arg("-C").arg(folder).run()?;
            unpacked
                .push(Package { name: name.to_owned(), folder: folder.join(format!("{name}-{version}")) });
        }
    }
    unpacked.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(unpacked)
}

/// The version of all packages.
fn version(root: &Path) -> Result<String> {
    let manifest = read(&root.join("Cargo.toml"))?;
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'));
    version.map(str::to_owned).ok_or_else(|| "Cargo.toml has no version".to_owned())
}

/// Faults of a package: files that are missing, and files that are too large.
fn faults(package: &Package) -> Result<Vec<String>> {
    let readme = if package.name == PLM { "src/README.md" } else { "README.md" };
    let missing = FILES.into_iter().chain([readme]).filter(|file| !package.folder.join(file).is_file());
    let mut faults: Vec<String> = missing.map(|file| format!("{} has no {file}", package.name)).collect();
    let mut folders = vec![package.folder.clone()];
    while let Some(folder) = folders.pop() {
        let failed = |why: std::io::Error| format!("{}: {why}", folder.display());
        for entry in fs::read_dir(&folder).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            let known = entry.metadata().map_err(failed)?;
            if known.is_dir() {
                folders.push(entry.path());
            } else if known.len() > LARGEST {
                faults.push(format!("{}: {} bytes", entry.path().display(), known.len()));
            }
        }
    }
    Ok(faults)
}

/// The program that the README of the package shows.
fn readme<'a>(place: &'a Place, empty: &Path, packages: &[Package]) -> Result<Task<'a>> {
    let package = packages.iter().find(|package| package.name == PLM).ok_or("plm-planar was not packed")?;
    let readme = read(&package.folder.join("src/README.md"))?;
    let code = readme.split_once("```rust\n").and_then(|(_, code)| code.split_once("```"));
    let (code, _) = code.ok_or("the README of plm-planar has no Rust code")?;
    program(place, empty, packages, code)
}

/// `cargo run` for a program in a folder of its own, whose manifest is a user's.
fn program<'a>(place: &'a Place, empty: &Path, packages: &[Package], main: &str) -> Result<Task<'a>> {
    let folder = empty.join("user");
    let version = version(&place.root)?;
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[dependencies]\n{PLM} = \"{version}\"\n"
    );
    let write = |file: &str, text: &str| {
        fs::write(folder.join(file), text).map_err(|why| format!("{file} in {}: {why}", folder.display()))
    };
    fs::create_dir_all(folder.join("src")).map_err(|why| format!("{}: {why}", folder.display()))?;
    write("Cargo.toml", &manifest)?;
    write("src/main.rs", main)?;
    settings(empty, packages)?;
    let run = place.command("cargo run --quiet --target-dir").arg(place.target.join("packages/user"));
    // A path that is absolute is not looked for in the repository.
    Ok(run.in_folder(&folder.to_string_lossy()))
}

/// Settings of cargo above the user's folder, so that what a program builds beside itself has them too: the packages stand for
/// those of the registry.
fn settings(empty: &Path, packages: &[Package]) -> Result {
    let mut settings = "[patch.crates-io]\n".to_owned();
    for package in packages {
        let source = package.folder.to_string_lossy().replace('\\', "/");
        settings.extend([&package.name, " = { path = \"", &source, "\" }\n"]);
    }
    let folder = empty.join(".cargo");
    let failed = |why: std::io::Error| format!("{}: {why}", folder.display());
    fs::create_dir_all(&folder).map_err(failed)?;
    fs::write(folder.join("config.toml"), settings).map_err(failed)
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}
