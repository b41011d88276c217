//! The equations of absolute coordinates, linearised where accelerations and multipliers are known.
//!
//! ```text
//! M a + phi_q^T lambda - Q = 0,   phi_q a - gamma = 0
//! ```
//!
//! Their derivatives by coordinates, velocities, accelerations and multipliers tie neighbours only. A multiplier is
//! eliminated after the coordinates of its row: its pivot is then the sum of `phi_q^2 / m`, which masses make positive.

use crate::collect::CollectVec;
use crate::sorted::SortedSet;

use plm_cas::{Expr, algebra};

use super::stabilised;
use crate::derive::Equations;
use crate::formulate::function::Section;
use crate::formulate::linearised::{Augmented, Part, Terms, add_slopes};
use crate::formulate::order::minimum_degree_of;
use crate::model::Model;

/// The linearised equations; none where forces or rates read accelerations or multipliers, whose loop they would have to
/// hold.
pub(crate) fn linearised(model: &Model, equations: &Equations) -> Option<Augmented> {
    let Equations { q, v, a, x, lambda, mass, force, phi_q, x_dot, signals, .. } = equations;
    let unknown: SortedSet<Expr> = a.iter().chain(lambda).copied().collect();
    let read = algebra::symbols(&[force.as_slice(), x_dot].concat());
    if !signals.is_empty() || read.iter().any(|symbol| unknown.contains(symbol)) {
        return None;
    }
    let (n, states) = (q.len(), x.len());
    let row_of = |row: usize| n + states + row;
    let mut residuals: Vec<Expr> = force.iter().map(|&force| -force).collect_vec();
    let mut terms = Terms::new();
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
    add_slopes(&mut terms, &residuals, [q, v, x]);
    let entries = terms.keys().map(|&(row, column, _)| (row, column));
    let order = minimum_degree_of(residuals.len(), row_of(0), entries);
    let title = "Derivatives of M a + phi_q^T lambda - Q, phi_q a - gamma, and of rates";
    let sections = |different: &[Expr]| vec![Section::new(title, different.to_vec())];
    Some(Augmented::new(terms, (a.clone(), states), &order, sections))
}
