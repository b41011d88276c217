//! Equations of motion: the rate of the state.

use crate::scalar::Scalar;
use crate::system::{Health, OneStep, WholeStep};
use crate::vector::Vector;

/// Equations of motion x' = f(t, u, x), for any numbers: `f32`, `f64`, dual numbers, lanes.
pub trait Rate {
    /// The numbers it computes with.
    type S: Scalar;
    /// The state and its rate: [q (NQ), v (NQ), first-order states], SI units.
    type X: Vector<Self::S>;
    /// The discrete state, which changes at events and between steps alone: the inputs, the modes of the conditions, and what the
    /// formulation remembers (its chart, the branch of each loop). The rate is smooth in time and state as long as it stays.
    type U: Copy + PartialEq;

    /// Number of coordinates; the first `NQ` rates are the velocities: q' = v.
    const NQ: usize;
    /// The rate is so short that it pays to copy it into every stage of a method. Not that of several lanes, which has work
    /// enough while it waits.
    const SHORT: bool = false;

    /// The rate `dx` of the state, as straight-line code without pivoting.
    fn rate(&self, t: Self::S, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> Health<Self::S>;

    /// It pays to compute what depends on the poses of two stages alone side by side, by [`rate_pair`](Self::rate_pair).
    const PAIRED: bool = false;

    /// Two rates in a row: that at `x[0]`, and that at the state which `second` makes of it; the positions of the latter are
    /// those of `x[1]`. To the bit the same as one by one.
    #[inline]
    fn rate_pair(
        &self,
        t: [Self::S; 2],
        u: &Self::U,
        x: [&Self::X; 2],
        dx: &mut [Self::X; 2],
        second: impl FnOnce(&Self::X) -> Self::X,
    ) -> Health<Self::S> {
        let ([t, later], [x, _], [first, last]) = (t, x, dx);
        let health = self.rate(t, u, x, first);
        health.worst(self.rate(later, u, &second(first), last))
    }

    /// One step of a formula from the time `t` by `h`, computed as a whole: `to`, which is the state `from`, becomes that after the step,
    /// with the bits that the formula has by rates one by one. Nothing, and `to` stays, where the system computes rates alone.
    #[inline]
    fn whole_step<F: OneStep>(
        &self,
        times: (Self::S, Self::S),
        u: &Self::U,
        from: &Self::X,
        to: &mut Self::X,
    ) -> Option<WholeStep<Self::S>> {
        let _ = (times, u, from, to);
        None
    }

    /// Is [`whole_step`](Self::whole_step) of use?
    const WHOLE: bool = false;

    /// Number of coordinates: `NQ`, or fewer of a system that has its size from a program. Then the numbers of the state after the last
    /// coordinate, and those after the last velocity, are zero and stay so.
    #[inline]
    fn coordinates(&self) -> usize {
        Self::NQ
    }

    /// Number of coordinates, velocities and first-order states: errors are means over so many.
    #[inline]
    fn states(&self) -> usize {
        Self::X::LEN
    }

    /// Are the numbers of a state neither infinite nor NaN?
    #[inline]
    fn is_finite(&self, x: &Self::X) -> bool {
        x.is_finite()
    }

    /// Number of the state that stands at a place, from 0 without room; nothing at the places of room before first-order states.
    #[inline]
    fn number_at(&self, place: usize) -> Option<usize> {
        let coordinates = self.coordinates();
        match place {
            _ if place >= 2 * Self::NQ => Some(2 * coordinates + place - 2 * Self::NQ),
            _ if place >= Self::NQ => {
                Some(coordinates + place - Self::NQ).filter(|number| *number < 2 * coordinates)
            }
            _ => Some(place).filter(|number| *number < coordinates),
        }
    }

    /// True if the state has a number at this place. Otherwise it is one of the zeros after the last coordinate, the last velocity or the
    /// last first-order state.
    #[inline]
    fn has_number(&self, place: usize) -> bool {
        self.number_at(place).is_some_and(|number| number < self.states())
    }

    /// Typical size of each state; with the relative tolerance it gives the absolute one: atol = rtol * typical.
    #[inline]
    fn typical(&self) -> Self::X {
        Self::X::fill(Self::S::lit(1.0))
    }

    /// [`typical`](Self::typical) of one state.
    #[inline]
    fn typical_at(&self, index: usize) -> Self::S {
        self.typical().at(index)
    }
}

/// A rate out of line: states are copied, so that the caller's stay in registers.
#[cold]
#[inline(never)]
pub fn rate_aside<M: Rate>(system: &M, t: M::S, u: &M::U, x: M::X) -> (M::X, Health<M::S>) {
    let mut dx = x;
    let health = system.rate(t, u, &x, &mut dx);
    (dx, health)
}
