//! Quantities that methods compute of a system from a state.

use core::fmt::Debug;

use super::{Health, System};

/// Vectors that a method computes of a system from a time, a state and the rate there: a rate, a step.
pub trait Computation {
    /// The vectors.
    type Made<X: Copy + Debug>: Copy + Debug;

    /// Other vectors, each written over a `blank` one: large ones are not moved.
    fn map<X: Copy + Debug, Y: Copy + Debug>(
        made: &Self::Made<X>,
        blank: Y,
        each: impl FnMut(&X, &mut Y),
    ) -> Self::Made<Y>;

    /// How many of them, the first ones, have derivatives where numbers are recorded; the others are values.
    const VECTORS: usize;
    /// They depend on the rate at the state. Of recorded numbers that is a value: its derivatives are those of the state it belongs to.
    const FROM_RATE: bool;

    /// Computes them at a time, with the length of a step, from a state and the rate there, with the worst health.
    fn of<M: System>(
        system: &M,
        times: (M::S, M::S),
        u: &M::U,
        from: (&M::X, &M::X),
    ) -> (Self::Made<M::X>, Health<M::S>);
}
