//! Lift: numbers become parameters. Those under a hand do so for as long as it holds them, so that a drag sets values of a mechanism that
//! was compiled once.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::edit::{Edit, applied};
use crate::insert::opening;
use crate::number::{Change, Literal};
use crate::refusal::Refusal;
use crate::rules::Dragged;
use crate::sheet::Sheet;

/// A text with parameters in the place of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Lifted {
    /// The text.
    pub text: String,
    /// Names of the parameters, in the order of the changes.
    pub parameters: Vec<String>,
}

/// The names of the parameters begin so, and pages hide them.
pub const LIFTED: &str = "plm_drag_";

/// The text with parameters in the place of the numbers that a drag changes.
pub(crate) fn lifted(sheet: &Sheet<'_>, dragged: &Dragged) -> Result<Lifted, Refusal> {
    let parameters: Vec<String> = (0..dragged.changes.len()).map(|at| format!("{LIFTED}{at}")).collect();
    let literals = dragged.changes.iter().map(|Change { literal, .. }| literal);
    let named: Vec<(&Literal, &str)> = literals.zip(parameters.iter().map(String::as_str)).collect();
    let declared: Vec<String> = named.iter().map(|of| format!(" {}", declaration(sheet, of))).collect();
    let mut edits = replaced(sheet, &named);
    let open = opening(sheet)?;
    edits.insert(open, (open..open, declared.concat()));
    let edits: Vec<Edit> = edits.into_values().map(|(range, new)| Edit::new(range, new)).collect();
    Ok(Lifted { text: applied(sheet.text, &edits), parameters })
}

/// The declaration of a number as a parameter.
pub(crate) fn declaration(sheet: &Sheet<'_>, (literal, name): &(&Literal, &str)) -> String {
    let number = sheet.text.get(literal.range.clone()).unwrap_or_default();
    let unit = &literal.unit.text;
    format!("param {name}: {unit} = {number} {unit};")
}

/// Numbers with names in their place, by where they stand.
pub(crate) fn replaced(
    sheet: &Sheet<'_>,
    named: &[(&Literal, &str)],
) -> BTreeMap<usize, (Range<usize>, String)> {
    let of = |literal: &Literal| {
        named.iter().find(|(known, _)| known.range == literal.range).map(|(_, name)| (*name).to_owned())
    };
    let mut replaced = BTreeMap::new();
    for (numbers, pair) in sheet.shared_pairs() {
        if numbers.iter().all(|number| of(number).is_none()) {
            continue;
        }
        // The unit behind a pair would be that of the parameter too.
        let part = |literal: &Literal| {
            let number = sheet.text.get(literal.range.clone()).unwrap_or_default();
            of(literal).unwrap_or_else(|| format!("{number} {}", literal.unit.text))
        };
        let [x, y] = numbers.each_ref().map(part);
        replaced.insert(pair.start, (pair, format!("({x}, {y})")));
    }
    for (literal, name) in named {
        let range = &literal.whole;
        if !replaced.values().any(|(pair, _): &(Range<usize>, String)| pair.contains(&range.start)) {
            replaced.insert(range.start, (range.clone(), (*name).to_owned()));
        }
    }
    replaced
}
