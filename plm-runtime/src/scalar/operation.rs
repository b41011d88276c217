//! Operations of many numbers, which are made in numbers of any kind.

use super::Real;

/// An operation that gives numbers for numbers.
///
/// Its results have derivatives by its arguments alone. So numbers that are recorded find these in other numbers, and record no more than them.
pub trait Operation<S: Real>: Sized {
    /// Its results.
    type Output;
    /// It has so many arguments that most of its derivatives are too many to be found so.
    const IS_WIDE: bool;
    /// Some result has derivatives; else all are values.
    const HAS_DERIVATIVES: bool;

    /// Makes it.
    fn make(self) -> Self::Output;

    /// Shows every argument, in order.
    fn arguments(&self, each: impl Fn(S));

    /// The number of its results.
    fn results(&self) -> usize;

    /// Makes it in numbers that `number` makes of the arguments, in the same order; `result` makes a number of each result, in order.
    fn in_numbers<T: Real<Plain = S::Plain>>(
        self,
        number: impl Fn(S) -> T,
        result: impl Fn(T) -> S,
    ) -> Self::Output;
}
