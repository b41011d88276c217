//! Forces of rows that all slip, by sweeps of generated code, without a system of equations.

use super::modes::Modes;
use crate::scalar::Scalar;

/// Most sweeps. With a friction of a hundredth of that which would lock a joint five are needed.
const MOST: u32 = 30;
/// Change of the accelerations by the next sweep, in roundings, at which sweeps end.
const ROUNDED: f64 = 2.0;
/// Largest ratio of the changes of two successive sweeps.
const SWEPT: f64 = 0.5;

/// Signs of the slips of the rows, and stored signs of the reactions along a line; `None` if some row is a constraint, and for numbers
/// with derivatives, which need Newton's method.
#[must_use]
pub fn slipping<T: Scalar, const N: usize>(modes: &Modes<T, N>) -> Option<[[T; N]; 2]> {
    if T::HAS_DERIVATIVES || modes.hold() {
        return None;
    }
    let line = modes.negative.map(|negative| T::lit(if negative { -1.0 } else { 1.0 }));
    Some([modes.of.map(super::Mode::sign), line])
}

/// Forces of slipping rows, and the accelerations of the coordinates with them. Without the forces these are `free`. `sweep` takes forces
/// and accelerations and writes the next ones, which are final if `is_explicit`. `weights` make accelerations comparable. `None` if sweeps
/// do not converge, or if a `slope` of the limits is not positive, so that frictions lock each other.
#[inline]
pub fn slide<T: Scalar, const N: usize, const M: usize>(
    (slope, weights): (&[T; N], &[f64; M]),
    is_explicit: bool,
    free: [T; M],
    sweep: impl Fn(&[T; N], &[T; M], &mut [T; N], &mut [T; M]),
) -> Option<([T; N], [T; M])> {
    // False for NaN.
    let is_unlocked = slope.iter().all(|slope| slope.to_f64() > 0.0);
    if !is_unlocked {
        return None;
    }
    let (mut force, mut second) = ([T::ZERO; N], free);
    let (mut before, mut rounded) = (f64::INFINITY, 0.0);
    for sweeps in 0..MOST {
        let (mut next, mut changed) = ([T::ZERO; N], free);
        sweep(&force, &second, &mut next, &mut changed);
        let change = square(weights, |k| (changed[k] - second[k]).to_f64());
        (force, second) = (next, changed);
        if is_explicit {
            return Some((force, second));
        }
        if sweeps == 0 {
            let ulps = ROUNDED * T::PRECISION;
            rounded = ulps * ulps * (square(weights, |k| free[k].to_f64()) + change);
        } else if change * change <= rounded * before || change <= rounded {
            // The next change would be to this one as this one is to the one before. Changes below rounding need not decrease.
            return Some((force, second));
        }
        // False for NaN.
        let converges = change <= SWEPT * SWEPT * before;
        if !converges {
            return None;
        }
        before = change;
    }
    None
}

/// Sum of the squares of weighted numbers.
fn square<const M: usize>(weights: &[f64; M], of: impl Fn(usize) -> f64) -> f64 {
    let each = weights.iter().enumerate().map(|(k, weight)| (weight * of(k)) * (weight * of(k)));
    each.fold(0.0, |sum, square| sum + square)
}
