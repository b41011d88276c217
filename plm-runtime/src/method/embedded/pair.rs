//! Contract of a pair of formulas: stages, error estimate, dense output.

use core::fmt::Debug;

use crate::method::Rates;
use crate::scalar::{Real, Scalar};
use crate::system::{Rate, System};
use crate::vector::Vector;

/// Two explicit Runge-Kutta formulas on common stages: one gives the state, their difference its error.
pub trait Pair: Copy + Debug {
    /// [`Method::name`](crate::Method::name) of the method.
    const NAME: &'static str = "";
    /// Order of the formula that the steps are continued with.
    const ORDER: u32;
    /// Evaluations of a trial step, without the rate at its beginning.
    const EVALUATIONS: u64;
    /// Relative tolerance of a run that names none.
    const RTOL: f64;
    /// Step size control.
    const LIMITS: Limits;

    /// Rates of the stages.
    type Stages<X: Copy + Debug>: Copy + Debug;
    /// Coefficients of the dense output beyond those that the ends of a step determine, the lowest first.
    type Bends<X: Copy + Debug>: Copy + Debug + AsRef<[X]>;

    /// Number of stages that are stored.
    const KEPT: usize;

    /// Converts stages to other states.
    fn map<X: Copy + Debug, Y: Copy + Debug>(
        k: &Self::Stages<X>,
        to: &mut Self::Stages<Y>,
        each: impl FnMut(&X, &mut Y),
    );

    /// Stages with a blank value, to write to.
    fn blank<X: Copy + Debug>(x: X) -> Self::Stages<X>;

    /// State at `t + h` from `x` at `t`, where the rate is `first`; `rates` computes the others.
    fn step<M: Rate>(
        t: M::S,
        h: M::S,
        x: &M::X,
        first: &M::X,
        k: &mut Self::Stages<M::X>,
        rates: impl Rates<M>,
    ) -> M::X;

    /// Rate at the end of a step, if it is one of the stages.
    fn rate_at_end<X: Copy + Debug>(k: &Self::Stages<X>) -> Option<&X>;

    /// Norm of the error of so many components, each by its weight, in numbers without derivatives.
    fn error<S: Scalar, X: Vector<S>>(h: S, k: &Self::Stages<X>, by: (&X, usize)) -> S;

    /// [`error`](Self::error) by the values of numbers that may have derivatives.
    fn error_of_values<S: Real, X: Vector<S>>(h: S::Plain, k: &Self::Stages<X>, by: (&X, usize)) -> S::Plain;

    /// Norm of the first one of the estimates that [`error_of_values`](Self::error_of_values) combines.
    fn plain_error<S: Real, X: Vector<S>>(h: S::Plain, k: &Self::Stages<X>, by: (&X, usize)) -> S::Plain;

    /// Dense output of a step from `x` at `t`; `last` is the rate at its end.
    fn bend<M: System>(
        t: M::S,
        h: M::S,
        x: &M::X,
        k: &Self::Stages<M::X>,
        last: &M::X,
        rate: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> Self::Bends<M::X>;
}

/// Limits of the step size control.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The next step aims at an error of this to the power 1 / `exponent`, as a fraction of the tolerance.
    pub safety: f64,
    /// Exponent of the error: 1 / (order of the estimate + 1), less 3/4 (or less) of `memory`.
    pub exponent: f64,
    /// Exponent of the error of the step before, 0 for none (beta in the literature).
    pub memory: f64,
    /// The next step is at least this times the last one.
    pub shrink: f64,
    /// The next step is at most this times the last one.
    pub growth: f64,
}
