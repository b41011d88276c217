//! Questions to a system that values alone answer.

use super::System;
use crate::scalar::Real;
use crate::vector::Vector;

/// A question that is asked in numbers without derivatives: whether and where something switches.
///
/// Numbers with derivatives decide by their values, so that the answer is the same, in a fraction of the operations.
pub trait Question<S: Real> {
    /// The answer.
    type Answer;

    /// Asks a system with its discrete state.
    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Self::Answer;
}

/// Converts a number to another type, without derivatives.
pub(crate) fn value<S: Real, T: Real<Plain = S::Plain>>(number: S) -> T {
    T::of_plain(number.plain())
}

/// Converts a vector to one of equal length of another type, without derivatives.
pub(crate) fn values<S: Real, T: Real<Plain = S::Plain>, X: Vector<S>, Y: Vector<T>>(x: &X) -> Y {
    Y::from_fn(|i| value(x.at(i)))
}
