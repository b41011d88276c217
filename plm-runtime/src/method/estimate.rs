//! Error estimate of a step of fixed length, without another rate.
//!
//! A step already has differences of the third order: its rates differ by `h^2/4` of their second derivative, and its
//! positions differ from those by the trapezoidal rule of the velocities at both ends by `h^3/12` of their third derivative.
//! Both are much larger than the error of a formula of order 4. If the terms of Taylor's series shrink by a factor of `z`
//! each, a third term of `s = z^3` implies a fifth one of `s^(5/3)`: the error is estimated as that times the constant of the
//! formula. For a linear oscillator this is exact; for mechanisms a test compares the two.
//!
//! The size of a state is its own magnitude, or its typical one if that is larger: an angle that errs by a radian is wrong
//! after any number of revolutions.

use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Estimated error of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate<S> {
    /// Largest error of a state after the step, relative to its size.
    pub error: S,
    /// Index of that state.
    pub state: usize,
}

/// Error of a step, relative to what moves, above which the step makes no sense.
const SENSELESS: f64 = 1.0;

impl<S: Scalar> Estimate<S> {
    /// No error worth an estimate.
    pub(crate) const NONE: Self = Self { error: S::ZERO, state: 0 };
}

impl<S: Real> Estimate<S> {
    /// The largest of the errors that `each` gives by the index of a state; NaN is the largest.
    pub(crate) fn largest(states: usize, each: impl Fn(usize) -> S) -> Self {
        let mut largest = Self::NONE;
        for state in 0..states {
            let error = each(state);
            let is_less = error <= largest.error;
            if !is_less {
                largest = Self { error, state };
            }
        }
        largest
    }

    /// Estimate from that of a term of some order, for a formula whose error is `constant` times the term to the power of the
    /// ratio of the orders, `power`.
    pub(super) fn of_term(self, constant: f64, power: f64) -> Self {
        if self.error <= S::ZERO {
            return Self::NONE;
        }
        Self { error: S::lit(constant) * (S::lit(power) * self.error.ln()).exp(), ..self }
    }

    /// True if the step is of no use; also for NaN.
    pub(crate) fn is_senseless(self) -> bool {
        let makes_sense = self.error < S::lit(SENSELESS);
        !makes_sense
    }

    /// Fault that ends a run because of a step of `h` from the time `t`.
    #[cold]
    pub(crate) fn fault<M: System<S = S>>(self, system: &M, t: S, h: S) -> Fault {
        let cause = Cause::StepTooLong { step: h.to_f64(), error: self.error.to_f64() };
        Fault::of_part(t.to_f64(), system.part_of_state(self.state), cause)
    }
}

/// Sizes of the states in a step between two states.
pub(super) struct Sizes<'a, X> {
    pub(super) typical: X,
    pub(super) from: &'a X,
    pub(super) to: &'a X,
}

impl<X> Sizes<'_, X> {
    /// Size of a velocity or of a first-order state.
    pub(super) fn of<S: Real>(&self, i: usize) -> S
    where
        X: Vector<S>,
    {
        self.to.at(i).abs().max(self.of_place(i))
    }

    /// Size of a position at the beginning of the step: a step that is far too long throws it anywhere.
    pub(super) fn of_place<S: Real>(&self, i: usize) -> S
    where
        X: Vector<S>,
    {
        self.from.at(i).abs().max(self.typical.at(i))
    }

    /// Distance of a position from that by the trapezoidal rule of its velocities, relative to its size.
    pub(super) fn bend<S: Real>(&self, (i, coordinates, h): (usize, usize, S)) -> S
    where
        X: Vector<S>,
    {
        let (v, half) = (coordinates + i, S::lit(0.5) * h);
        let mean = self.from.at(v) + self.to.at(v);
        (self.to.at(i) - self.from.at(i) - half * mean).abs() / self.of_place(i)
    }
}
