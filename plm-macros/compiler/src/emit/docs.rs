//! Documentation of the emitted items: equations, shapes, units, counts.

use plm_cas::{Count, Expr, Number};

use super::{Emission, push};
use crate::units::DisplayUnit;

/// Constraint rows that a table shows; a long chain repeats itself.
const MOST_ROWS: usize = 24;

/// `///` lines.
pub(crate) fn lines(text: &mut String, indent: usize, docs: &[String]) {
    for doc in docs {
        push(text, format_args!("{:indent$}/// {}\n", "", doc.trim()));
    }
}

/// Documentation of a field: the user's own words, or what it is; then the unit, and what else there is to say.
pub(crate) fn field(text: &mut String, docs: &[String], what: &str, unit: &DisplayUnit, more: &str) {
    let unit = si(unit);
    if docs.is_empty() {
        push(text, format_args!("        /// {what}, {unit}{more}.\n"));
    } else {
        lines(text, 8, docs);
        push(text, format_args!("        ///\n        /// In {unit}{more}.\n"));
    }
}

/// What a value is unless it is set: a number in the unit that it was declared in, else its expression.
pub(crate) fn by_default(value: Expr, unit: &DisplayUnit) -> String {
    let in_unit = value.as_number().and_then(|number| number.div(unit.factor));
    let Some(number) = in_unit.map(Number::to_f64) else {
        return format!("; `{value}` by default");
    };
    let size = number.abs();
    let number =
        if number == 0.0 || (1e-4..1e9).contains(&size) { number.to_string() } else { format!("{number:e}") };
    let space = if unit.text.is_empty() { "" } else { " " };
    format!("; {number}{space}{} by default", unit.text)
}

/// The user's lints are not for code that no user writes.
pub(crate) const ALLOWED: &str =
    "#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]";

/// Documentation of the module.
pub(crate) fn module(emission: &Emission) -> String {
    let Emission { model, report, .. } = emission;
    let mut text = String::new();
    lines(&mut text, 0, &model.docs);
    if !model.docs.is_empty() {
        text.push_str("///\n");
    }
    for line in report.summary() {
        push(&mut text, format_args!("/// {line}\n"));
    }
    text.push_str(&rows(emission));
    text
}

/// The table of constraints.
fn rows(emission: &Emission) -> String {
    let Emission { model, .. } = emission;
    let mut text = String::new();
    if model.rows.is_empty() {
        return text;
    }
    text.push_str(
        "///\n/// | row | constraint | equation | unit |\n/// |----:|------------|----------|------|\n",
    );
    for (k, row) in model.rows.iter().enumerate().take(MOST_ROWS) {
        let equation = row.phi.to_string().replace('|', "\\|");
        push(
            &mut text,
            format_args!("/// | {k} | `{}` | `{equation} = 0` | {} |\n", row.name, row.unit.text),
        );
    }
    if model.rows.len() > MOST_ROWS {
        push(&mut text, format_args!("///\n/// … and {} rows more.\n", model.rows.len() - MOST_ROWS));
    }
    text
}

/// The counts as a constant expression.
pub(crate) fn operations(count: &Count) -> String {
    let Count { add, mul, div, neg, sqrt, sin_cos, select, other } = count;
    format!(
        "Operations {{ add: {}, mul: {mul}, div: {div}, sqrt: {sqrt}, sin_cos: {sin_cos}, other: {} }}",
        add + neg,
        select + other
    )
}

/// The SI unit of a quantity, in words.
pub(crate) fn si(unit: &DisplayUnit) -> String {
    let name = DisplayUnit::si(unit.dimension).text;
    if name.is_empty() { "no unit".to_owned() } else { name }
}
