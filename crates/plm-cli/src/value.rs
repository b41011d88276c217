//! Values of parameters and inputs as they stand on a command line: `20cm`, `3 N*m`, `-0.5`.

use plm_compiler::diag::{Code, Diagnostic, Diagnostics, NoteKind};
use plm_compiler::syntax::ast::{ExprKind, ItemKind};
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_compiler::units::Dimension;

/// A value in SI of a quantity that has this SI unit; without a unit of its own it is in SI. With one it has the bits that a
/// declaration has of the same text.
///
/// # Errors
/// It is no finite number, its unit is unknown or that of another quantity: a message.
pub fn value(text: &str, si: &str) -> Result<f64, String> {
    let text = text.trim();
    let (number, unit) = split(text).ok_or_else(|| format!("`{text}` is no number with a unit"))?;
    let plain = number.parse::<f64>().ok().filter(|number| number.is_finite());
    let plain = plain.ok_or_else(|| format!("`{number}` is no finite number"))?;
    if unit.is_empty() {
        return Ok(plain);
    }
    // The compiler takes digits in front of a point, and a sign as an operator.
    let digits = number.trim_start_matches(['+', '-']);
    let digits = if digits.starts_with('.') { format!("0{digits}") } else { digits.to_owned() };
    let found = quantity(&digits, unit, if si.is_empty() { "1" } else { si })?;
    Ok(if number.starts_with('-') { -found } else { found })
}

/// Reads a value of a quantity with a declared unit, whose values times `factor` are in SI: a number alone is in that unit.
///
/// # Errors
/// As [`value`].
pub(crate) fn declared_value(text: &str, si: &str, factor: f64) -> Result<f64, String> {
    let is_alone = split(text.trim()).is_some_and(|(_, unit)| unit.is_empty());
    // By one it keeps its sign of zero, and its bits.
    value(text, si).map(|value| if is_alone { value * factor } else { value })
}

/// The longest number at the beginning, and the rest without blanks around it.
fn split(text: &str) -> Option<(&str, &str)> {
    // Not `inf` or `nan`, which are numbers to Rust.
    text.trim_start_matches(['+', '-'])
        .starts_with(|first: char| first == '.' || first.is_ascii_digit())
        .then_some(())?;
    let ends = text.char_indices().map(|(at, letter)| at + letter.len_utf8());
    let end = ends.rev().find(|end| text[..*end].parse::<f64>().is_ok())?;
    Some((&text[..end], text[end..].trim()))
}

/// A number in a unit, where a quantity of this SI unit is wanted.
fn quantity(digits: &str, unit: &str, si: &str) -> Result<f64, String> {
    let unread = || format!("`{unit}` is no unit");
    let text = format!("pub Values {{ param given: {unit} = {digits}; param wanted: {si}; }}");
    let mut sources = Sources::new();
    let id = sources.add_text("value", &text);
    let mut diagnostics = Diagnostics::new();
    let declaration = parse(sources.get(id).ok_or_else(unread)?, &mut diagnostics);
    if let Some(mistake) = diagnostics.sorted().first() {
        let is_of_unit = matches!(mistake.code, Code::UnknownUnit | Code::BadUnit);
        return Err(if is_of_unit { told(mistake) } else { unread() });
    }
    let items = declaration.mechanism.map(|mechanism| mechanism.items).unwrap_or_default();
    // A text that ends the item and begins another one is no unit.
    let [given, wanted] = &items[..] else { return Err(unread()) };
    let (ItemKind::Param(given), ItemKind::Param(wanted)) = (&given.kind, &wanted.kind) else {
        return Err(unread());
    };
    let number = given.value.as_ref().map(|value| &value.kind);
    let (Some(of_given), Some(of_wanted), Some(ExprKind::Number(number))) =
        (&given.unit, &wanted.unit, number)
    else {
        return Err(unread());
    };
    if !is_of(of_given.dimension, of_wanted.dimension) {
        let [given, wanted] = [of_given, of_wanted].map(|unit| unit.dimension.describe());
        return Err(format!("{digits} {unit} is {given}, and {wanted} is wanted"));
    }
    Ok((*number * of_given.factor).to_f64())
}

/// A message with its help and notes in a line.
fn told(mistake: &Diagnostic) -> String {
    let notes = mistake.notes.iter().map(|note| match note.kind {
        NoteKind::Help => format!(": {}", note.text),
        NoteKind::Note => format!("; {}", note.text),
    });
    mistake.message.clone() + &notes.collect::<String>()
}

/// Can a value of one dimension be given where another is wanted? The radian counts only where an angle is meant.
fn is_of(given: Dimension, wanted: Dimension) -> bool {
    given.same(wanted) && (given == wanted || !(given.is_angular() || wanted.is_angular()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::float_cmp, reason = "tests")]

    use super::value;

    /// The nearest numbers to the decimal values, and to pi/6.
    #[test]
    fn values_are_rounded_once() {
        for (text, si, expected) in [
            ("20cm", "m", 0.2),
            ("350 mm", "m", 0.35),
            ("-.5", "m", -0.5),
            ("-.5 km", "m", -500.0),
            ("+2e-3 kN*m", "N*m", 2.0),
            ("3 J", "N*m", 3.0),
            ("30deg", "rad", core::f64::consts::FRAC_PI_6),
            ("60 1/min", "1/s", 1.0),
            ("60 rev/min", "rad/s", core::f64::consts::TAU),
            ("2e3", "N*m/(rad/s)", 2000.0),
            ("1.5", "", 1.5),
        ] {
            assert_eq!(value(text, si), Ok(expected), "{text}");
        }
    }

    #[test]
    fn mistakes_are_named() {
        for (text, si, said) in [
            ("", "m", "`` is no number with a unit"),
            ("long", "m", "`long` is no number with a unit"),
            ("inf", "m", "`inf` is no number with a unit"),
            ("1e999", "m", "`1e999` is no finite number"),
            ("20 xm", "m", "unknown unit `xm`"),
            ("20 rpm", "rad/s", "unknown unit `rpm`: write `rev/min`"),
            ("20 kg", "m", "20 kg is a mass (kg), and a length (m) is wanted"),
            ("20 1/s", "rad/s", "20 1/s is a frequency (1/s), and an angular velocity (rad/s) is wanted"),
            ("20 m", "", "20 m is a length (m), and a number is wanted"),
            ("20 m; } pub B {", "m", "`m; } pub B {` is no unit"),
            ("20 m + 3 m", "m", "`m + 3 m` is no unit"),
        ] {
            let found = value(text, si).unwrap_err();
            assert!(found.starts_with(said), "{text}: {found}");
        }
    }
}
