//! Suggestions: the known name that is nearest to the one that was written.

use crate::collect::CollectVec;
use std::fmt::Write;

use super::Diagnostic;

/// The candidate nearest to a name, if one is near enough: at most a third of its letters differ (one at least), or one
/// of the two begins the other (three letters at least). One letter is not like another. The first of equals wins.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (name.chars().count() / 3).max(1);
    let (mut best, mut begun) = (None, None);
    for candidate in candidates {
        let distance = distance(name, candidate);
        let is_another_letter = distance > 0 && name.chars().count().min(candidate.chars().count()) == 1;
        if distance <= limit && !is_another_letter && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
        let shorter = name.len().min(candidate.len());
        if begun.is_none() && shorter >= 3 && name.get(..shorter) == candidate.get(..shorter) {
            begun = Some(candidate);
        }
    }
    best.map(|(_, candidate)| candidate).or(begun)
}

/// Number of letters to insert, delete, replace or swap with a neighbour (optimal string alignment), case ignored.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) =
        (a.to_lowercase().chars().collect_vec(), b.to_lowercase().chars().collect_vec());
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect_vec();
    for i in 0..a.len() {
        let mut row = vec![i + 1; b.len() + 1];
        for j in 0..b.len() {
            let replaced = above[j] + usize::from(a[i] != b[j]);
            row[j + 1] = replaced.min(above[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j] {
                row[j + 1] = row[j + 1].min(before[j - 1] + 1);
            }
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

/// Adds the nearest name as help, which may stand in the place of the span, and the list of names as a note. `what` is one of them,
/// "port", "name"; `all` begins the note: "ports of `arm`".
pub fn help_similar(diagnostic: &mut Diagnostic, name: &str, what: &str, all: &str, names: &[&str]) {
    if let Some(near) = nearest(name, names.iter().copied()) {
        let article = if what.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
        let text = match what {
            "name" => format!("a similar name exists: `{near}`"),
            _ => format!("{article} {what} with a similar name exists: `{near}`"),
        };
        // The span of a name with an index ends in front of the index.
        let is_plain = ![name, near].iter().any(|name| name.contains('['));
        let _ = if is_plain { diagnostic.help_with(text, near) } else { diagnostic.help(text) };
    }
    if !names.is_empty() {
        diagnostic.note(format!("{all}: {}", list(names)));
    }
}

/// Names in a row; a long list is cut.
pub fn list(names: &[&str]) -> String {
    const SHOWN: usize = 48;
    let mut text = names.iter().take(SHOWN).copied().collect_vec().join(", ");
    if names.len() > SHOWN {
        // Writing to a string does not fail.
        let _ = write!(text, ", … ({} more)", names.len() - SHOWN);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        assert_eq!(nearest("crnk", ["crank", "rod"]), Some("crank"));
        assert_eq!(nearest("revolut", ["prismatic", "revolute"]), Some("revolute"));
        assert_eq!(nearest("p13", ["o0", "p12"]), Some("p12"));
        assert_eq!(nearest("amr", ["arm"]), Some("arm"));
        assert_eq!(nearest("x", ["y", "z", "X"]), Some("X"));
        assert_eq!(nearest("x", ["y", "z"]), None);
        assert_eq!(nearest("mN", ["m", "N"]), None);
        assert_eq!(nearest("sinus", ["sign", "sin"]), Some("sin"));
        assert_eq!(nearest("stiff", ["damping", "stiffness"]), Some("stiffness"));
        assert_eq!(nearest("stiffness", ["damping", "rest"]), None);
    }
}
