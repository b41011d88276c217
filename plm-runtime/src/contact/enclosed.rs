//! Multipliers of the contact rows over an interval of time.
//!
//! Of rows that are bounded by a reaction in the plane and slip, Newton's method solves lambda = F(e(lambda)) with the unit vectors e of the
//! reactions. Intervals E of them that F and e map into themselves have a solution at each time, by Brouwer's theorem (R. E. Moore,
//! R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, SIAM 2009, chapter 8). E is found by widening the e in the middle.

use super::loads::Load;
use super::modes::Mode;
use super::multipliers::{Multipliers, multipliers, multipliers_along};
use super::rows::{Rows, below, indices};
use crate::enclosure::{Enclosed, Interval};
use crate::scalar::Real;

/// Intervals of unit vectors that are tried.
const TRIES: u32 = 5;
/// Those that do not hold what they are mapped to become wider by this fraction.
const WIDER: f64 = 0.5;
/// At least by so much, so that rounding does not leave them.
const LEAST: f64 = 1e-13;

/// Intervals of unit vectors of the reactions.
type Directions<S, const N: usize> = [[Enclosed<S>; 2]; N];

/// The multipliers in these modes anywhere in an interval; none where active rows may depend on each other, or where nothing encloses them.
pub(super) fn multipliers_within<S: Real, const N: usize>(
    rows: &Rows<Enclosed<S>, N>,
    modes: &[Mode; N],
) -> Option<Multipliers<Enclosed<S>, N>> {
    let slips = |row: usize| modes[below::<N>(row)].slips();
    let is_bound = |load: usize| {
        rows.load[load] == Load::Plane && indices::<N>().any(|row| slips(row) && rows.read[row][load])
    };
    let found = multipliers(rows, modes)?;
    if !indices::<N>().any(is_bound) {
        return Some(found);
    }
    let mut known = rows.directions(&found.lambda, slips);
    let mut tried = widened(&known, &known);
    for _ in 0..TRIES {
        let found = multipliers_along(rows, modes, &tried)?;
        known = rows.directions(&found.lambda, slips);
        if holds(&tried, &known) {
            // A determinant follows the unit vectors too, whose slopes are not known.
            let determinant = Enclosed { slope: Interval::everything(), ..found.determinant };
            return Some(Multipliers { determinant, ..found });
        }
        tried = widened(&tried, &known);
    }
    None
}

/// Intervals that hold both and are wider. They have no slopes: d|R| = e . dR, since a unit vector turns across itself.
fn widened<S: Real, const N: usize>(a: &Directions<S, N>, b: &Directions<S, N>) -> Directions<S, N> {
    let wider = |a: Enclosed<S>, b: Enclosed<S>| {
        let value = a.value.hull(b.value);
        let by = S::lit(WIDER) * (value.high - value.low) + S::lit(LEAST);
        let value = Interval::between(value.low - by, value.high + by);
        Enclosed { middle: b.middle, value, slope: Interval::point(S::ZERO) }
    };
    core::array::from_fn(|load| core::array::from_fn(|k| wider(a[load][k], b[load][k])))
}

/// Does each interval hold the other one? False for what is not a number.
fn holds<S: Real, const N: usize>(outer: &Directions<S, N>, inner: &Directions<S, N>) -> bool {
    let pairs = outer.as_flattened().iter().zip(inner.as_flattened());
    pairs.fold(true, |all, (outer, inner)| {
        all && outer.value.low <= inner.value.low && inner.value.high <= outer.value.high
    })
}
