//! The equations as sums on two sides.

use crate::collect::CollectVec;
use plm_cas::Expr;

use super::formula::{Formula, Signed, Writer, product};
use super::name::Name;
use crate::derive::Equations;
use crate::formulate::{Row, Textbook};
use crate::model::Model;

/// A side of an equation: its terms.
pub(super) type Side = Vec<Signed>;

/// Equations of motion, constraints, and rates of first-order states.
pub(super) fn equations(model: &Model, own: &Equations, all: &Textbook, writer: &Writer) -> Vec<[Side; 2]> {
    let multipliers = multipliers(model, all);
    let mut found = Vec::new();
    for (i, row) in all.rows.iter().enumerate() {
        let left = left(row, all, writer);
        let mut right: Side = row.applied.iter().flat_map(|&force| writer.terms(force)).collect_vec();
        for (condition, name) in all.conditions.iter().zip(&multipliers) {
            for &(_, entry) in condition.along.iter().filter(|(along, _)| *along == i) {
                let (minus, formula) = times(writer.signed(entry, 0), [Formula::Name(name.clone())]);
                right.push((!minus, formula));
            }
        }
        found.push([left, right]);
    }
    for condition in &all.conditions {
        found.push([mostly_positive(writer.terms(condition.phi)), Vec::new()]);
    }
    for (&state, &rate) in own.x.iter().zip(&own.x_dot) {
        found.push([vec![(false, Formula::Name(writer.name(state).dotted(1)))], writer.terms(rate)]);
    }
    found
}

/// The terms of what is zero, with the signs of which most are positive.
fn mostly_positive(mut terms: Side) -> Side {
    if 2 * terms.iter().filter(|(minus, _)| *minus).count() > terms.len() {
        for (minus, _) in &mut terms {
            *minus = !*minus;
        }
    }
    if let Some(first) = terms.iter().position(|(minus, _)| !minus) {
        terms[..=first].rotate_right(1);
    }
    terms
}

/// Second derivatives, then products of rates, then the weight.
fn left(row: &Row, all: &Textbook, writer: &Writer) -> Side {
    let mut left = Vec::new();
    let symbol = |coordinate: usize, dots| writer.name(all.value[coordinate]).dotted(dots);
    for &(j, mass) in &row.mass {
        left.push(times(writer.signed(mass, 0), [Formula::Name(symbol(j, 2))]));
    }
    for &([j, k], coefficient) in &row.turning {
        let [first, second] = [j, k].map(|of| Formula::Name(symbol(of, 1)));
        let rates = if j == k { vec![Formula::Power(Box::new(first), 2)] } else { vec![first, second] };
        left.push(times(writer.signed(coefficient, 0), rates));
    }
    left.extend(row.still.iter().flat_map(|&term: &Expr| writer.terms(term)));
    left
}

/// A product with further factors. A sum of negative terms is subtracted as a sum of positive ones.
fn times((minus, formula): Signed, factors: impl IntoIterator<Item = Formula>) -> Signed {
    let (mut minus, mut all) = (
        minus,
        match formula {
            Formula::Product(own) => own,
            other => vec![other],
        },
    );
    if let [Formula::Sum(terms)] = &mut all[..]
        && terms.iter().all(|(negative, _)| *negative)
    {
        for (negative, _) in terms {
            *negative = false;
        }
        minus = !minus;
    }
    // In front of functions, whose argument a letter behind them would seem to be.
    let is_function = |factor: &Formula| match factor {
        Formula::Power(base, _) => matches!(**base, Formula::Call(..)),
        factor => matches!(factor, Formula::Call(..)),
    };
    let place = all.iter().position(is_function).unwrap_or(all.len());
    all.splice(place..place, factors);
    (minus, product(all))
}

/// Names of multipliers; with numbers where a part has several.
fn multipliers(model: &Model, all: &Textbook) -> Vec<Name> {
    let count = |part: usize| all.conditions.iter().filter(|other| other.part == part).count();
    let name = |(k, condition): (usize, &crate::formulate::Condition)| {
        let before = all.conditions[..k].iter().filter(|other| other.part == condition.part).count();
        let number = (count(condition.part) > 1).then_some(before + 1);
        Name::multiplier(&model.parts[condition.part].name.text, number)
    };
    all.conditions.iter().enumerate().map(name).collect_vec()
}
