//! Step size control by the error and by the convergence of Newton's iteration.

use super::newton::MOST_ITERATIONS;
use crate::scalar::Real;

/// Predictive control (K. Gustafsson, Control-theoretic techniques for stepsize selection in implicit Runge-Kutta
/// methods, ACM Trans. Math. Softw. 20, 1994; Hairer and Wanner II, IV.8, eqs. (8.20), (8.21), (8.25)), with the constants
/// of the program RADAU5.
#[derive(Clone, Copy, Debug)]
pub(super) struct Control<S> {
    /// Length and error of the last accepted step.
    pub(super) last: Option<(S, S)>,
    /// True if the step was rejected before: it does not grow at once.
    pub(super) rejected: bool,
}

const SAFETY: f64 = 0.9;
const MOST_SHRINKING: f64 = 0.2;
const MOST_GROWTH: f64 = 8.0;
const LEAST_ERROR: f64 = 1e-2;

impl<S: Real> Control<S> {
    pub(super) fn new() -> Self {
        Self { last: None, rejected: false }
    }

    /// True if no step was accepted so far.
    pub(super) fn is_first(&self) -> bool {
        self.last.is_none()
    }

    /// Factor for the next step after one of `h` with `error` <= 1 that took so many iterations.
    pub(super) fn accept(&mut self, h: S, error: S, iterations: usize) -> S {
        let mut factor = proposed(error, iterations);
        if let Some((last_h, last_error)) = self.last {
            let trend = fourth_root(last_error / (error * error));
            factor = factor.min(S::lit(SAFETY) * (h / last_h) * trend).max(S::lit(MOST_SHRINKING));
        }
        if self.rejected {
            factor = factor.min(S::lit(1.0));
        }
        self.last = Some((h, error.max(S::lit(LEAST_ERROR))));
        self.rejected = false;
        factor
    }

    /// Factor for another attempt after `error` > 1.
    pub(super) fn reject(&mut self, error: S, iterations: usize) -> S {
        self.rejected = true;
        if self.is_first() { S::lit(0.1) } else { proposed(error, iterations) }
    }
}

/// Factor from the error, more cautious if many iterations were needed.
fn proposed<S: Real>(error: S, iterations: usize) -> S {
    let most = (2 * MOST_ITERATIONS) as f64;
    let safety = SAFETY * (most + 1.0) / (most + iterations as f64);
    let factor = S::lit(safety) / fourth_root(error.max(S::lit(1e-10)));
    factor.max(S::lit(MOST_SHRINKING)).min(S::lit(MOST_GROWTH))
}

fn fourth_root<S: Real>(x: S) -> S {
    x.sqrt().sqrt()
}
