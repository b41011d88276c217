//! Mistakes in what a user asks for by name, and which name was meant.

use std::fmt;

/// A mistake on the command line, or in what stands for it elsewhere.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct BadOption(String);

impl BadOption {
    /// A mistake that a program finds by itself, with its text.
    pub fn new(what: impl Into<String>) -> Self {
        Self(what.into())
    }
}

impl fmt::Debug for BadOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for BadOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadOption {}

/// The name that differs from a given one in the fewest letters, if they are few.
pub fn nearest<'a>(word: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let near = names.map(|name| (distance(word, name), name)).min_by_key(|(distance, _)| *distance);
    near.filter(|(distance, name)| *distance <= 1 + name.len() / 4).map(|(_, name)| name)
}

/// How many letters have to be changed, added or left out (Levenshtein's distance).
fn distance(from: &str, to: &str) -> usize {
    let mut row: Vec<usize> = (0..=to.chars().count()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut before = i;
        let mut left = i + 1;
        for (at, b) in row.iter_mut().skip(1).zip(to.chars()) {
            let changed = before + usize::from(!a.eq_ignore_ascii_case(&b));
            before = *at;
            left = changed.min(left + 1).min(before + 1);
            *at = left;
        }
        if let Some(first) = row.first_mut() {
            *first = i + 1;
        }
    }
    row.last().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::distance;

    #[test]
    fn distances_are_those_of_levenshtein() {
        for (from, to, expected) in
            [("kitten", "sitting", 3), ("", "abc", 3), ("until", "untill", 1), ("flaw", "lawn", 2)]
        {
            assert_eq!((distance(from, to), distance(to, from)), (expected, expected), "{from} {to}");
        }
    }
}
