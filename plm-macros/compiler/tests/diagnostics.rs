//! Caret tests: each file of `diagnostics/` is a declaration with its mistakes marked below the tokens,
//!
//! ```text
//!     revolute elbow(arm.p13, forearm.p12);
//!     //                 ^^^ E0204 unknown port `p13` of `arm`
//!     //                 = help: a port with a similar name exists: `p12`
//! ```
//!
//! The carets stand below the first line of what is to blame; the text is the code and a part of the message, and the
//! lines that begin with `=` are parts of its notes. A line that begins with `// ?` is a mistake that is marked nowhere
//! in the file because it stands inside a library part: `// ? E0301 message`. Every mistake must be marked, and every
//! mark must be met.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::fs;
use std::path::{Path, PathBuf};

use plm_compiler::compile;
use plm_compiler::diag::{Code, Diagnostic};
use plm_compiler::token::Sources;

/// What a file expects.
#[derive(Debug)]
struct Mark {
    /// Line, first column, number of carets; `None` if it stands elsewhere.
    place: Option<(usize, usize, usize)>,
    text: String,
    notes: Vec<String>,
}

fn marks(text: &str) -> Vec<Mark> {
    let mut marks: Vec<Mark> = Vec::new();
    let mut code_line = 0;
    for (number, line) in text.lines().enumerate() {
        let comment = line.trim_start().strip_prefix("//").filter(|comment| !comment.starts_with('/'));
        let Some(comment) = comment else {
            code_line = number + 1;
            continue;
        };
        let content = comment.trim();
        if let Some(note) = content.strip_prefix("= ") {
            marks.last_mut().unwrap().notes.push(note.to_string());
        } else if let Some(text) = content.strip_prefix("? ") {
            marks.push(Mark { place: None, text: text.to_string(), notes: Vec::new() });
        } else if content.starts_with('^') {
            let column = line.find('^').unwrap() + 1;
            let carets = content.chars().take_while(|c| *c == '^').count();
            let text = content[carets..].trim().to_string();
            marks.push(Mark { place: Some((code_line, column, carets)), text, notes: Vec::new() });
        }
    }
    marks
}

fn meets(mark: &Mark, diagnostic: &Diagnostic, sources: &Sources) -> bool {
    let rendered = diagnostic.render(sources);
    let (code, message) = mark.text.split_once(' ').unwrap_or((&mark.text, ""));
    let says = diagnostic.code.id() == code && diagnostic.message.contains(message);
    let place = sources.get(0).unwrap().place(diagnostic.span).filter(|_| diagnostic.span.source == 0);
    let found = place.map(|(place, _)| {
        let carets = rendered.lines().nth(4).unwrap().chars().filter(|c| *c == '^').count();
        (place.line, place.column, carets)
    });
    says && found == mark.place && mark.notes.iter().all(|note| rendered.contains(note))
}

fn check(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let mut sources = Sources::new();
    sources.add_text("declaration", &text);
    for file in sources.named_files() {
        // What the system says of a missing file depends on the system.
        let content = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(&file));
        sources.add_file(&file, content.map_err(|_| "no such file".to_string()));
    }
    let expansion = compile(&mut sources);
    let sink = &expansion.diagnostics;
    let mut marks = marks(&text);
    assert!(!marks.is_empty(), "{} marks no mistake", path.display());
    let name = path.file_name().unwrap().to_string_lossy();
    let mut complaints = Vec::new();
    if expansion.report.is_some() && sink.has_errors() {
        complaints.push(format!("{name}: there are errors and a report"));
    }
    for diagnostic in sink.sorted() {
        match marks.iter().position(|mark| meets(mark, diagnostic, &sources)) {
            Some(found) => drop(marks.remove(found)),
            None => complaints.push(format!("{name}: not expected:\n{}", diagnostic.render(&sources))),
        }
    }
    complaints.extend(marks.iter().map(|mark| format!("{name}: not met: {mark:?}")));
    complaints
}

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/diagnostics");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn every_code_has_a_case() {
    let marked: Vec<Mark> =
        files().iter().flat_map(|file| marks(&fs::read_to_string(file).unwrap())).collect();
    for code in Code::ALL {
        assert!(marked.iter().any(|mark| mark.text.starts_with(code.id())), "{code} has no case");
    }
}

#[test]
fn every_mistake_is_reported_where_it_is_marked() {
    let files = files();
    let complaints: Vec<String> = files.iter().flat_map(|file| check(file)).collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    assert!(files.len() > 20, "only {} files", files.len());
}

/// Compiles a text as [`check`] does.
fn diagnostics_of(text: &str) -> (Sources, Vec<Diagnostic>) {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let found = expansion.diagnostics.sorted().into_iter().cloned().collect();
    (sources, found)
}

#[test]
fn a_replacement_answers_its_diagnostic() {
    let mut count = 0;
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        let (sources, found) = diagnostics_of(&text);
        let source = sources.get(0).unwrap();
        for (diagnostic, note) in found.iter().flat_map(|of| of.notes.iter().map(move |note| (of, note))) {
            let Some(replacement) = note.replacement.as_ref().filter(|_| diagnostic.span.source == 0) else {
                continue;
            };
            let (range, shown) = (source.range(diagnostic.span).unwrap(), source.file().unwrap());
            let changed = [&shown[..range.start], replacement, &shown[range.end..]].concat();
            let (sources, left) = diagnostics_of(&changed);
            let source = sources.get(0).unwrap();
            let is_left = left.iter().any(|other| {
                let start = source.range(other.span).map(|range| range.start);
                other.message == diagnostic.message && start == Some(range.start)
            });
            assert!(!is_left, "{}: {replacement}: {}", path.display(), diagnostic.message);
            count += 1;
        }
    }
    assert!(count > 30, "{count} replacements");
}

/// A run dereferences to the state: an output with the name of one of its methods could not be read.
#[test]
fn no_output_is_hidden_by_a_method_of_a_run() {
    let run = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../plm-runtime/src/sim.rs");
    let text = fs::read_to_string(run).unwrap();
    let methods: Vec<&str> = text
        .split("pub fn ")
        .skip(1)
        .filter(|item| item.split_once('{').is_some_and(|(head, _)| head.contains("self")))
        .filter_map(|item| item.split(|c: char| !c.is_alphanumeric() && c != '_').next())
        .collect();
    assert!(methods.len() > 10 && methods.contains(&"step"), "{methods:?}");
    for method in methods {
        let mut sources = Sources::new();
        sources.add_text("declaration", &format!("pub P {{ output {method} = 1; }}"));
        let found = compile(&mut sources).diagnostics;
        assert!(found.iter().any(|of| of.code == Code::ReservedName), "an output `{method}` is hidden");
    }
}
