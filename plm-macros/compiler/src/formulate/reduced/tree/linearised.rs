//! The equations of few coordinates, linearised by the joint coordinates where the accelerations are known.
//!
//! `r = M a - Q` is zero along the motion, so `M da + (dr/dy) dy - (dQ/dy') dy' - (dQ/dx) dx = 0`: every coefficient is a
//! derivative of the mass matrix or of a force, none of a quotient, and most of them are zero: what acts between two parts
//! moves no other. Implicit methods eliminate these equations in the order of minimum degree
//! ([`Pattern`](crate::formulate::pattern::Pattern)).

use std::collections::{BTreeMap, BTreeSet};

use plm_cas::{Expr, algebra};

use super::augmented::{Augmented, Part, placed};
use crate::formulate::function::{Function, Section, stored};
use crate::formulate::order::minimum_degree;
use crate::formulate::pattern::Pattern;
use crate::formulate::reduced::inertia::Dense;
use crate::formulate::reduced::motion::Motion;

/// Lays out the linearised equations of first-order states `x`, whose rates are `x_dot`, and of the coordinates.
pub(crate) fn laid_out(motion: &Motion, dense: &Dense, x: &[Expr], x_dot: &[Expr]) -> Augmented {
    let n = motion.independent.len();
    let of_independent =
        |of: &[Expr]| motion.independent.iter().map(|&unknown| of[unknown]).collect::<Vec<Expr>>();
    let (y, y_dot) = (of_independent(&motion.value), of_independent(&motion.rate));
    let accelerations: Vec<Expr> = (0..n).map(|_| Expr::symbol("acceleration")).collect();
    let mut residuals: Vec<Expr> = dense.right_hand_side(motion).into_iter().map(|force| -force).collect();
    let mut terms: BTreeMap<(usize, usize, Part), Expr> = BTreeMap::new();
    for (&(i, j), &mass) in &dense.mass {
        residuals[i] += mass * accelerations[j];
        terms.insert((i, j, Part::Acceleration), mass);
        if i != j {
            residuals[j] += mass * accelerations[i];
            terms.insert((j, i, Part::Acceleration), mass);
        }
    }
    for (k, &rate) in x_dot.iter().enumerate() {
        residuals.push(-rate);
        terms.insert((n + k, n + k, Part::Rate), Expr::ONE);
    }
    for (row, &residual) in residuals.iter().enumerate() {
        for (symbols, part, first) in
            [(&y[..], Part::Position, 0), (&y_dot, Part::Velocity, 0), (x, Part::Value, n)]
        {
            for (k, slope) in algebra::gradient(residual, symbols) {
                terms.insert((row, first + k, part), slope);
            }
        }
    }
    let (different, terms) = placed(terms);
    let held = terms.iter().map(|term| (term.row, term.column));
    let pattern = Pattern::new(&order(n + x.len(), held.clone()), held);
    let sections =
        vec![Section::new("Derivatives of M a - Q and of the rates of the states", different.clone())];
    let coefficients = Function { sections, results: stored("c", different.iter()) }.optimise();
    Augmented { coefficients, accelerations, states: x.len(), terms, pattern }
}

/// Minimum degree of the symmetric pattern that holds these entries.
fn order(count: usize, held: impl Iterator<Item = (usize, usize)>) -> Vec<usize> {
    let mut near = vec![BTreeSet::new(); count];
    for (row, column) in held.filter(|(row, column)| row != column) {
        near[row].insert(column);
        near[column].insert(row);
    }
    minimum_degree(near).map(|(pivot, _)| pivot).collect()
}
