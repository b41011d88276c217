//! df/dx in independent coordinates, entry by entry.
//!
//! `M a - Q = 0` along the motion, so `M da = -(d(M a - Q)/dy) dy - ...` with the accelerations as they are: derivatives of
//! sums, none of a solution, and one factorisation for all columns.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, algebra};

use super::inertia::Dense;
use super::motion::Motion;
use crate::formulate::function::{Function, Place};
use crate::formulate::ldl::factorise;

/// The matrix of derivatives.
pub(crate) struct Jacobian {
    /// `by_x`: its entries that are not zero.
    pub(crate) entries: Function,
    /// Symbols of the second derivatives of the coordinates.
    pub(crate) accelerations: Vec<Expr>,
}

impl Jacobian {
    /// Does it take fewer operations than derivatives in dual numbers, beside the rate with so many?
    pub(crate) fn is_cheaper(&self, rate: usize, by_dual_numbers: usize) -> bool {
        rate + self.entries.tape().count().total() < by_dual_numbers
    }
}

/// Lays it out; `x` are the first-order states and `x_dot` their rates.
pub(crate) fn jacobian(motion: &Motion, dense: &Dense, x: &[Expr], x_dot: &[Expr]) -> Jacobian {
    let n = motion.independent.len();
    let [y, y_dot] = [&motion.value, &motion.rate].map_each(|of| motion.of_independent(of));
    let state = [y, y_dot, x.to_vec()].concat();
    let accelerations: Vec<Expr> = (0..n).map(|_| Expr::symbol("acceleration")).collect_vec();
    let mut dense = dense.clone();
    for (&(i, j), mass) in dense.mass.iter_mut() {
        *mass = mass.named(format!("m_{i}_{j}"));
    }
    let residuals = dense.residuals(motion, &accelerations);
    let mut results: Vec<(Place, Expr)> =
        (0..n).map(|i| (Place::Entry("by_x", i, n + i), Expr::ONE)).collect_vec();
    let factor = factorise(n, &dense.mass, None);
    let mut columns = vec![vec![Expr::ZERO; n]; state.len()];
    for (i, &residual) in residuals.iter().enumerate() {
        for (column, slope) in algebra::gradient(residual, &state) {
            columns[column][i] = -slope;
        }
    }
    let held = columns.iter().enumerate().filter(|(_, column)| column.iter().any(|slope| !slope.is_zero()));
    for (j, column) in held {
        let names: Vec<String> = (0..n).map(|i| format!("by_{i}_{j}")).collect_vec();
        let (solution, _) = factor.solve(column, &names);
        let entries = solution.into_iter().enumerate();
        results.push_all(entries.map(|(i, entry)| (Place::Entry("by_x", n + i, j), entry)));
    }
    for (k, &rate) in x_dot.iter().enumerate() {
        let slopes = algebra::gradient(rate, &state).into_iter();
        results.push_all(slopes.map(|(j, slope)| (Place::Entry("by_x", 2 * n + k, j), slope)));
    }
    let entries = Function::of_results(results).optimise();
    Jacobian { entries, accelerations }
}
