//! Words: old names that the vocabulary has replaced, and doc comments that begin with their noun.

use std::collections::BTreeSet;

use super::old_words::OLD_WORDS;
use super::{fail_with, files, lines};

#[test]
fn names_are_those_of_the_vocabulary() {
    let mut wrong = Vec::new();
    for (file, place, line) in lines(files(&["rs"])) {
        let code = line.split("//").next().unwrap_or("");
        let names = code.split(|letter: char| !letter.is_ascii_alphanumeric()).map(str::to_lowercase);
        let names: BTreeSet<String> = names.collect();
        let old =
            OLD_WORDS.iter().filter(|(folder, word, _)| file.starts_with(folder) && names.contains(*word));
        wrong.extend(old.map(|(_, word, now)| format!("{place}: `{word}` is called {now}")));
    }
    fail_with("words that are not those of docs/src/theory/vocabulary.md", &wrong);
}

/// Sources of packages: their doc comments begin with the noun of what they describe.
const PLAIN_ROOMS: [&str; 3] = ["crates/", "plm-", "src/"];
/// First words of sentences that have no noun.
const NO_NOUN: [&str; 4] = ["What ", "Whether ", "Where ", "The same"];

#[test]
fn doc_comments_begin_with_their_noun() {
    let mut wrong = Vec::new();
    for (file, place, line) in lines(files(&["rs"])) {
        let marks = ["/// ", "//! "].iter().find_map(|mark| line.trim_start().strip_prefix(mark));
        let has_none = marks.is_some_and(|text| NO_NOUN.iter().any(|word| text.starts_with(word)));
        let is_source = file.contains("src/") && PLAIN_ROOMS.iter().any(|room| file.starts_with(room));
        if has_none && is_source {
            wrong.push(format!("{place}: {}", line.trim()));
        }
    }
    fail_with("doc comments that do not begin with the noun of what they describe", &wrong);
}
