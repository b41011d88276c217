//! The equations of absolute coordinates, linearised where accelerations and multipliers are known.
//!
//! ```text
//! M a + phi_q^T lambda - Q = 0,   phi_q a - gamma = 0
//! ```
//!
//! Their derivatives by coordinates, velocities, accelerations and multipliers tie neighbours only. A multiplier is
//! eliminated behind the coordinates of its row: its pivot is then the sum of `phi_q^2 / m`, which masses make positive.

use std::collections::{BTreeMap, BTreeSet};

use plm_cas::{Expr, algebra};

use super::stabilised;
use crate::derive::Equations;
use crate::formulate::function::{Function, Section, stored};
use crate::formulate::order::minimum_degree_behind;
use crate::formulate::pattern::Pattern;
use crate::formulate::reduced::{Augmented, Part, placed};
use crate::model::Model;

/// The linearised equations; none where forces or rates read accelerations or multipliers, whose loop they would have to
/// hold.
pub(crate) fn linearised(model: &Model, equations: &Equations) -> Option<Augmented> {
    let Equations { q, v, a, x, lambda, mass, force, phi_q, x_dot, signals, .. } = equations;
    let unknown: BTreeSet<Expr> = a.iter().chain(lambda).copied().collect();
    let read = algebra::symbols(&[force.as_slice(), x_dot].concat());
    if !signals.is_empty() || read.iter().any(|symbol| unknown.contains(symbol)) {
        return None;
    }
    let (n, states) = (q.len(), x.len());
    let row_of = |row: usize| n + states + row;
    let mut residuals: Vec<Expr> = force.iter().map(|&force| -force).collect();
    let mut terms: BTreeMap<(usize, usize, Part), Expr> = BTreeMap::new();
    for (i, &mass) in mass.iter().enumerate() {
        residuals[i] += mass * a[i];
        terms.insert((i, i, Part::Acceleration), mass);
    }
    for (k, &rate) in x_dot.iter().enumerate() {
        residuals.push(-rate);
        terms.insert((n + k, n + k, Part::Rate), Expr::ONE);
    }
    for (row, (entries, gamma)) in phi_q.iter().zip(stabilised(model, equations)).enumerate() {
        let mut residual = -gamma;
        for &(i, entry) in entries {
            residuals[i] += entry * lambda[row];
            residual += entry * a[i];
            terms.insert((i, row_of(row), Part::Value), entry);
            terms.insert((row_of(row), i, Part::Acceleration), entry);
        }
        residuals.push(residual);
    }
    for (row, &residual) in residuals.iter().enumerate() {
        for (symbols, part, first) in [(q, Part::Position, 0), (v, Part::Velocity, 0), (x, Part::Value, n)] {
            for (k, slope) in algebra::gradient(residual, symbols) {
                terms.insert((row, first + k, part), slope);
            }
        }
    }
    let (different, terms) = placed(terms);
    let held = terms.iter().map(|term| (term.row, term.column));
    let pattern = Pattern::new(&order(residuals.len(), row_of(0), held.clone()), held);
    let sections = vec![Section::new(
        "Derivatives of M a + phi_q^T lambda - Q, phi_q a - gamma, and of rates",
        different.clone(),
    )];
    let coefficients = Function { sections, results: stored("c", different.iter()) }.optimise();
    Some(Augmented { coefficients, accelerations: a.clone(), states, terms, pattern })
}

/// Minimum degree of the symmetric pattern that holds these entries, rows from `first` on behind all that they meet.
fn order(count: usize, first: usize, held: impl Iterator<Item = (usize, usize)>) -> Vec<usize> {
    let mut near = vec![BTreeSet::new(); count];
    for (row, column) in held.filter(|(row, column)| row != column) {
        near[row].insert(column);
        near[column].insert(row);
    }
    let behind = near.clone().into_iter().enumerate();
    let behind = behind.map(|(row, near)| if row < first { BTreeSet::new() } else { near }).collect();
    minimum_degree_behind(near, behind).map(|(pivot, _)| pivot).collect()
}
