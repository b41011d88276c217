//! Step size control.

use super::pair::Limits;
use crate::scalar::Real;

/// Proportional-integral control of the step size (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II,
/// IV.2, eq. (2.43c)).
#[derive(Clone, Copy, Debug)]
pub(super) struct Control<S> {
    /// Error of the last accepted step, as a multiple of the tolerance.
    last_error: S,
    /// The step was rejected before: do not grow at once.
    rejected: bool,
}

impl<S: Real> Control<S> {
    pub(super) fn new() -> Self {
        Self { last_error: S::lit(1e-4), rejected: false }
    }

    /// Factor for the next step after one with `error` <= 1.
    pub(super) fn accept(&mut self, limits: &Limits, error: S) -> S {
        let memory = if limits.memory > 0.0 { power(self.last_error, limits.memory) } else { S::lit(1.0) };
        let factor = S::lit(limits.safety) * memory / power(error, limits.exponent);
        let most = if self.rejected { 1.0 } else { limits.growth };
        self.last_error = error.max(S::lit(1e-4));
        self.rejected = false;
        factor.max(S::lit(limits.shrink)).min(S::lit(most))
    }

    /// The step was accepted by its error and refused for something else.
    pub(super) fn refuse(&mut self) {
        self.rejected = true;
    }

    /// Factor for another try after `error` > 1, or NaN.
    pub(super) fn reject(&mut self, limits: &Limits, error: S) -> S {
        self.rejected = true;
        // `max` gives its argument for NaN.
        (S::lit(limits.safety) / power(error, limits.exponent)).max(S::lit(limits.shrink))
    }
}

/// `x^exponent`, of at least 1e-10^exponent.
fn power<S: Real>(x: S, exponent: f64) -> S {
    let least = S::lit(1e-10);
    let x = if x < least { least } else { x };
    if exponent == 0.125 {
        // Three square roots take a third of the time of a logarithm and an exponential.
        return x.sqrt().sqrt().sqrt();
    }
    (S::lit(exponent) * x.ln()).exp()
}
