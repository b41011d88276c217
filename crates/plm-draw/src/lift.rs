//! Lift: numbers under the hand become parameters, so that a drag sets values of a mechanism that was compiled once.

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
    let mut declared = Vec::new();
    for (Change { literal, .. }, name) in dragged.changes.iter().zip(&parameters) {
        let number = sheet.text.get(literal.range.clone()).unwrap_or_default();
        let unit = &literal.unit.text;
        declared.push(format!(" param {name}: {unit} = {number} {unit};"));
    }
    let of = |literal: &Literal| {
        dragged
            .changes
            .iter()
            .position(|change| change.literal.range == literal.range)
            .map(|at| &parameters[at])
    };
    let mut replaced = BTreeMap::new();
    for (numbers, pair) in sheet.shared_pairs() {
        if numbers.iter().all(|number| of(number).is_none()) {
            continue;
        }
        // The unit behind a pair would be that of the parameter too.
        let part = |literal: &Literal| {
            let number = sheet.text.get(literal.range.clone()).unwrap_or_default();
            of(literal).cloned().unwrap_or_else(|| format!("{number} {}", literal.unit.text))
        };
        let [x, y] = numbers.each_ref().map(part);
        replaced.insert(pair.start, (pair, format!("({x}, {y})")));
    }
    for (Change { literal, .. }, name) in dragged.changes.iter().zip(&parameters) {
        let range = &literal.whole;
        if !replaced.values().any(|(pair, _): &(Range<usize>, String)| pair.contains(&range.start)) {
            replaced.insert(range.start, (range.clone(), name.clone()));
        }
    }
    let open = opening(sheet)?;
    replaced.insert(open, (open..open, declared.concat()));
    let edits: Vec<Edit> = replaced.into_values().map(|(range, new)| Edit::new(range, new)).collect();
    Ok(Lifted { text: applied(sheet.text, &edits), parameters })
}
