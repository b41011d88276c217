//! Forces of rows that all slip, by sweeps: what generated code has for them needs no system of equations.

use super::modes::Modes;
use crate::scalar::Scalar;

/// Sweeps at most. With a friction of a hundredth of what would lock a joint there are five.
const MOST: u32 = 30;
/// Roundings of the accelerations by which the next sweep may change them.
const ROUNDED: f64 = 2.0;
/// A sweep is to change them by this fraction of the one before.
const SWEPT: f64 = 0.5;

/// By row, the sign of its slip, and the sign that is held of a reaction along a line; nothing where some row holds. Numbers
/// with derivatives are for Newton's steps.
#[must_use]
pub fn slipping<T: Scalar, const N: usize>(modes: &Modes<T, N>) -> Option<[[T; N]; 2]> {
    if T::HAS_DERIVATIVES || modes.hold() {
        return None;
    }
    let line = modes.negative.map(|negative| T::lit(if negative { -1.0 } else { 1.0 }));
    Some([modes.of.map(super::Mode::sign), line])
}

/// Forces of rows that slip, and accelerations of the coordinates with them. Without the forces these are `free`; `sweep` takes forces and
/// accelerations, and gives the next ones, where `is_explicit` the last ones. `weights` make accelerations comparable. None where
/// sweeps do not converge, and where a `slope` of the limits says that frictions lock each other.
#[inline]
pub fn slide<T: Scalar, const N: usize, const M: usize>(
    (slope, weights): (&[T; N], &[f64; M]),
    is_explicit: bool,
    free: [T; M],
    sweep: impl Fn(&[T; N], &[T; M], &mut [T; N], &mut [T; M]),
) -> Option<([T; N], [T; M])> {
    // False for what is not a number.
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
            // The next change would be to this one as this one to the one before. What is less than rounding goes on as it likes.
            return Some((force, second));
        }
        // False for what is not a number.
        let converges = change <= SWEPT * SWEPT * before;
        if !converges {
            return None;
        }
        before = change;
    }
    None
}

/// The sum of the squares of weighted numbers.
fn square<const M: usize>(weights: &[f64; M], of: impl Fn(usize) -> f64) -> f64 {
    let each = weights.iter().enumerate().map(|(k, weight)| (weight * of(k)) * (weight * of(k)));
    each.fold(0.0, |sum, square| sum + square)
}
