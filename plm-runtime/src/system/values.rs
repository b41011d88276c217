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

    /// Asks a system with what is held over a step.
    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Self::Answer;
}

/// The same number in numbers of another kind, without derivatives.
pub(crate) fn value<S: Real, T: Real<Plain = S::Plain>>(number: S) -> T {
    T::of_plain(number.plain())
}

/// The same of a vector that is as long.
pub(crate) fn values<S: Real, T: Real<Plain = S::Plain>, X: Vector<S>, Y: Vector<T>>(x: &X) -> Y {
    Y::from_fn(|i| value(x.at(i)))
}
