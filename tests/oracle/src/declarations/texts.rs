//! Declarations of the repository that people read: of the book, of parts, of examples, of benchmarks; and where methods fail.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use crate::pages;

use super::reference::Scene;

/// Folders of Rust files for readers, some of which have a `mechanism!`.
const FOLDERS: [&str; 4] =
    ["examples", "benches", "crates/plm-studies/examples", "crates/plm-program/examples"];
/// A folder of declarations.
const STABILITY: &str = "tests/oracle/stability/declared";

/// All of them, those that ask for no formulation twice.
pub(crate) fn scenes() -> &'static [Scene] {
    static SCENES: OnceLock<Vec<Scene>> = OnceLock::new();
    SCENES.get_or_init(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut found = Found { root, seen: BTreeSet::new(), scenes: Vec::new() };
        let book = found.root.join("docs/src");
        for page in files(&book, "md") {
            let text = fs::read_to_string(&page).unwrap_or_default();
            blocks(&text).for_each(|block| found.add(&page, block.to_owned()));
        }
        for example in pages::examples() {
            found.add(&book.join("parts").join(&example.page), example.text.clone());
        }
        for folder in FOLDERS {
            for file in files(&found.root.join(folder), "rs") {
                let text = fs::read_to_string(&file).unwrap_or_default();
                let name = file.display().to_string();
                for text in plm_cli::declarations(&name, &text) {
                    found.add(&file, text);
                }
            }
        }
        for file in files(&found.root.join(STABILITY), "plm") {
            let text = fs::read_to_string(&file).unwrap_or_default();
            found.add(&file, text);
        }
        found.scenes
    })
}

struct Found {
    root: PathBuf,
    seen: BTreeSet<String>,
    scenes: Vec<Scene>,
}

impl Found {
    /// A declaration, unless it was there before or is of parts alone.
    fn add(&mut self, file: &Path, text: String) {
        let Some(open) = opens(&text).filter(|_| self.seen.insert(text.clone())) else { return };
        let place = file.strip_prefix(&self.root).unwrap_or(file).display().to_string();
        let absolute = format!("{} formulation: absolute; {}", &text[..open], &text[open..]);
        let twin = (!text.contains("formulation:")).then_some(absolute);
        self.scenes.push(Scene::new(file, place, text, twin));
    }
}

/// Index after the bracket that opens the mechanism; `None` in a text of parts alone.
fn opens(text: &str) -> Option<usize> {
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if line.trim_start().starts_with("pub ") {
            return text[at..].find('{').map(|open| at + open + 1);
        }
        at += line.len();
    }
    None
}

/// Blocks of a page that are declarations without a mistake: fenced as `plm`, some with a warning.
fn blocks(text: &str) -> impl Iterator<Item = &str> {
    text.split("\n```plm").skip(1).filter_map(|block| {
        let (fence, rest) = block.split_once('\n')?;
        let is_right = fence.is_empty() || fence.starts_with(",W");
        is_right.then(|| rest.split("\n```").next().unwrap_or_default())
    })
}

/// Files below a folder by the end of their names, in the order of their paths.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|own| own == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}
