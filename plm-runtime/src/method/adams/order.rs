//! Order and length of the next step (Shampine and Gordon, chapter 7, and the program STEP).

use super::MOST;
use super::coefficients::{Coefficients, EQUAL_STEPS};
use crate::scalar::Real;
use crate::vector::Vector;

/// Estimates of the error of a step, as multiples of the tolerance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors<S> {
    /// Error of the step.
    pub(super) made: S,
    /// Errors if it had been made with the order k - 2, k - 1, k, and steps of equal length.
    by_order: [S; 3],
}

impl<S: Real> Errors<S> {
    /// Errors from the root mean squares of differences k - 1, k, and k + 1 of the rate.
    pub(super) fn new(h: S, [below, top, surprise]: [S; 3], k: usize, by: &Coefficients<S>) -> Self {
        let Coefficients { once, sigma, .. } = by;
        let equal = |order: usize| S::lit(EQUAL_STEPS.at(order)).abs();
        let if_any = |order: usize, error: S| if k >= order { error } else { S::ZERO };
        Self {
            made: h * surprise * (once.at(k) - once.at(k + 1)),
            by_order: [
                if_any(3, h * sigma.at(k.saturating_sub(1)) * equal(k.saturating_sub(2)) * below),
                if_any(2, h * sigma.at(k) * equal(k.saturating_sub(1)) * top),
                h * sigma.at(k + 1) * equal(k) * surprise,
            ],
        }
    }

    /// Error of the step if it had been made with the order k + 1, from the root mean square of difference k + 2 of the rate.
    pub(super) fn one_more(h: S, difference: S, k: usize) -> S {
        h * S::lit(EQUAL_STEPS.at(k + 1)).abs() * difference
    }

    /// True if one order less suffices.
    pub(super) fn asks_for_less(&self, k: usize) -> bool {
        let [two_less, one_less, this] = self.by_order;
        match k {
            0 | 1 => false,
            2 => one_less <= S::lit(0.5) * this,
            _ => one_less.max(two_less) <= this,
        }
    }
}

/// Least factor by which a step grows.
const PAYS: f64 = 1.1;
/// Error to which a step grows, as a multiple of the tolerance.
const GROWS_TO: f64 = 0.25;

/// Order and length of the next step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Next<S> {
    pub(super) order: usize,
    pub(super) h: S,
}

/// Order and length of the step after an accepted one of `h`; `one_more` estimates the error with the order k + 1, if possible.
/// While a run begins both grow with every step.
pub(super) fn next<S: Real>(
    errors: &Errors<S>,
    one_more: Option<S>,
    (k, h): (usize, S),
    begins: &mut bool,
    equal: usize,
) -> Next<S> {
    let [_, one_less, this] = errors.by_order;
    let half = S::lit(0.5);
    if errors.asks_for_less(k) || k == MOST {
        *begins = false;
    }
    if *begins {
        return Next { order: k + 1, h: h + h };
    }
    let (order, error) = if errors.asks_for_less(k) {
        (k - 1, one_less)
    } else {
        match one_more {
            Some(more) if k > 1 && one_less <= this.min(more) => (k - 1, one_less),
            Some(more) if k < MOST && more < if k > 1 { this } else { half * this } => (k + 1, more),
            _ => (k, this),
        }
    };
    // Changes of length cost coefficients: a step grows only after as many equal steps as its order, and only by a tenth or more.
    let grown = |by: S| (0..=order).fold(error, |error, _| by * error);
    let factor = if grown(S::lit(2.0)) <= half {
        S::lit(2.0)
    } else if error > half {
        grows_by(order, error, half).max(half).min(S::lit(0.9))
    } else if equal > k && grown(S::lit(PAYS)) <= S::lit(GROWS_TO) {
        grows_by(order, error, S::lit(GROWS_TO))
    } else {
        S::lit(1.0)
    };
    Next { order, h: factor * h }
}

/// Factor by which a step can grow until its error reaches `goal`.
fn grows_by<S: Real>(order: usize, error: S, goal: S) -> S {
    let error = error.max(S::lit(1e-10));
    ((goal / error).ln() / S::lit((order + 1) as f64)).exp()
}
