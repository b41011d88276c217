//! Documentation of the emitted items: equations, shapes, units, counts.

use crate::collect::{MapEach, PushAll};
use plm_cas::{Count, Expr, Number};
use proc_macro2::TokenStream;

use super::Emission;
pub(super) use crate::facts::quantities::trimmed;
use crate::units::DisplayUnit;

/// Constraint rows that a table shows; a long chain repeats itself.
const MOST_ROWS: usize = 24;

/// The user's lints are not for code that no user writes.
pub(super) const ALLOWED: &str = "#[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, unused, unreachable_pub)]\n";

/// A text as documentation, line by line.
pub(super) fn docs(emission: &Emission, text: &str) -> TokenStream {
    emission.text(comment(text))
}

/// `///` lines.
pub(super) fn comment(text: &str) -> String {
    text.lines()
        .map(|line| if line.is_empty() { "///\n".to_owned() } else { format!("/// {line}\n") })
        .collect()
}

/// Documentation of a field: the user's own words, or what it is; then the unit, and what else there is to say.
pub(super) fn field(own: &[String], what: &str, unit: &DisplayUnit, more: &str) -> String {
    let unit = si(unit);
    if own.is_empty() {
        comment(&format!("{what}, {unit}{more}."))
    } else {
        comment(&format!("{}\n\nIn {unit}{more}.", trimmed(own)))
    }
}

/// Default of a value in words: a number in the unit that it was declared in, else its expression.
pub(super) fn by_default(value: Expr, unit: &DisplayUnit) -> String {
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

/// Documentation of the module: the user's own, what was found and chosen, the table of constraints.
pub(super) fn module(emission: &Emission) -> TokenStream {
    let Emission { model, report, .. } = emission;
    let mut lines = Vec::new();
    if !model.docs.is_empty() {
        lines.push_all([trimmed(&model.docs), String::new()]);
    }
    lines.extend(report.summary());
    if !model.rows.is_empty() {
        let head = ["", "| row | constraint | equation | unit |", "|----:|------------|----------|------|"];
        lines.push_all(head.map_each(str::to_owned));
    }
    for (k, row) in model.rows.iter().enumerate().take(MOST_ROWS) {
        let equation = row.phi.to_string().replace('|', "\\|");
        lines.push(format!("| {k} | `{}` | `{equation} = 0` | {} |", row.name, row.unit.text));
    }
    if model.rows.len() > MOST_ROWS {
        lines.push(format!("\n… and {} rows more.", model.rows.len() - MOST_ROWS));
    }
    docs(emission, &lines.join("\n"))
}

/// The counts as a constant expression.
pub(super) fn operations(count: &Count) -> String {
    let kinds = count.operations.kinds().map_each(|(kind, count)| format!("{kind}: {count}"));
    format!("Operations {{ {} }}", kinds.join(", "))
}

/// The SI unit of a quantity, in words.
pub(super) fn si(unit: &DisplayUnit) -> String {
    let name = DisplayUnit::si(unit.dimension).text;
    if name.is_empty() { "no unit".to_owned() } else { name }
}
