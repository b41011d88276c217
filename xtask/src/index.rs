//! The list of source files that the book shows: for each file the first sentence of its documentation.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The page, from the root of the repository.
pub(crate) const PAGE: &str = "docs/src/internals/files.md";

const HEAD: &str = "\
# Files

The list below has the source files of each crate, with the first sentence of each file's documentation. Paths begin at
the crate's folder `src`. The command `cargo xtask index` writes this page; tests and examples are not listed.
";

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

/// The text of the page.
///
/// # Errors
/// A file that cannot be read, or that has no documentation.
pub(crate) fn page(root: &Path) -> Result<String, String> {
    let mut page = HEAD.to_owned();
    for package in packages(root)? {
        let sources =
            if package.folder == "." { "src".to_owned() } else { format!("{}/src", package.folder) };
        page.extend(["\n## ", &package.name, "\n\n`", &sources, "`\n"]);
        let mut folders: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for path in files(&root.join(&sources))? {
            let inside = slashes(&path, &root.join(&sources))?;
            let folder = inside.rsplit_once('/').map_or("", |(folder, _)| folder);
            let sentence = first_sentence(&read(&path)?);
            let sentence = sentence.ok_or_else(|| format!("{}: no `//!` at the top", path.display()))?;
            folders.entry(folder.to_owned()).or_default().push(format!("* `{inside}`: {sentence}\n"));
        }
        for (folder, lines) in folders {
            if !folder.is_empty() {
                page.extend(["\n### ", &folder, "\n"]);
            }
            page.extend(["\n", &lines.concat()]);
        }
    }
    Ok(page)
}

/// Files with Rust code in a folder and below, in the order of their paths.
fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let failed = |why: std::io::Error| format!("{}: {why}", folder.display());
        for entry in fs::read_dir(&folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// A path below a folder, with slashes on every system.
fn slashes(path: &Path, folder: &Path) -> Result<String, String> {
    let inside = path.strip_prefix(folder).map_err(|why| format!("{}: {why}", path.display()))?;
    let parts: Vec<_> = inside.iter().map(|part| part.to_string_lossy()).collect();
    Ok(parts.join("/"))
}

/// The first sentence of a file's documentation. Links of rustdoc lead nowhere in the book, so that only their texts stay.
fn first_sentence(text: &str) -> Option<String> {
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    let paragraph: Vec<&str> = lines.map(str::trim).take_while(|line| !line.is_empty()).collect();
    let paragraph = without_links(&paragraph.join(" "));
    // A sentence ends at a full stop before a capital letter, unless the stop belongs to an initial.
    let end = paragraph.match_indices(". ").map(|(at, _)| at).find(|&at| {
        let is_initial =
            paragraph[..at].rsplit([' ', '(']).next().is_some_and(|word| word.len() == 1 && word >= "A");
        let next = paragraph[at + 2..].chars().next();
        !is_initial && next.is_some_and(|next| next.is_uppercase() || "`[".contains(next))
    });
    let sentence = end.map_or(paragraph.as_str(), |at| &paragraph[..=at]);
    (!sentence.is_empty()).then(|| sentence.trim_end_matches(':').to_owned())
}

/// `[text](target)` and `[text]` become `text`, outside code.
fn without_links(markdown: &str) -> String {
    let (mut text, mut rest, mut in_code) = (String::new(), markdown, false);
    let mut open = 0_usize;
    while let Some(letter) = rest.chars().next() {
        rest = &rest[letter.len_utf8()..];
        in_code ^= letter == '`';
        match letter {
            '[' if !in_code => open += 1,
            ']' if !in_code && open > 0 => {
                open -= 1;
                let target = rest.strip_prefix('(').and_then(|target| target.split_once(')'));
                // The parentheses of a function in a target are a pair of their own.
                rest = target.map_or(rest, |(_, after)| after.strip_prefix(')').unwrap_or(after));
            }
            _ => text.push(letter),
        }
    }
    text
}

/// A file's text, with its path in the error.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}
