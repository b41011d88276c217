//! Multipliers of the contact rows over an interval of time.
//!
//! For rows that slip and are bounded by a reaction in the plane, Newton's method solves lambda = F(e(lambda)) with the unit vectors e of
//! the reactions. Intervals E of unit vectors that F and e map into themselves contain a solution at each time, by Brouwer's theorem
//! (R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, SIAM 2009, chapter 8). E is found by widening the unit
//! vectors at the middle of the interval of time.

use super::loads::Load;
use super::modes::Mode;
use super::multipliers::{Multipliers, multipliers, multipliers_along};
use super::rows::{Rows, below, indices};
use crate::enclosure::{Enclosed, Interval};
use crate::scalar::Real;

/// Most trials of intervals of unit vectors.
const TRIES: u32 = 5;
/// Relative widening of intervals that do not contain their image.
const WIDER: f64 = 0.5;
/// Least widening, so that rounding does not leave an interval.
const LEAST: f64 = 1e-13;

/// Intervals of unit vectors of the reactions.
type Directions<S, const N: usize> = [[Enclosed<S>; 2]; N];

/// Multipliers in these modes anywhere in an interval; `None` if active rows may depend on each other, or if no enclosure is found.
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
            // A determinant depends on the unit vectors too, whose slopes are unknown.
            let determinant = Enclosed { slope: Interval::everything(), ..found.determinant };
            return Some(Multipliers { determinant, ..found });
        }
        tried = widened(&tried, &known);
    }
    None
}

/// Intervals that contain both and are wider. They have no slopes: d|R| = e . dR, since the change of a unit vector is perpendicular to it.
fn widened<S: Real, const N: usize>(a: &Directions<S, N>, b: &Directions<S, N>) -> Directions<S, N> {
    let wider = |a: Enclosed<S>, b: Enclosed<S>| {
        let value = a.value.hull(b.value);
        let by = S::lit(WIDER) * (value.high - value.low) + S::lit(LEAST);
        let value = Interval::between(value.low - by, value.high + by);
        Enclosed { middle: b.middle, value, slope: Interval::point(S::ZERO) }
    };
    core::array::from_fn(|load| core::array::from_fn(|k| wider(a[load][k], b[load][k])))
}

/// True if each outer interval contains the inner one; false for NaN.
fn holds<S: Real, const N: usize>(outer: &Directions<S, N>, inner: &Directions<S, N>) -> bool {
    let pairs = outer.as_flattened().iter().zip(inner.as_flattened());
    pairs.fold(true, |all, (outer, inner)| {
        all && outer.value.low <= inner.value.low && inner.value.high <= outer.value.high
    })
}
