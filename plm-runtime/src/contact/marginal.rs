//! Marginal inequalities of a combination of modes: one that is zero is satisfied if it does not fall along the motion.
//!
//! The order is lexicographic, value before rate (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996).

use super::candidates::{MARGINAL, Margins, Solution};
use super::margins::stick;
use super::modes::Mode;
use super::multipliers::multipliers;
use super::rows::{Rows, below};
use crate::dual::Dual;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Time, s, within which a margin that comes to zero counts as zero: the accuracy of event times.
const AT_ONCE: f64 = 1e-10;
/// Largest marginal value, as a fraction of its terms, near a pose at which a row has no direction: rates have no bound there.
const MOST_MARGINAL: f64 = 1e-4;
/// Relative difference of the derivatives of two event times below which the events coincide on either side.
const SAME: f64 = 1e-6;
/// Such a pose is near if the diagonal entry of D changes by its own size within this time, s.
const TURNS_WITHIN: f64 = 1e-6;
/// Rate of a margin, as a fraction of its terms, below which it is zero.
const NO_RATE: f64 = 1e-9;

/// True if a gap of this rate closes after the event at this time, or not at all; for numbers with one-sided derivatives. Smaller
/// differences of times are rounding.
pub(super) fn is_later<S: Real>((gap, rate): (S, S), time: S, length: S) -> bool {
    let (Some(opens), Some(moved)) = (gap.goes(), time.goes()) else { return false };
    opens > SAME * ((rate.to_f64() * moved).abs() + S::PRECISION * length.to_f64())
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
        let at_once = S::lit(AT_ONCE) * slope.abs();
        // Terms that are sums of large ones may be small, as for a point that leaves a sphere.
        let turns = S::lit(TURNS_WITHIN) * own.tangents[0].abs() >= own.value.abs();
        let at_once = if turns { at_once.min(S::lit(MOST_MARGINAL) * terms) } else { at_once };
        let none = (S::lit(MARGINAL) * terms).max(at_once);
        let is_marginal = value <= none && value >= -none;
        let is_met = value > none || is_marginal && slope >= -S::lit(NO_RATE) * size;
        // Numbers with one-sided derivatives leave the limit before time advances.
        let way = value.goes().filter(|way| is_marginal && way.abs() > MARGINAL * terms.to_f64());
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
