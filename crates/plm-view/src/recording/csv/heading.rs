//! Headings of columns: names and units in their texts.

use super::super::Column;
use super::unit::{is_unit, spelled};

/// Names of the time, in small letters: in several languages, and in the files of LabVIEW.
const TIMES: [&str; 14] = [
    "time",
    "t",
    "zeit",
    "temps",
    "tempo",
    "tiempo",
    "tijd",
    "tid",
    "aika",
    "czas",
    "\u{432}\u{440}\u{435}\u{43c}\u{44f}",
    "\u{65f6}\u{95f4}",
    "\u{6642}\u{9593}",
    "x_value",
];

/// Units of the time. A number in one is multiplied by the first and divided by the second to be in s: 0.001 is no number of two's powers,
/// and 100 ms are to be 0.1 s.
const UNITS: [(&str, [f64; 2]); 15] = [
    ("s", [1.0, 1.0]),
    ("ms", [1.0, 1e3]),
    ("us", [1.0, 1e6]),
    ("ns", [1.0, 1e9]),
    ("min", [60.0, 1.0]),
    ("h", [3600.0, 1.0]),
    ("sec", [1.0, 1.0]),
    ("second", [1.0, 1.0]),
    ("seconds", [1.0, 1.0]),
    ("sek", [1.0, 1.0]),
    ("sekunden", [1.0, 1.0]),
    ("msec", [1.0, 1e3]),
    // Both letters that are read as micro.
    ("\u{b5}s", [1.0, 1e6]),
    ("\u{3bc}s", [1.0, 1e6]),
    ("minutes", [60.0, 1.0]),
];

/// The units of the time that messages name.
pub(super) fn known_times() -> String {
    UNITS[..6].iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

/// By what a time in a unit is multiplied and divided to be in s.
pub(super) fn of_time(unit: &str) -> Option<[f64; 2]> {
    UNITS.iter().find(|(own, _)| *own == unit).map(|(_, factors)| *factors)
}

/// Meaning of a heading with respect to the time.
pub(super) enum Heading {
    /// Another quantity.
    Other,
    /// The time, with factor and divisor that convert its numbers to s.
    Time([f64; 2]),
    /// The time in a unit that is not known.
    Unit,
}

impl Heading {
    pub(super) fn of(heading: &str) -> Self {
        let apart = |mark| heading.rsplit_once(mark);
        let is_time = |name: &str| TIMES.contains(&name.to_lowercase().as_str());
        if is_time(heading) {
            return Self::Time([1.0, 1.0]);
        }
        let parts = bracketed(heading)
            .or_else(|| apart("/"))
            .or_else(|| apart(" in "))
            .or_else(|| apart(", "))
            .or_else(|| apart("_"));
        let Some((name, unit)) = parts.map(|(name, unit)| (name.trim(), unit.trim())) else {
            return Self::Other;
        };
        if !is_time(name) {
            return Self::Other;
        }
        of_time(unit).map_or(Self::Unit, Self::Time)
    }
}

/// A unit between brackets, or as it is.
pub(super) fn without_brackets(unit: &str) -> &str {
    let within = |open, close| unit.strip_prefix(open).and_then(|rest: &str| rest.strip_suffix(close));
    within('[', ']').or_else(|| within('(', ')')).unwrap_or(unit).trim()
}

/// Name and unit of a heading with brackets at its end, which may have others within: `b (N/(m/s))`.
fn bracketed(heading: &str) -> Option<(&str, &str)> {
    let (open, close) = [('(', ')'), ('[', ']')].into_iter().find(|(_, close)| heading.ends_with(*close))?;
    let mut depth = 0_usize;
    let (at, _) = heading.char_indices().rfind(|(_, letter)| {
        depth += usize::from(*letter == close);
        depth = depth.saturating_sub(usize::from(*letter == open));
        depth == 0
    })?;
    let unit = heading.get(at + 1..heading.len() - 1)?;
    Some((heading.get(..at)?.trim_end(), unit.trim()))
}

/// Of a heading: `arm.angle (deg)`, `arm.angle [deg]`, `arm.angle(deg)`, `arm.angle / deg`, `arm.angle in deg`. Brackets without a blank
/// before them are part of a name unless a unit stands in them: `link[2]`.
pub(super) fn column(heading: &str) -> Column {
    let is_apart = |name: &str, unit: &str| {
        heading[name.len()..].starts_with(char::is_whitespace) || (!name.is_empty() && is_unit(unit))
    };
    let in_brackets = bracketed(heading).filter(|(name, unit)| is_apart(name, unit));
    let after = |mark: &str| {
        let (name, unit) = heading.split_once(mark)?;
        is_unit(unit.trim()).then(|| (name.trim(), unit.trim()))
    };
    let parts = in_brackets.or_else(|| after(" in ")).or_else(|| after("/"));
    let (name, unit) = parts.unwrap_or((heading, ""));
    (name, spelled(unit).as_str()).into()
}
