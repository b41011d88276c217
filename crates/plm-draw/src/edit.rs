//! Edits of a text.

use std::ops::Range;

/// A range of a text, and what stands there instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// In bytes of the text before all edits.
    pub range: Range<usize>,
    /// The new text.
    pub text: String,
}

impl Edit {
    /// A replacement.
    pub fn new(range: Range<usize>, text: impl Into<String>) -> Edit {
        Edit { range, text: text.into() }
    }

    /// New text at a place.
    pub fn insertion(at: usize, text: impl Into<String>) -> Edit {
        Edit::new(at..at, text)
    }
}

/// Edits in the order of their places; those of one place stay as they were.
pub(crate) fn in_order(mut edits: Vec<Edit>) -> Vec<Edit> {
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    edits
}

/// A text after edits, which are disjoint and in the order of their places.
#[must_use]
pub fn applied(text: &str, edits: &[Edit]) -> String {
    let (mut made, mut at) = (String::new(), 0);
    for Edit { range, text: new } in edits {
        made += text.get(at..range.start).unwrap_or_default();
        made += new;
        at = range.end;
    }
    made + text.get(at..).unwrap_or_default()
}

/// The edits of the edited text that give the text before back.
#[must_use]
pub fn inverse(text: &str, edits: &[Edit]) -> Vec<Edit> {
    let (mut grown, mut shrunk) = (0, 0);
    let back = |Edit { range, text: new }: &Edit| {
        let start = range.start + grown - shrunk;
        grown += new.len();
        shrunk += range.len();
        Edit::new(start..start + new.len(), text.get(range.clone()).unwrap_or_default())
    };
    edits.iter().map(back).collect()
}

/// Edits that make one text of another: where lines differ, from the first letter to the last one.
pub(crate) fn difference(before: &str, after: &str) -> Vec<Edit> {
    let (old, new) = (lines(before), lines(after));
    let common = common_lines(&old, &new);
    let mut edits = Vec::new();
    let (mut i, mut j) = (0, 0);
    let mut at = 0;
    for (next_i, next_j) in common.into_iter().chain([(old.len(), new.len())]) {
        let removed: usize = old[i..next_i].iter().map(|line| line.len()).sum();
        let inserted = new[j..next_j].concat();
        if removed > 0 || !inserted.is_empty() {
            edits.push(tight(before, Edit::new(at..at + removed, inserted)));
        }
        at += removed + old.get(next_i).map_or(0, |line| line.len());
        (i, j) = (next_i + 1, next_j + 1);
    }
    edits
}

/// Lines with their ends.
fn lines(text: &str) -> Vec<&str> {
    text.split_inclusive('\n').collect()
}

/// Pairs of equal lines in the order of both: a longest common subsequence (R. A. Wagner, M. J. Fischer, The string-to-string
/// correction problem, 1974). Lines at both ends that are equal need no table.
fn common_lines(old: &[&str], new: &[&str]) -> Vec<(usize, usize)> {
    let head = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let tail = old[head..].iter().rev().zip(new[head..].iter().rev()).take_while(|(a, b)| a == b).count();
    let (inner, other) = (&old[head..old.len() - tail], &new[head..new.len() - tail]);
    let width = other.len() + 1;
    let mut longest = vec![0_usize; (inner.len() + 1) * width];
    for i in (0..inner.len()).rev() {
        for j in (0..other.len()).rev() {
            longest[i * width + j] = if inner[i] == other[j] {
                longest[(i + 1) * width + j + 1] + 1
            } else {
                longest[(i + 1) * width + j].max(longest[i * width + j + 1])
            };
        }
    }
    let mut pairs: Vec<(usize, usize)> = (0..head).map(|k| (k, k)).collect();
    let (mut i, mut j) = (0, 0);
    while i < inner.len() && j < other.len() {
        if inner[i] == other[j] {
            pairs.push((head + i, head + j));
            (i, j) = (i + 1, j + 1);
        } else if longest[(i + 1) * width + j] >= longest[i * width + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs.extend((0..tail).map(|k| (old.len() - tail + k, new.len() - tail + k)));
    pairs
}

/// Without the letters at both ends that stay.
fn tight(before: &str, Edit { range, text }: Edit) -> Edit {
    let old = before.get(range.clone()).unwrap_or_default();
    let head = old.char_indices().zip(text.chars()).find(|((_, a), b)| a != b).map(|((at, _), _)| at);
    let head = head.unwrap_or(old.len().min(text.len()));
    let (old, new) = (&old[head..], &text[head..]);
    let equal = old.chars().rev().zip(new.chars().rev()).take_while(|(a, b)| a == b);
    let tail: usize = equal.map(|(letter, _)| letter.len_utf8()).sum();
    Edit::new(range.start + head..range.end - tail, &new[..new.len() - tail])
}

/// The range in the text as declared of one in the text as read, which has brackets that were missing, and lines that end as on Unix.
pub fn as_declared(read: &str, declared: &str, range: Range<usize>) -> Range<usize> {
    if read == declared {
        return range;
    }
    let place = |end: usize| {
        let mut rest = declared.chars().peekable();
        let mut bytes = 0;
        for letter in read.get(..end).unwrap_or(read).chars() {
            if letter == '\n' && rest.next_if_eq(&'\r').is_some() {
                bytes += 1;
            }
            if rest.next_if_eq(&letter).is_some() {
                bytes += letter.len_utf8();
            }
        }
        bytes
    };
    place(range.start)..place(range.end)
}

#[cfg(test)]
mod tests {
    use super::{Edit, applied, as_declared, difference, inverse};

    #[test]
    fn places_of_a_file_from_windows_are_its_own() {
        let declared = "a\r\n{\r\n(1; }\r\nb";
        let read = "a\n{\n(1; )}\nb";
        assert_eq!(as_declared(read, declared, 11..12), 13..14);
        assert_eq!(declared.get(13..14), Some("b"));
    }

    #[test]
    fn edits_are_taken_back_to_the_byte() {
        let text = "pub é { a; b; }";
        let edits = [Edit::new(4..6, "P"), Edit::insertion(9, "x;\n"), Edit::new(10..12, "")];
        let made = applied(text, &edits);
        assert_eq!(made, "pub P { x;\nab; }");
        assert_eq!(applied(&made, &inverse(text, &edits)), text);
    }

    #[test]
    fn a_difference_makes_one_text_of_another() {
        let texts = ["", "a\n", "a\nb\nc\n", "a\nB\nc\nd\n", "x\nb\n", "é\nb\nc", "ê\nb\nc"];
        for before in texts {
            for after in texts {
                let edits = difference(before, after);
                assert_eq!(applied(before, &edits), after, "{before:?} {after:?}");
                assert_eq!(applied(after, &inverse(before, &edits)), before);
            }
        }
        assert_eq!(difference("a: 1,\nb\n", "a: 12,\nb\n"), [Edit::insertion(4, "2")]);
    }
}
