//! What the registry and docs.rs show of each crate: manifest, README, licences, features; the order of a release.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::root;
use super::workspace::{self, Package};

fn read(path: &str) -> String {
    workspace::read(&root().join(path)).unwrap()
}

/// A crate that is published, with its manifest.
struct Published {
    package: Package,
    manifest: String,
}

impl Published {
    /// The text of a file in the folder of the crate.
    fn file(&self, name: &str) -> String {
        read(&format!("{}/{name}", self.package.folder))
    }

    /// Where the README of the package stands.
    fn readme(&self) -> &'static str {
        if self.package.folder == "." { "src/README.md" } else { "README.md" }
    }

    /// The lines of a table of the manifest.
    fn table(&self, title: &str) -> impl Iterator<Item = &str> {
        let lines = self.manifest.lines().skip_while(move |line| *line != title).skip(1);
        lines.take_while(|line| !line.starts_with('['))
    }

    /// The names of its features.
    fn features(&self) -> BTreeSet<&str> {
        let lines = self.table("[features]").filter(|line| !line.starts_with('#'));
        lines.filter_map(|line| line.split_once(" = ")).map(|(name, _)| name).collect()
    }

    /// The crates of the workspace that it needs.
    fn needs(&self) -> BTreeSet<&str> {
        let lines = self.table("[dependencies]").filter(|line| line.starts_with("plm-"));
        lines.filter_map(|line| line.split_once(" = ")).map(|(name, _)| name).collect()
    }
}

fn published() -> Vec<Published> {
    let packages = workspace::packages(root()).unwrap().into_iter();
    let with_manifest = packages.map(|package| {
        let manifest = read(&format!("{}/Cargo.toml", package.folder));
        Published { package, manifest }
    });
    with_manifest.filter(|krate| !krate.manifest.contains("publish = false")).collect()
}

fn fail_with(what: &str, wrong: &[String]) {
    assert!(wrong.is_empty(), "{what}:\n  {}", wrong.join("\n  "));
}

#[test]
fn every_manifest_says_what_the_registry_shows() {
    let crates = published();
    assert_eq!(crates.len(), 19, "crates that are published");
    let mut wrong = Vec::new();
    for krate in &crates {
        let name = &krate.package.name;
        let mut lines = vec![
            "description = \"".to_owned(),
            format!("readme = \"{}\"", krate.readme()),
            format!("documentation = \"https://docs.rs/{name}\""),
            "include = [\"/src\"".to_owned(),
            "license.workspace = true".to_owned(),
            "version.workspace = true".to_owned(),
        ];
        if !krate.features().is_empty() {
            lines.push("[package.metadata.docs.rs]".to_owned());
            lines.push("rustdoc-args = [\"--cfg\", \"docsrs\"]".to_owned());
            if !krate.file("src/lib.rs").contains("#![cfg_attr(docsrs, feature(doc_cfg))]") {
                wrong.push(format!("{name}: docs.rs cannot show features without `doc_cfg` in src/lib.rs"));
            }
        }
        let missing =
            lines.into_iter().filter(|line| !krate.manifest.lines().any(|own| own.starts_with(line)));
        wrong.extend(missing.map(|line| format!("{name}: no `{line}`")));
    }
    fail_with("manifests", &wrong);
}

#[test]
fn every_package_has_a_readme_and_the_licences() {
    let mut wrong = Vec::new();
    for krate in published() {
        let (name, readme) = (&krate.package.name, krate.file(krate.readme()));
        let title = if name == "plm-planar" { "plm" } else { name };
        if !readme.starts_with(&format!("# {title}\n")) || !readme.contains("https://docs.rs/plm-planar") {
            wrong.push(format!("{name}: the README has no title, or does not lead to plm"));
        }
        // The registry shows it alone: files beside it are not there.
        let targets = readme.split("](").skip(1);
        wrong.extend(
            targets
                .filter(|target| !target.starts_with("https://"))
                .map(|target| format!("{name}: {target}")),
        );
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            let own = fs::read(root().join(&krate.package.folder).join(licence)).ok();
            if own != Some(fs::read(root().join(licence)).unwrap()) {
                wrong.push(format!("{name}: {licence} is not that of the root"));
            }
        }
    }
    fail_with("READMEs and licences", &wrong);
}

/// A package has what `include` names alone: a file that its sources read and that is not there breaks the build of every user.
#[test]
fn every_package_has_the_files_that_its_sources_read() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for krate in published() {
        let folder = root().join(&krate.package.folder).canonicalize().unwrap();
        let line = krate.manifest.lines().find_map(|line| line.strip_prefix("include = [")).unwrap();
        let included: Vec<&str> = line.split('"').skip(1).step_by(2).collect();
        let is_there =
            |own: &Path| included.iter().any(|pattern| own.starts_with(pattern.trim_start_matches('/')));
        let all: Vec<PathBuf> =
            sources(&folder.join("src")).iter().flat_map(|source| files(source)).collect();
        count += all.len();
        let missing = all.iter().filter(|file| !file.strip_prefix(&folder).is_ok_and(is_there));
        wrong.extend(missing.map(|file| format!("{}: {}", krate.package.name, file.display())));
    }
    assert!(count > 100, "{count} files are read");
    fail_with("files that packages do not have", &wrong);
}

/// The files that a source reads when it is compiled, without those of folders of tests, which tests alone read.
fn files(source: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(source).unwrap();
    let paths =
        ["include_str!(\"", "include_bytes!(\""].into_iter().flat_map(|read| text.split(read).skip(1));
    paths
        .filter_map(|rest| rest.split('"').next())
        .filter(|path| !path.contains("tests/"))
        .map(|path| source.with_file_name(path).canonicalize().unwrap())
        .collect()
}

/// All Rust files of a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found
}

/// What the macro emits names items of the runtime that are no promise to users: crates of two releases do not go together.
#[test]
fn crates_of_a_release_ask_for_each_other_exactly() {
    let manifest = read("Cargo.toml");
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'));
    let exact = format!("version = \"={}\"", version.unwrap());
    let crates = published();
    let mut wrong = Vec::new();
    for krate in crates.iter().filter(|krate| krate.package.name != "plm-planar") {
        let line =
            manifest.lines().find(|line| line.starts_with(&format!("{} = {{ path", krate.package.name)));
        if !line.is_some_and(|line| line.contains(&exact)) {
            wrong.push(format!("{} in [workspace.dependencies] without {exact}", krate.package.name));
        }
    }
    for krate in &crates {
        let own = krate.table("[dependencies]").filter(|line| line.starts_with("plm-"));
        let loose = own.filter(|line| !line.contains("workspace = true"));
        wrong.extend(loose.map(|line| format!("{}: {line}", krate.package.name)));
    }
    fail_with("dependencies", &wrong);
}

/// The first cells of the rows of a table whose first column has code.
fn cells(text: &str) -> BTreeSet<&str> {
    let rows = text.lines().filter_map(|line| line.trim_start_matches("//!").trim().strip_prefix("| `"));
    rows.filter_map(|row| row.split_once('`')).map(|(cell, _)| cell).collect()
}

#[test]
fn the_front_page_has_every_feature() {
    let crates = published();
    let plm = crates.iter().find(|krate| krate.package.name == "plm-planar").unwrap();
    let page = plm.file("src/lib.rs");
    let (_, table) = page.split_once("//! # Features").unwrap();
    let (table, _) = table.split_once("//! # ").unwrap();
    let mut features = plm.features();
    assert!(features.remove("default") && features.len() > 8, "features were read: {features:?}");
    assert_eq!(cells(table), features, "the table of features in src/lib.rs, beside those of Cargo.toml");
}

#[test]
fn the_readme_and_the_front_page_name_this_version() {
    let manifest = read("Cargo.toml");
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'));
    let version = version.unwrap();
    for (file, line) in [
        ("src/README.md", format!("plm-planar = \"{version}\"")),
        ("crates/plm-python/dynamic/Cargo.toml", format!("version = \"{version}\"")),
        ("src/lib.rs", format!("plm-planar = {{ version = \"{version}\", default-features = false }}")),
    ] {
        assert!(read(file).contains(&line), "{file} does not say `{line}`");
    }
}

/// A crate can be published when all that it needs is there.
#[test]
fn the_order_of_a_release_follows_the_dependencies() {
    let page = read("docs/src/internals/releasing.md");
    let order: Vec<&str> = page
        .lines()
        .filter_map(|line| line.split_once(". `plm-"))
        .filter(|(number, _)| number.bytes().all(|byte| byte.is_ascii_digit()))
        .filter_map(|(_, rest)| rest.split_once('`'))
        .map(|(name, _)| name)
        .collect();
    let crates = published();
    let mut wrong = Vec::new();
    for krate in &crates {
        let place = |name: &str| order.iter().position(|listed| format!("plm-{listed}") == name);
        let own = place(&krate.package.name);
        if own.is_none() {
            wrong.push(format!("{} is not listed", krate.package.name));
        }
        let later = krate.needs().into_iter().filter(|needed| place(needed) >= own);
        wrong.extend(later.map(|needed| format!("{} comes before {needed}", krate.package.name)));
    }
    assert_eq!(order.len(), crates.len(), "crates in docs/src/internals/releasing.md: {order:?}");
    fail_with("docs/src/internals/releasing.md", &wrong);
}

/// The documentation of the macro has the items of the language, as the book has them.
#[test]
fn the_macro_documents_every_item_of_the_language() {
    let book = read("docs/src/language/declaration.md");
    let (_, table) = book.split_once("| item | meaning |").unwrap();
    let (table, _) = table.split_once("\n\n").unwrap();
    let items: Vec<&str> = table
        .lines()
        .filter_map(|line| line.strip_prefix("| `"))
        .filter_map(|line| line.split_once('`'))
        .map(|(item, _)| item)
        .collect();
    let documented = read("plm-macros/src/lib.rs");
    let missing: Vec<String> = items
        .iter()
        .filter(|item| !documented.contains(&format!("/// | `{item}`")))
        .map(|item| (*item).to_owned())
        .collect();
    assert!(items.len() > 15, "items were read: {items:?}");
    fail_with("items that the documentation of `mechanism!` lacks", &missing);
}

/// Whoever hosts the repository runs the stages that there are.
#[test]
fn the_workflow_and_the_release_name_stages_of_ci() {
    let stages = read("xtask/src/ci.rs");
    let mut wrong = Vec::new();
    for page in
        [".github/workflows/ci.yml", "docs/src/internals/releasing.md", "CONTRIBUTING.md", "ARCHITECTURE.md"]
    {
        let text = read(page);
        for rest in text.split("--only ").skip(1) {
            let names = rest.split(['\n', '`', '#']).next().unwrap().split_whitespace();
            let unknown =
                names.filter(|name| *name != "NAME..." && !stages.contains(&format!("(\"{name}\", ")));
            wrong.extend(unknown.map(|name| format!("{page}: {name}")));
        }
    }
    fail_with("stages that `cargo xtask ci --list` does not have", &wrong);
}

/// The steps of the workflow of a release are those of `cargo xtask release`, and the page about releases names each.
#[test]
fn the_workflow_of_a_release_names_its_steps() {
    let (steps, workflow) = (read("xtask/src/release.rs"), read(".github/workflows/release.yml"));
    let page = read("docs/src/internals/releasing.md");
    let known: BTreeSet<&str> = steps
        .lines()
        .filter_map(|line| line.strip_prefix("cargo xtask release ")?.split_whitespace().next())
        .collect();
    assert!(known.len() > 5, "{known:?}");
    let called = workflow.split("cargo xtask release ").skip(1);
    let called: BTreeSet<&str> = called.filter_map(|rest| rest.split_whitespace().next()).collect();
    assert_eq!(called.iter().filter(|step| !known.contains(*step)).collect::<Vec<_>>(), Vec::<&&str>::new());
    let wrong: Vec<String> = known
        .iter()
        .filter(|step| !called.contains(*step) || !page.contains(&format!("`cargo xtask release {step}")))
        .map(|step| (*step).to_owned())
        .collect();
    fail_with("steps that the workflow or the page about releases lacks", &wrong);
}

/// A library that says `test = false` is compiled once and has no tests in its sources, where nobody would run them; one without tests
/// says so.
#[test]
fn libraries_are_compiled_for_tests_where_they_have_some() {
    let mut wrong = Vec::new();
    for package in workspace::members(root()).unwrap() {
        let folder = root().join(&package.folder);
        let manifest = read(&format!("{}/Cargo.toml", package.folder));
        if !folder.join("src/lib.rs").exists() {
            continue;
        }
        let all = sources(&folder.join("src"));
        let library = manifest.split_once("[lib]").map_or("", |(_, rest)| rest);
        let is_tested =
            !library.lines().take_while(|line| !line.starts_with('[')).any(|line| line == "test = false");
        let has_tests = all.iter().any(|file| fs::read_to_string(file).unwrap().contains("#[test]"));
        if is_tested != has_tests {
            let what = if has_tests { "tests that are not run" } else { "no tests: `test = false`" };
            wrong.push(format!("{}: {what}", package.name));
        }
    }
    fail_with("libraries", &wrong);
}
