//! Step size control.

use crate::scalar::Real;

/// Proportional-integral control of the step size (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II,
/// IV.2, eq. (2.43c), with the constants of their program DOPRI5).
#[derive(Clone, Copy, Debug)]
pub(super) struct Control<S> {
    /// Error of the last accepted step, as a multiple of the tolerance.
    last_error: S,
    /// The step was rejected before: do not grow at once.
    rejected: bool,
}

const SAFETY: f64 = 0.9;
const BETA: f64 = 0.04;
const EXPONENT: f64 = 0.2 - 0.75 * BETA;
const MOST_SHRINKING: f64 = 0.2;
const MOST_GROWTH: f64 = 10.0;

impl<S: Real> Control<S> {
    pub(super) fn new() -> Self {
        Self { last_error: S::lit(1e-4), rejected: false }
    }

    /// Factor for the next step after one with `error` <= 1.
    pub(super) fn accept(&mut self, error: S) -> S {
        let factor = S::lit(SAFETY) * power(self.last_error, BETA) / power(error, EXPONENT);
        let most = if self.rejected { 1.0 } else { MOST_GROWTH };
        self.last_error = error.max(S::lit(1e-4));
        self.rejected = false;
        factor.max(S::lit(MOST_SHRINKING)).min(S::lit(most))
    }

    /// Factor for another try after `error` > 1, or NaN.
    pub(super) fn reject(&mut self, error: S) -> S {
        self.rejected = true;
        // `max` gives its argument for NaN.
        (S::lit(SAFETY) / power(error, EXPONENT)).max(S::lit(MOST_SHRINKING))
    }
}

/// `x^exponent`, of at least 1e-10^exponent.
fn power<S: Real>(x: S, exponent: f64) -> S {
    let least = S::lit(1e-10);
    let x = if x < least { least } else { x };
    (S::lit(exponent) * x.ln()).exp()
}
