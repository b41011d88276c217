//! Collocation polynomial of a step.

use super::tableau::C;
use crate::method::Path;
use crate::scalar::Real;
use crate::vector::Vector;

/// Polynomial of degree 3 through the state at the beginning of a step and its three stages, in Newton's form from the end (CONTR5 of
/// the program RADAU5), corrected to the projected state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dense<S, X> {
    /// Time at the end of the step.
    pub(super) end: S,
    pub(super) h: S,
    /// State at the end, before it was projected.
    pub(super) to: X,
    /// State at the end.
    pub(super) projected: X,
    /// Divided differences.
    pub(super) differences: [X; 3],
}

impl<S: Real, X: Vector<S>> Dense<S, X> {
    /// Polynomial of a step of `h` that ended at `end` in `to` and was projected to `projected`; `z` are the stages less the state at
    /// its beginning.
    pub(super) fn new(end: S, h: S, to: X, projected: X, z: &[X; 3]) -> Self {
        let lit = S::lit;
        let [c1, c2, _] = C;
        let quotient = |a: &X, b: &X, distance: f64| a.map2(b, |a, b| (a - b) / lit(distance));
        let first = quotient(&z[1], &z[2], c2 - 1.0);
        let middle = quotient(&z[0], &z[1], c1 - c2);
        let second = quotient(&middle, &first, c1 - 1.0);
        let start = quotient(&middle, &z[0].map(|z| z / lit(c1)), c2);
        let third = second.map2(&start, |second, start| second - start);
        Self { end, h, to, projected, differences: [first, second, third] }
    }

    /// State at `time`.
    pub(super) fn at(&self, time: S) -> X {
        let s = (time - self.end) / self.h;
        let change = self.change(s);
        X::from_fn(|i| {
            self.to.at(i) + change.at(i) + (S::lit(1.0) + s) * (self.projected.at(i) - self.to.at(i))
        })
    }

    /// Change of the polynomial from the state at the end, `s` steps after it.
    pub(super) fn change(&self, s: S) -> X {
        let [c1, c2, _] = C.map(|c| s - S::lit(c - 1.0));
        let [first, second, third] = &self.differences;
        X::from_fn(|i| s * (first.at(i) + c2 * (second.at(i) + c1 * third.at(i))))
    }

    /// The polynomial as powers of the fraction of the step that has passed, theta = 1 + s.
    pub(super) fn path(&self) -> Path<S, X> {
        let [c1, c2, _] = C.map(S::lit);
        let zero = S::ZERO;
        Path::new(self.end - self.h, self.h, |i| {
            let [d1, d2, d3] = self.differences.each_ref().map(|difference| difference.at(i));
            // change = s (d1 + (theta - c2) (d2 + (theta - c1) d3))
            let (low, high) = (d2 - c1 * d3, d3);
            let inner = [d1 - c2 * low, low - c2 * high, high];
            let off = self.projected.at(i) - self.to.at(i);
            let first = self.to.at(i) - inner[0];
            [first, inner[0] - inner[1] + off, inner[1] - inner[2], inner[2], zero, zero, zero, zero, zero]
        })
    }

    /// Length of the step.
    pub(super) fn h(&self) -> S {
        self.h
    }
}
