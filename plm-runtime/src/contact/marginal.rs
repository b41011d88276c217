//! Marginal inequalities of a combination of modes: one that is zero is satisfied if it does not fall along the motion.
//!
//! The order is lexicographic, value before rate (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996).

use super::candidates::{Margins, Solution};
use super::margins::stick;
use super::modes::Mode;
use super::multipliers::multipliers;
use super::rows::{Rows, below};
use crate::dual::Dual;
use crate::scalar::{Real, Scalar};
use crate::tolerances::{AT_ONCE, MARGINAL, MOST_MARGINAL, NO_RATE, SAME_TIME, TURNS_WITHIN};
use crate::vector::Vector;

/// True if a gap of this rate closes after the event at this time, or not at all; for numbers with one-sided derivatives. Smaller
/// differences of times are rounding.
pub(super) fn is_later<S: Real>((gap, rate): (S, S), time: S, length: S) -> bool {
    let (Some(opens), Some(moved)) = (gap.goes(), time.goes()) else { return false };
    opens > SAME_TIME.get() * ((rate.to_f64() * moved).abs() + S::PRECISION * length.to_f64())
}

/// The margins that are negative, or zero and falling.
pub(super) fn broken<S: Real, const N: usize>(
    rows: &Rows<Dual<S, 1>, N>,
    solution: &Solution<S, N>,
    margins: &Margins<S, N>,
) -> [bool; N] {
    let Some(found) = multipliers(rows, &solution.modes) else { return [true; N] };
    let lambda = found.lambda;
    core::array::from_fn(|i| {
        let (value, Some(terms)) = (margins.value[i], margins.size[i]) else { return false };
        // Forces times D_ii: for a row without direction D is zero, and the force that would hold it is unbounded.
        let (acceleration, own) = (rows.acceleration(i, &lambda), rows.delassus[i][i]);
        let (margin, to_acceleration) = match solution.modes[i] {
            Mode::Closed => (held_force(rows, i, &lambda)[i], own.value),
            Mode::Sticks => {
                let [lower, upper] = stick(&rows.times(i, own), i, &held_force(rows, i, &lambda));
                (if lower.value < upper.value { lower } else { upper }, own.value)
            }
            Mode::Backwards => (-acceleration, S::lit(1.0)),
            _ => (acceleration, S::lit(1.0)),
        };
        let (value, terms) = (value * to_acceleration, terms * to_acceleration);
        let (slope, size) = (margin.tangents[0], size(rows, i, &lambda));
        let at_once = AT_ONCE.of::<S>() * slope.abs();
        // Terms that are sums of large ones may be small, as for a point that leaves a sphere.
        let turns = TURNS_WITHIN.of::<S>() * own.tangents[0].abs() >= own.value.abs();
        let at_once = if turns { at_once.min(MOST_MARGINAL.of::<S>() * terms) } else { at_once };
        let none = (MARGINAL.of::<S>() * terms).max(at_once);
        let is_marginal = value <= none && value >= -none;
        let is_met = value > none || is_marginal && slope >= -NO_RATE.of::<S>() * size;
        // Numbers with one-sided derivatives leave the limit before time advances.
        let way = value.goes().filter(|way| is_marginal && way.abs() > MARGINAL.get() * terms.to_f64());
        way.map_or(!is_met, |way| way < 0.0)
    })
}

/// Multipliers times D_ii; that of the row i follows from its equation: D_ii lambda_i = -(c_i + sum over j != i of D_ij lambda_j).
fn held_force<S: Real, const N: usize>(
    rows: &Rows<Dual<S, 1>, N>,
    i: usize,
    lambda: &[Dual<S, 1>; N],
) -> [Dual<S, 1>; N] {
    let i = below::<N>(i);
    let others: [_; N] = Vector::from_fn(|j| if j == i { Dual::ZERO } else { lambda[j] });
    let mut forces = others.map(|lambda| lambda * rows.delassus[i][i]);
    forces[i] = -rows.acceleration(i, &others);
    forces
}

/// Size of the terms of the rate of an acceleration.
fn size<S: Real, const N: usize>(rows: &Rows<Dual<S, 1>, N>, row: usize, lambda: &[Dual<S, 1>; N]) -> S {
    let row = below::<N>(row);
    let terms = rows.delassus[row].iter().zip(lambda);
    let moved = |sum: S, (d, lambda): (&Dual<S, 1>, &Dual<S, 1>)| {
        sum + (d.value * lambda.value).abs() + (d.value * lambda.tangents[0]).abs()
    };
    terms.fold(rows.free[row].value.abs() + rows.free[row].tangents[0].abs(), moved)
}
