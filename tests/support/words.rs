//! Words: old names that the vocabulary has replaced, and doc comments that begin with their noun.

use std::collections::BTreeSet;

use super::{OLD_WORDS, fail_with, files, lines};

/// More of [`OLD_WORDS`]: those of the compiler, of other languages, and of what is built on the runtime.
const OTHER_OLD_WORDS: [(&str, &str, &str); 27] = [
    ("plm-macros/compiler/src/formulate/", "rung", "formulation"),
    ("plm-macros/compiler/src/check/", "rung", "formulation"),
    ("plm-macros/compiler/src/resolve/", "rung", "formulation"),
    ("tests/formulations/", "rung", "formulation"),
    ("examples/work_precision/", "rung", "formulation"),
    ("plm-macros/compiler/src/formulate/", "class", "orientation"),
    ("plm-macros/compiler/src/formulate/", "heading", "absolute angle"),
    ("plm-macros/compiler/src/formulate/", "slide", "displacement"),
    ("plm-macros/compiler/src/formulate/", "given", "explicit row"),
    ("plm-macros/compiler/src/formulate/", "spare", "redundant row"),
    ("plm-macros/compiler/src/formulate/", "loose", "free coordinate"),
    ("plm-macros/compiler/src/derive/", "causes", "forcing terms"),
    ("plm-macros/compiler/src/", "draft", "unresolved model"),
    ("plm-macros/compiler/src/", "things", "declarations"),
    ("plm-macros/compiler/src/resolve/", "settle", "finalise"),
    ("plm-macros/compiler/src/", "habits", "foreign syntax"),
    ("plm-macros/compiler/src/", "flaw", "lexical error"),
    ("plm-macros/compiler/src/", "mended", "recovered"),
    ("plm-macros/compiler/src/", "figures", "numeric table"),
    ("plm-macros/", "piece", "fragment"),
    ("plm-macros/compiler/src/emit/", "rolled", "rerolled"),
    ("plm-macros/compiler/src/emit/", "families", "indexed accessors"),
    ("plm-foreign/", "border", "ffi"),
    ("plm-foreign/src/fmi/", "trouble", "error"),
    ("plm-foreign/src/ffi/", "trouble", "error"),
    ("src/live", "trouble", "error"),
    ("plm-analysis/src/stabilise/", "look", "evaluation"),
];

#[test]
fn names_are_those_of_the_vocabulary() {
    let mut wrong = Vec::new();
    for (file, place, line) in lines(files(&["rs"])) {
        let code = line.split("//").next().unwrap_or("");
        let names = code.split(|letter: char| !letter.is_ascii_alphanumeric()).map(str::to_lowercase);
        let names: BTreeSet<String> = names.collect();
        let old = OLD_WORDS
            .iter()
            .chain(&OTHER_OLD_WORDS)
            .filter(|(folder, word, _)| file.starts_with(folder) && names.contains(*word));
        wrong.extend(old.map(|(_, word, now)| format!("{place}: `{word}` is called {now}")));
    }
    fail_with("words that are not those of docs/src/theory/vocabulary.md", &wrong);
}

/// Rooms whose doc comments begin with the noun of what they describe.
const PLAIN_ROOMS: [&str; 12] = [
    "plm-macros/cas/src/",
    "plm-macros/compiler/src/",
    "plm-macros/src/",
    "plm-foreign/src/",
    "plm-analysis/src/stabilise/",
    "src/live",
    "plm-run/src/any_sim.rs",
    "plm-analysis/src/auto.rs",
    "plm-study/src/batch.rs",
    "src/lanes.rs",
    "src/starts.rs",
    "plm-view/src/chart/",
];
/// First words of sentences that have no noun.
const NO_NOUN: [&str; 3] = ["What ", "Whether ", "The same"];

#[test]
fn doc_comments_begin_with_their_noun() {
    let mut wrong = Vec::new();
    for (file, place, line) in lines(files(&["rs"])) {
        let marks = ["/// ", "//! "].iter().find_map(|mark| line.trim_start().strip_prefix(mark));
        let has_none = marks.is_some_and(|text| NO_NOUN.iter().any(|word| text.starts_with(word)));
        if has_none && PLAIN_ROOMS.iter().any(|room| file.starts_with(room)) {
            wrong.push(format!("{place}: {}", line.trim()));
        }
    }
    fail_with("doc comments that do not begin with the noun of what they describe", &wrong);
}
