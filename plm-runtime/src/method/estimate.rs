//! What a step of fixed length tells of its error without another rate.
//!
//! A step has in its hands what differs in the third order already: its rates disagree by `h^2/4` of their second derivative,
//! and its positions differ from those by the trapezoidal rule of the velocities at both ends by `h^3/12` of their third
//! derivative. That is larger by far than what a formula of order 4 errs by. Where the terms of Taylor's series shrink by a
//! factor of `z` each, a third term of `s = z^3` tells of a fifth of `s^(5/3)`: the error is estimated at that times the
//! constant of the formula. For a linear oscillator this is what it is; for mechanisms a test compares the two.
//!
//! The size of a state is its own magnitude, or its typical one where that is larger: an angle that errs by a radian is wrong
//! however many turns it has after it.

use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// How far a step was estimated to be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate<S> {
    /// The largest error of a state after the step, as a share of its size.
    pub error: S,
    /// That state, by its index.
    pub state: usize,
}

/// A step that errs by this share of what moves makes no sense.
const SENSELESS: f64 = 1.0;

impl<S: Scalar> Estimate<S> {
    /// Nothing worth an estimate.
    pub(crate) const NONE: Self = Self { error: S::ZERO, state: 0 };
}

impl<S: Real> Estimate<S> {
    /// The largest of the shares that `each` gives by the index of a state; one that is not a number is the largest.
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

    /// That of a state whose term of some order is this share of it, for a formula whose error is `constant` times the term to
    /// the power of the ratio of the orders, `power`.
    pub(super) fn of_term(self, constant: f64, power: f64) -> Self {
        if self.error <= S::ZERO {
            return Self::NONE;
        }
        Self { error: S::lit(constant) * (S::lit(power) * self.error.ln()).exp(), ..self }
    }

    /// Is the step of no use? True for what is not a number.
    pub(crate) fn is_senseless(self) -> bool {
        let makes_sense = self.error < S::lit(SENSELESS);
        !makes_sense
    }

    /// The end of a run by a step of `h` from the time `t`.
    #[cold]
    pub(crate) fn fault<M: System<S = S>>(self, system: &M, t: S, h: S) -> Fault {
        let cause = Cause::StepTooLong { step: h.to_f64(), error: self.error.to_f64() };
        Fault::of_part(t.to_f64(), system.part_of_state(self.state), cause)
    }
}

/// The sizes of the states in a step between two states.
pub(super) struct Sizes<'a, X> {
    pub(super) typical: X,
    pub(super) from: &'a X,
    pub(super) to: &'a X,
}

impl<X> Sizes<'_, X> {
    /// The size of a velocity or of a first-order state.
    pub(super) fn of<S: Real>(&self, i: usize) -> S
    where
        X: Vector<S>,
    {
        self.to.at(i).abs().max(self.of_place(i))
    }

    /// The size of a position, where the step began: a step that is far too long throws it anywhere.
    pub(super) fn of_place<S: Real>(&self, i: usize) -> S
    where
        X: Vector<S>,
    {
        self.from.at(i).abs().max(self.typical.at(i))
    }

    /// How far a position is from where the trapezoidal rule of its velocities puts it, as a share of its size.
    pub(super) fn bend<S: Real>(&self, (i, coordinates, h): (usize, usize, S)) -> S
    where
        X: Vector<S>,
    {
        let (v, half) = (coordinates + i, S::lit(0.5) * h);
        let mean = self.from.at(v) + self.to.at(v);
        (self.to.at(i) - self.from.at(i) - half * mean).abs() / self.of_place(i)
    }
}
