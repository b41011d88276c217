//! Rules of the house that a machine can read: sizes, places, links, pages. CONTRIBUTING.md says why.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use plm_compiler::diag::Code;

#[path = "tidy/file_names.rs"]
mod file_names;
#[path = "tidy/formulas.rs"]
mod formulas;
#[path = "tidy/old_words.rs"]
mod old_words;
#[path = "tidy/source_files.rs"]
mod source_files;
#[path = "tidy/words.rs"]
mod words;

/// A file above this is shown (`cargo test -p xtask --test tidy -- --nocapture`): it may be two rooms.
const LONG_FILE: usize = 400;
/// A file above this fails.
const LONGEST_FILE: usize = 410;

/// Files of the compiler that may hold a hash map, each with the reason why its order reaches no output.
const MAY_HASH: [(&str, &str); 0] = [];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// All files that people write of the repository with one of these extensions, in the order of their paths.
fn files(extensions: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            let path = entry.path();
            if path.is_dir() {
                if !["target", ".git", "book", "node_modules"].contains(&name.as_str()) {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|e| extensions.iter().any(|wanted| e == *wanted))
                && !is_emitted(&path)
            {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Is it what the compiler has written for a test (tests/snapshots)?
fn is_emitted(path: &Path) -> bool {
    shown(path).starts_with("tests/snapshots/")
        && path.with_extension("plm").exists()
        && !path.ends_with("main.rs")
}

/// The path from the root, with slashes.
fn shown(path: &Path) -> String {
    let parts = path.strip_prefix(root()).unwrap().components();
    parts.map(|part| part.as_os_str().to_str().unwrap()).collect::<Vec<_>>().join("/")
}

/// Every line of every file, with the place to name in a message.
fn lines(files: Vec<PathBuf>) -> impl Iterator<Item = (String, String, String)> {
    files.into_iter().flat_map(|file| {
        let text = fs::read_to_string(&file).unwrap();
        let shown = shown(&file);
        let numbered = text.lines().enumerate();
        numbered
            .map(|(index, line)| (shown.clone(), format!("{shown}:{}", index + 1), line.to_owned()))
            .collect::<Vec<_>>()
    })
}

fn fail_with(what: &str, wrong: &[String]) {
    assert!(wrong.is_empty(), "{what}:\n  {}", wrong.join("\n  "));
}

#[test]
fn files_are_short() {
    let mut wrong = Vec::new();
    for file in files(&["rs", "plm"]) {
        let length = fs::read_to_string(&file).unwrap().lines().count();
        if length > LONGEST_FILE {
            wrong.push(format!("{}: {length} lines", shown(&file)));
        } else if length > LONG_FILE {
            println!("{}: {length} lines; is it two rooms?", shown(&file));
        }
    }
    fail_with(&format!("files of more than {LONGEST_FILE} lines"), &wrong);
}

#[test]
fn nothing_is_left_open() {
    // Put together here, so that this list is not found itself.
    let open = [
        concat!("TO", "DO"),
        concat!("FIX", "ME"),
        concat!("XX", "X"),
        concat!("to", "do!"),
        concat!("unimple", "mented!"),
        concat!("#[", "ignore"),
        concat!("(to be ", "written)"),
    ];
    let mut wrong = Vec::new();
    for (_, place, line) in lines(files(&["rs", "plm", "toml", "md", "sh"])) {
        if open.iter().any(|word| line.contains(word)) {
            wrong.push(format!("{place}: {}", line.trim()));
        }
    }
    fail_with("left open", &wrong);
}

#[test]
fn no_hash_decides_an_order_in_the_compiler() {
    let mut wrong = Vec::new();
    for (file, place, line) in lines(files(&["rs"])) {
        let compiler = file.starts_with("plm-macros/");
        let hashes = ["HashMap", "HashSet", "RandomState"].iter().any(|name| line.contains(name));
        if compiler && hashes && !MAY_HASH.iter().any(|(allowed, _)| *allowed == file) {
            wrong.push(format!("{place}: {}", line.trim()));
        }
    }
    fail_with("hash maps in the compiler (BTreeMap, or an entry with its reason in MAY_HASH)", &wrong);
}

#[test]
fn unsafe_code_stands_in_few_files() {
    let allowed = [
        // Programs without std have to enter, print and leave by themselves.
        "examples/firmware/machine/src/",
        // Functions that a page calls keep their names in a module of WebAssembly.
        "examples/playground/src/lib.rs",
        // Assembly for square roots, built where a feature asks for it.
        "plm-runtime/math/processor/src/lib.rs",
        // Pointers of other languages, and the tests by which Miri looks at them; nothing else that is shipped has a reason.
        "crates/plm-foreign/src/ffi.rs",
        "crates/plm-foreign/src/ffi/linear.rs",
        "crates/plm-foreign/src/ffi/names.rs",
        "crates/plm-foreign/src/fmi/ffi.rs",
        "crates/plm-foreign/src/fmi/ffi/",
        // Calls of machine code, and what it calls with pointers.
        "crates/plm-jit/src/call.rs",
        "crates/plm-foreign/tests/ffi.rs",
        "crates/plm-foreign/tests/fmi.rs",
    ];
    let wrong: Vec<String> = lines(files(&["rs"]))
        .filter(|(file, _, line)| {
            let code = line.split("//").next().unwrap_or("");
            let forms = [concat!("unsafe", " "), concat!("#[unsafe", "("), concat!("unsafe", "{")];
            let is_allowed = allowed.iter().any(|allowed| file.starts_with(allowed));
            !is_allowed && forms.iter().any(|form| code.contains(form))
        })
        .map(|(_, place, line)| format!("{place}: {}", line.trim()))
        .collect();
    fail_with("code that is not safe", &wrong);
}

#[test]
fn no_path_of_a_machine_stands_in_the_tree() {
    let paths = [
        concat!("/wo", "rk/"),
        concat!("/t", "mp/"),
        concat!("/ro", "ot/"),
        concat!("/ho", "me/"),
        concat!("../sha", "red"),
    ];
    let mut wrong = Vec::new();
    let texts = ["rs", "plm", "toml", "md", "sh", "json", "stderr", "txt", "svg", "lock"];
    let mut files = files(&texts);
    files.extend([".ci/run", ".ci/more"].map(|script| root().join(script)));
    for (_, place, line) in lines(files) {
        if paths.iter().any(|path| line.contains(path)) {
            wrong.push(format!("{place}: {}", line.trim()));
        }
    }
    fail_with("paths of a machine", &wrong);
}

#[test]
fn every_allow_has_a_reason() {
    let mut wrong = Vec::new();
    // What is emitted into other people's code stands in texts.
    let emits =
        |file: &str| file.starts_with("plm-macros/compiler/src/emit/") || file.starts_with("plm-macros/src/");
    for file in files(&["rs"]).into_iter().filter(|file| !emits(&shown(file))) {
        let text = fs::read_to_string(&file).unwrap();
        let mut above = "";
        for (index, line) in text.lines().map(str::trim).enumerate() {
            let begins = ["#[allow(", "#![allow("].iter().any(|form| line.starts_with(form));
            let mut attribute = text.lines().skip(index).take_while(|line| !line.trim().ends_with(")]"));
            let says = line.contains("reason =") || attribute.any(|line| line.contains("reason ="));
            if begins && !says && !line.contains("//") && !above.starts_with("// ") {
                wrong.push(format!("{}:{}: {line}", shown(&file), index + 1));
            }
            above = line;
        }
    }
    fail_with("an `allow` without its reason", &wrong);
}

#[test]
fn every_package_takes_the_lints_of_the_workspace() {
    let mut wrong = Vec::new();
    for file in files(&["toml"]) {
        let text = fs::read_to_string(&file).unwrap();
        let is_member = text.contains("version.workspace = true");
        if is_member && !text.contains("[lints]\nworkspace = true") && !has_own_lints(&file, &text) {
            wrong.push(shown(&file));
        }
    }
    fail_with("packages without `[lints] workspace = true`", &wrong);
}

/// The packages that have unsafe code: they refuse it where nothing allows it, and warn of all that the others warn of.
fn has_own_lints(file: &Path, text: &str) -> bool {
    let workspace = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let (_, lints) = workspace.split_once("[workspace.lints.rust]").unwrap();
    let warned: Vec<&str> = lints.lines().filter(|line| line.contains("\"warn\"")).collect();
    ["crates/plm-foreign/Cargo.toml", "crates/plm-jit/Cargo.toml", "plm-runtime/math/processor/Cargo.toml"]
        .contains(&shown(file).as_str())
        && text.contains("unsafe_code = \"deny\"")
        && warned.len() > 8
        && warned.iter().all(|line| text.contains(line))
}

#[test]
fn paths_in_the_architecture_exist() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let named = paths_in_code(&text);
    assert!(named.len() >= 10, "the reader of paths found only {named:?}");
    let wrong: Vec<String> = named.into_iter().filter(|path| !exists(path)).collect();
    fail_with("ARCHITECTURE.md names paths that do not exist", &wrong);
}

/// What looks like a path in code spans and code blocks: it ends like one of our files or folders, or begins with a
/// folder at the root.
fn paths_in_code(markdown: &str) -> BTreeSet<String> {
    let mut named = BTreeSet::new();
    let mut in_block = false;
    for line in markdown.lines() {
        if line.trim_start().starts_with("```") {
            in_block = !in_block;
            continue;
        }
        // In prose the odd pieces between backticks are code; in a block of the layout every word may be a path.
        let step = if in_block { 1 } else { 2 };
        for code in line.split('`').skip(step - 1).step_by(step) {
            for word in code.split([' ', ',', ';', '(', ')', '"']) {
                if is_path(word) {
                    named.insert(word.to_owned());
                }
            }
        }
    }
    named
}

fn is_path(word: &str) -> bool {
    let characters = word.chars().all(|c| c.is_ascii_alphanumeric() || "/._-*<>".contains(c));
    let first = word.split('/').next().unwrap_or("");
    let ends = ["/", ".rs", ".md", ".plm", ".toml", ".sh", ".json"].iter().any(|end| word.ends_with(end));
    characters && first.len() > 1 && (ends || word.contains('/') && root().join(first).exists())
}

/// A path from the root, from a package or from its sources; what stands after a wildcard is not looked at.
fn exists(path: &str) -> bool {
    let known = match path.find(['*', '<']) {
        None => path,
        Some(wildcard) => path[..wildcard].rsplit_once('/').map_or("", |(folders, _)| folders),
    };
    let manifests = files(&["toml"]).into_iter().filter(|file| file.ends_with("Cargo.toml"));
    let packages: Vec<PathBuf> = manifests.map(|file| file.parent().unwrap().to_owned()).collect();
    packages.iter().any(|base| base.join(known).exists() || base.join("src").join(known).exists())
}

#[test]
fn links_in_our_pages_lead_somewhere() {
    let mut wrong = Vec::new();
    for file in files(&["md"]) {
        let text = fs::read_to_string(&file).unwrap();
        for target in links(&text) {
            let path = target.split('#').next().unwrap_or("");
            let elsewhere = path.is_empty() || path.contains("://") || path.starts_with("mailto:");
            if !elsewhere && !file.parent().unwrap().join(path).exists() {
                wrong.push(format!("{}: {target}", shown(&file)));
            }
        }
    }
    fail_with("links that lead nowhere", &wrong);
}

/// The targets of `[text](target)`, outside code.
fn links(markdown: &str) -> Vec<&str> {
    let prose = markdown.split("```").step_by(2);
    let prose = prose.flat_map(|text| text.split('`').step_by(2));
    let after = prose.flat_map(|text| text.split("](").skip(1));
    after.filter_map(|rest| rest.split(')').next()).collect()
}

#[test]
fn the_book_lists_every_page() {
    let book = root().join("docs/src");
    let summary = fs::read_to_string(book.join("SUMMARY.md")).expect("docs/src/SUMMARY.md");
    let listed: BTreeSet<PathBuf> = links(&summary).into_iter().map(|link| book.join(link)).collect();
    assert!(!listed.is_empty(), "the reader of links found none in SUMMARY.md");
    let pages = files(&["md"]).into_iter().filter(|file| file.starts_with(&book));
    let forgotten = pages.filter(|page| !page.ends_with("SUMMARY.md") && !listed.contains(page));
    fail_with("pages that SUMMARY.md does not list", &forgotten.map(|page| shown(&page)).collect::<Vec<_>>());
}

/// `src/book.rs` names the pages whose code is compiled and run.
#[test]
fn the_rust_code_of_every_page_is_tested() {
    let (book, listed) = (root().join("docs/src"), fs::read_to_string(root().join("src/book.rs")).unwrap());
    let mut wrong = Vec::new();
    for page in files(&["md"]).into_iter().filter(|file| file.starts_with(&book)) {
        let name = page.strip_prefix(&book).unwrap().to_str().unwrap().replace('\\', "/");
        let text = fs::read_to_string(&page).unwrap();
        if text.lines().any(|line| line.trim() == "```rust") && !listed.contains(&format!("\"{name}\"")) {
            wrong.push(shown(&page));
        }
    }
    fail_with("pages with Rust code that src/book.rs does not name", &wrong);
}

#[test]
fn every_diagnostic_has_a_page_and_a_case() {
    let is_case = |file: &Path| {
        let file = shown(file);
        file.starts_with("plm-macros/compiler/tests/") || file.starts_with("tests/ui/")
    };
    let cases = files(&["rs", "plm", "stderr"]).into_iter().filter(|file| is_case(file));
    let cases: String = cases.map(|file| fs::read_to_string(file).unwrap()).collect();

    let mut wrong = Vec::new();
    for code in Code::ALL.iter().map(|code| code.id()) {
        let page = root().join(format!("docs/src/diagnostics/{code}.md"));
        match fs::read_to_string(&page) {
            Ok(text) if text.starts_with(&format!("# {code}")) => {}
            Ok(_) => wrong.push(format!("{}: the heading does not begin with the code", shown(&page))),
            Err(_) => wrong.push(format!("{code} has no page {}", shown(&page))),
        }
        if !cases.contains(code) {
            wrong.push(format!("{code} has no case in plm-macros/compiler/tests or tests/ui"));
        }
    }
    fail_with("the catalogue of diagnostics", &wrong);
}

/// A tolerance without its line in the table of the book was not derived, or not swept.
#[test]
fn the_book_derives_every_tolerance() {
    let page = fs::read_to_string(root().join("docs/src/theory/near-singular.md")).unwrap();
    let mut wrong = Vec::new();
    for file in ["charts", "singular", "closing"] {
        let text = fs::read_to_string(root().join(format!("plm-runtime/src/tolerances/{file}.rs"))).unwrap();
        let declared =
            text.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(": ").map(|of| of.0));
        let names =
            declared.filter(|name| name.chars().all(|letter| letter.is_ascii_uppercase() || letter == '_'));
        wrong.extend(names.map(|name| format!("| `{name}` |")).filter(|line| !page.contains(line)));
    }
    fail_with("tolerances that docs/src/theory/near-singular.md does not have", &wrong);
}
