//! Step size control, in any numbers without derivatives: a run has one, lanes have one each.

use super::pair::Limits;
use crate::scalar::{Real, Scalar};
use crate::words::{InWords, Words};

/// Proportional-integral control of the step size (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II,
/// IV.2, eq. (2.43c)).
#[derive(Clone, Copy, Debug)]
pub(super) struct Control<S: Scalar> {
    /// Error of the last accepted step, as a multiple of the tolerance.
    pub(super) last_error: S,
    /// True if the step was rejected before: it does not grow at once.
    pub(super) rejected: S::Mask,
}

impl<S: Scalar> Control<S> {
    pub(super) fn new() -> Self {
        Self { last_error: S::lit(1e-4), rejected: never::<S>() }
    }

    /// Factor for the next step after one with `error` <= 1.
    pub(super) fn accept(&mut self, limits: &Limits, error: S) -> S {
        let memory = if limits.memory > 0.0 { power(self.last_error, limits.memory) } else { S::lit(1.0) };
        let factor = S::lit(limits.safety) * memory / power(error, limits.exponent);
        let most = S::select(self.rejected, S::lit(1.0), S::lit(limits.growth));
        self.last_error = error.max(S::lit(1e-4));
        self.rejected = never::<S>();
        factor.max(S::lit(limits.shrink)).min(most)
    }

    /// The first of two where the mask is set, the second elsewhere.
    pub(super) fn select(mask: S::Mask, a: &Self, b: &Self) -> Self {
        Self {
            last_error: S::select(mask, a.last_error, b.last_error),
            rejected: S::choose(mask, a.rejected, b.rejected),
        }
    }

    /// Records that a step was accepted by its error and refused for another reason.
    pub(super) fn refuse(&mut self) {
        self.rejected = always::<S>();
    }

    /// Factor for another attempt after `error` > 1, or NaN.
    pub(super) fn reject(&mut self, limits: &Limits, error: S) -> S {
        self.rejected = always::<S>();
        // `max` gives its argument for NaN.
        (S::lit(limits.safety) / power(error, limits.exponent)).max(S::lit(limits.shrink))
    }
}

impl<S: Real> InWords for Control<S> {
    fn each(&mut self, words: &mut impl Words) {
        words.number(&mut self.last_error);
        words.flag(&mut self.rejected);
    }
}

/// A mask that is set in no lane.
fn never<S: Scalar>() -> S::Mask {
    S::ZERO.lt(S::ZERO)
}

/// A mask that is set in every lane.
fn always<S: Scalar>() -> S::Mask {
    S::ZERO.lt(S::lit(1.0))
}

/// `x^exponent`, of at least 1e-10^exponent.
fn power<S: Scalar>(x: S, exponent: f64) -> S {
    let least = S::lit(1e-10);
    let x = S::select(x.lt(least), least, x);
    if exponent == 0.125 {
        // Three square roots take a third of the time of a logarithm and an exponential.
        return x.sqrt().sqrt().sqrt();
    }
    (S::lit(exponent) * x.ln()).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { safety: 0.9, exponent: 0.15, memory: 0.04, shrink: 0.2, growth: 10.0 };

    /// The formula, in the powers of std.
    #[test]
    fn a_factor_follows_from_this_error_and_the_last() {
        for (memory, exponent) in [(0.04, 0.15), (0.0, 0.125), (0.08, 0.2)] {
            let limits = Limits { exponent, memory, ..LIMITS };
            let mut control = Control::new();
            // The first one has an error of 1e-4 before it, as has one after a smaller error.
            for (last, error) in [(1e-4, 0.5), (0.5, 0.9), (0.9, 1e-5), (1e-4, 0.3)] {
                let known = 0.9 * f64::powf(last, memory) / f64::powf(error, exponent);
                let found: f64 = control.accept(&limits, error);
                assert!((found - known).abs() < 1e-14, "{memory}, {last} to {error}: {found} {known}");
            }
        }
    }

    #[test]
    fn factors_stay_within_their_limits() {
        let mut control = Control::<f64>::new();
        assert_eq!(control.accept(&Limits { growth: 2.0, ..LIMITS }, 1e-10), 2.0);
        assert_eq!(control.reject(&LIMITS, 1e9), 0.2);
        assert_eq!(control.reject(&LIMITS, f64::NAN), 0.2);
        // No step grows at once after one that was rejected or refused.
        assert_eq!(control.accept(&LIMITS, 1e-10), 1.0);
        assert!(control.accept(&LIMITS, 1e-10) > 1.0);
        control.refuse();
        assert_eq!(control.accept(&LIMITS, 1e-10), 1.0);
    }
}
