//! A release: what must hold of its tag, the files that it has, their sizes and checksums, and the crates in their order.
//!
//! A workflow calls these steps, and anybody can: with `--dry-run` nothing is uploaded, and what a person has yet to fill in is told
//! without ending the step.

use std::fs;
use std::path::{Path, PathBuf};

use crate::Result;
use crate::place::Place;
use crate::workspace;

/// The address at which the pages of a release are hosted, the book with the playground in it, without a slash at the end; a release fails
/// while it is empty.
const ADDRESS: &str = "";

/// The folder of the files of a release, below that of cargo.
const FOLDER: &str = "release-files";
/// The list of these files with sizes and checksums, which a release shows.
const NOTES: &str = "release-files.md";
/// The profile of `plm`: without symbols.
const PROFILE: &str = "dist";
/// Targets of `plm` that a Linux of x86-64 can link, and their linkers; the workflow has one on its own system for each.
const TARGETS: [(&str, &str); 2] =
    [("x86_64-unknown-linux-musl", "cc"), ("x86_64-pc-windows-gnu", "x86_64-w64-mingw32-gcc")];
/// The declaration of the examples in a release.
const EXAMPLE: &str = "examples/playground/four_bar.plm";
/// The most that a file may have, by the beginning and the end of its name, bytes.
const MOST: [(&str, &str, u64); 4] = [
    ("plm-", ".gz", 25_000_000),
    ("playground", ".html", 1_400_000),
    ("plm_planar-", ".whl", 12_000_000),
    ("plm-mechanism-", ".tgz", 2_000_000),
];

const USAGE: &str = "\
cargo xtask release check TAG        version, changelog and address are those of a release
cargo xtask release binary TARGET    `plm` for a target of rustc, without symbols
cargo xtask release wheel            the wheel, tried in three Pythons; options of maturin in place of manylinux2014
cargo xtask release page             the playground as one file
cargo xtask release book             the book
cargo xtask release examples         C source with its header, FMUs, and a package that makes one with a binary, of the four-bar
cargo xtask release npm              the package of `<plm-mechanism>`, tried in a browser
cargo xtask release npm publish      that package, to the registry
cargo xtask release try              the files on an empty Debian without Rust (root, debootstrap), and by Wine
cargo xtask release sums             sizes and checksums of all files, within their limits
cargo xtask release crates           the crates, in their order, to the registry
cargo xtask release all TAG          all of this that can be done on this machine; with --dry-run alone
each with --dry-run";

pub(crate) fn run(place: &Place, words: &[String]) -> Result {
    let is_dry = words.iter().any(|word| word == "--dry-run");
    let words: Vec<&str> = words.iter().map(String::as_str).filter(|word| *word != "--dry-run").collect();
    let folder = place.target.join(FOLDER);
    fs::create_dir_all(&folder).map_err(|why| format!("{}: {why}", folder.display()))?;
    match words.as_slice() {
        ["check", tag] => check(place, tag, is_dry),
        ["binary", target] => binary(place, target, &folder),
        ["wheel", options @ ..] => place.command("bash tests/wheels.sh").arg(&folder).args(options).run(),
        ["page"] => page(place, &folder),
        ["book"] => book(place, &folder),
        ["examples"] => examples(place, &folder),
        ["npm"] => npm(place, &folder),
        ["npm", "publish"] => publish_npm(place, &folder, is_dry),
        ["try", parts @ ..] => tried(place, &folder, parts),
        ["sums"] => sums(place, &folder),
        ["crates"] => crates(place, is_dry),
        ["all", tag] if is_dry => all(place, tag),
        _ => Err(format!("these are the steps of a release:\n{USAGE}")),
    }
}

/// Is all there that a release of this tag needs?
fn check(place: &Place, tag: &str, is_dry: bool) -> Result {
    let version = version(&place.root)?;
    let mut wrong = Vec::new();
    if tag != format!("v{version}") {
        wrong.push(format!("the tag {tag} is not that of the version {version} in Cargo.toml"));
    }
    let changelog = workspace::read(&place.root.join("CHANGELOG.md"))?;
    let heading = changelog.lines().find(|line| line.starts_with(&format!("## [{version}] - ")));
    let is_dated =
        heading.is_some_and(|line| line.chars().rev().take(10).all(|c| c.is_ascii_digit() || c == '-'));
    if !is_dated {
        wrong.push(format!("CHANGELOG.md has no heading of {version} with a date"));
    }
    if ADDRESS.is_empty() {
        wrong.push("xtask/src/release.rs has no address of hosted pages".to_owned());
    }
    let manifest = workspace::read(&place.root.join("Cargo.toml"))?;
    let repository = in_package(&manifest, "repository").unwrap_or_default();
    if repository.is_empty() {
        wrong.push("Cargo.toml has no `repository` in [workspace.package]".to_owned());
    }
    let line = leading(ADDRESS, repository);
    if !workspace::read(&place.root.join("README.md"))?.lines().any(|own| own == line) {
        wrong.push(format!("README.md does not lead where the address says; its line is\n{line}"));
    }
    match (wrong.is_empty(), is_dry) {
        (true, _) => place.say(&format!("{tag} can be released")),
        (false, true) => place.say(&format!("not to be released yet:\n{}", wrong.join("\n"))),
        (false, false) => Err(wrong.join("\n")),
    }
}

/// The line of the README that leads to gallery, book and playground: hosted, and as a file of the last release, where there is an address.
fn leading(address: &str, repository: &str) -> String {
    let try_it = if address.is_empty() {
        "[Try it](docs/src/getting-started.md#files-of-a-release)".to_owned()
    } else {
        let file = format!("{repository}/releases/latest/download/playground.html");
        format!("[Try it]({address}/playground.html), or [as a file]({file})")
    };
    format!("**[Gallery](docs/src/machines.md) · [Book](docs/src/SUMMARY.md) · {try_it}**")
}

/// A value of `[workspace.package]`.
fn in_package<'a>(manifest: &'a str, name: &str) -> Option<&'a str> {
    let (_, section) = manifest.split_once("[workspace.package]\n")?;
    let mut own = section.lines().take_while(|line| !line.starts_with('['));
    own.find_map(|line| line.strip_prefix(name)?.trim_start().strip_prefix("= \"")?.strip_suffix('"'))
}

/// The version of all crates.
fn version(root: &Path) -> Result<String> {
    let manifest = workspace::read(&root.join("Cargo.toml"))?;
    let version = in_package(&manifest, "version").map(str::to_owned);
    version.ok_or_else(|| "Cargo.toml has no version of the workspace".to_owned())
}

/// `plm` for a target, in an archive with its licences.
fn binary(place: &Place, target: &str, folder: &Path) -> Result {
    place
        .command(&format!("cargo build --locked --profile {PROFILE} -p plm-cli --bin plm --target {target}"))
        .run()?;
    let program = if target.contains("windows") { "plm.exe" } else { "plm" };
    let made = place.target.join(target).join(PROFILE).join(program);
    let archive = folder.join(format!("plm-{target}.tar.gz"));
    let pack = place.command("tar -czf").arg(&archive).arg("-C").arg(made.with_file_name("")).arg(program);
    pack.arg("-C").arg(&place.root).args(["LICENSE-APACHE", "LICENSE-MIT"]).run()?;
    let size = size(&made)?;
    place.say(&format!("{}: {size} bytes, packed {} bytes", made.display(), self::size(&archive)?))?;
    if size > MOST[0].2 { Err(format!("{target}: plm has more than {} bytes", MOST[0].2)) } else { Ok(()) }
}

fn page(place: &Place, folder: &Path) -> Result {
    place.command("bash examples/playground/build.sh").run()?;
    copy(&place.root.join("target/plm/playground.html"), &folder.join("playground.html"))
}

fn book(place: &Place, folder: &Path) -> Result {
    place.command("cargo xtask ci --only book").run()?;
    let archive = folder.join("book.tar.gz");
    place.command("tar -czf").arg(&archive).arg("-C").arg(&place.target).arg("book").run()
}

/// C source with its header, FMUs with sources, and the package from which `cargo run --release -- --fmu` makes one with a binary.
fn examples(place: &Place, folder: &Path) -> Result {
    for (version, name) in [("3", "four_bar.fmu"), ("2", "four_bar_fmi2.fmu")] {
        let export = place.command("cargo run --quiet -p plm-cli -- export --force").arg(EXAMPLE);
        export.arg("--fmu-source").arg(folder.join(name)).args(["--fmi", version]).run()?;
    }

    for (option, name) in [("--c-source", "four_bar_c"), ("--fmu", "four_bar_fmu")] {
        let made = place.target.join("release-examples").join(name);
        let export = place.command("cargo run --quiet -p plm-cli -- export --force").arg(EXAMPLE);
        export.arg(option).arg(&made).run()?;
        let archive = folder.join(format!("{name}.tar.gz"));
        place.command("tar -czf").arg(&archive).arg("-C").arg(made.with_file_name("")).arg(name).run()?;
    }
    Ok(())
}

/// The files as users have them: on an empty Debian, and those for Windows by Wine.
fn tried(place: &Place, folder: &Path, parts: &[&str]) -> Result {
    let on_debian: Vec<&&str> = parts.iter().filter(|part| **part != "windows").collect();
    if parts.is_empty() || !on_debian.is_empty() {
        place.command("bash tests/empty.sh").arg(folder).args(on_debian).run()?;
    }
    if parts.is_empty() || parts.contains(&"windows") {
        place.command("bash tests/windows.sh").arg(folder).run()?;
    }
    Ok(())
}

/// All steps up to the uploads, as far as this machine has what they need. The folder of the files begins empty.
fn all(place: &Place, tag: &str) -> Result {
    let folder = place.target.join(FOLDER);
    fs::remove_dir_all(&folder).map_err(|why| format!("{}: {why}", folder.display()))?;
    let step = |words: &str| run(place, &words.split(' ').map(str::to_owned).collect::<Vec<_>>());
    step(&format!("check {tag} --dry-run"))?;
    for (target, linker) in TARGETS {
        let is_here = place.command("rustup target add").arg(target).works()
            && place.command(linker).arg("--version").works();
        if is_here {
            step(&format!("binary {target}"))?;
        } else {
            place.say(&format!("NOT CHECKED: {target} cannot be built on this machine"))?;
        }
    }
    ["examples", "page", "wheel", "npm", "book", "try", "sums", "crates --dry-run", "npm publish --dry-run"]
        .into_iter()
        .try_for_each(step)
}

/// The package of `<plm-mechanism>`, tried as it is packed.
fn npm(place: &Place, folder: &Path) -> Result {
    place.command("bash examples/playground/npm.sh --check").run()?;
    let name = npm_file(place)?;
    copy(&place.root.join("target/plm/npm").join(&name), &folder.join(&name))
}

/// That package, to the registry, with a proof of where it was built; without an upload in a dry run.
fn publish_npm(place: &Place, folder: &Path, is_dry: bool) -> Result {
    let publish = place.command("npm publish --access public").arg(folder.join(npm_file(place)?));
    if is_dry { publish.arg("--dry-run").run() } else { publish.arg("--provenance").run() }
}

fn npm_file(place: &Place) -> Result<String> {
    Ok(format!("plm-mechanism-{}.tgz", version(&place.root)?))
}

/// A list of all files with sizes and checksums, which is printed too.
fn sums(place: &Place, folder: &Path) -> Result {
    let unread = |why: std::io::Error| format!("{}: {why}", folder.display());
    let entries: std::result::Result<Vec<PathBuf>, _> =
        fs::read_dir(folder).map_err(unread)?.map(|entry| entry.map(|entry| entry.path())).collect();
    let mut files: Vec<PathBuf> = entries.map_err(unread)?;
    files.retain(|file| !file.ends_with("SHA256SUMS"));
    files.sort();
    if files.is_empty() {
        return Err(format!("{} has no files: other steps make them", folder.display()));
    }
    let (mut lines, mut wrong) = (Vec::new(), Vec::new());
    let mut table = "| file | bytes | SHA-256 |\n|---|---|---|\n".to_owned();
    for file in &files {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // That of macOS has another name.
        let program = if cfg!(target_os = "macos") { "shasum -a 256" } else { "sha256sum" };
        let text = place.command(program).arg(file).text()?;
        let sum = text.split_whitespace().next().unwrap_or_default().trim_start_matches('\\');
        let size = size(file)?;
        place.say(&format!("{size:>10}  {name}"))?;
        lines.push(format!("{sum}  {name}\n"));
        table.extend(["| `", &name, "` | ", &size.to_string(), " | `", sum, "` |\n"]);
        let limit = MOST.iter().find(|(start, end, _)| name.starts_with(start) && name.ends_with(end));
        wrong.extend(
            limit
                .filter(|(.., most)| size > *most)
                .map(|(.., most)| format!("{name} has more than {most} bytes")),
        );
    }
    for (list, text) in [(folder.join("SHA256SUMS"), lines.concat()), (place.target.join(NOTES), table)] {
        fs::write(&list, text).map_err(|why| format!("{}: {why}", list.display()))?;
    }
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n")) }
}

/// The crates, in their order; without an upload in a dry run.
fn crates(place: &Place, is_dry: bool) -> Result {
    let excluded = ["plm-peers", "plm-shared-parts", "plm-ui", "xtask"];
    let publish =
        place.command("cargo publish --workspace").args(excluded.iter().flat_map(|name| ["--exclude", name]));
    if is_dry { publish.args(["--dry-run", "--no-verify", "--allow-dirty"]).run() } else { publish.run() }
}

fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to).map(|_| ()).map_err(|why| format!("{}: {why}", from.display()))
}

fn size(file: &Path) -> Result<u64> {
    fs::metadata(file).map(|found| found.len()).map_err(|why| format!("{}: {why}", file.display()))
}
