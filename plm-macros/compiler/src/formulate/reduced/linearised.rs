//! The equations of few coordinates, linearised by the joint coordinates where the accelerations are known.
//!
//! `r = M a - Q` is zero along the motion, so `M da + (dr/dy) dy - (dQ/dy') dy' - (dQ/dx) dx = 0`: every coefficient is a
//! derivative of the mass matrix or of a force, none of a quotient, and most of them are zero: what acts between two parts
//! moves no other. Implicit methods eliminate these equations in the order of minimum degree
//! ([`Pattern`](crate::formulate::pattern::Pattern)).

use crate::collect::CollectVec;
use plm_cas::Expr;

use super::inertia::Dense;
use super::motion::Motion;
use crate::formulate::function::Section;
use crate::formulate::linearised::{Augmented, Part, Terms, add_slopes};
use crate::formulate::order::minimum_degree_of;

/// Lays out the linearised equations of first-order states `x`, whose rates are `x_dot`, and of the coordinates.
pub(crate) fn laid_out(motion: &Motion, dense: &Dense, x: &[Expr], x_dot: &[Expr]) -> Augmented {
    let n = motion.independent.len();
    let (y, y_dot) = (motion.of_independent(&motion.value), motion.of_independent(&motion.rate));
    let accelerations: Vec<Expr> = (0..n).map(|_| Expr::symbol("acceleration")).collect_vec();
    let mut residuals = dense.residuals(motion, &accelerations);
    let mut terms = Terms::new();
    for (&(i, j), &mass) in &dense.mass {
        terms.insert((i, j, Part::Acceleration), mass);
        terms.insert((j, i, Part::Acceleration), mass);
    }
    for (k, &rate) in x_dot.iter().enumerate() {
        residuals.push(-rate);
        terms.insert((n + k, n + k, Part::Rate), Expr::ONE);
    }
    add_slopes(&mut terms, &residuals, [&y, &y_dot, x]);
    let unknowns = n + x.len();
    let order = minimum_degree_of(unknowns, unknowns, terms.keys().map(|&(row, column, _)| (row, column)));
    let title = "Derivatives of M a - Q and of the rates of the states";
    let sections = |different: &[Expr]| vec![Section::new(title, different.to_vec())];
    Augmented::new(terms, (accelerations, x.len()), &order, sections)
}
