//! Steps of explicit formulas that are made at once, as one computation.

use core::fmt::Debug;
use core::marker::PhantomData;

use super::Formula;
use crate::method::Evaluated;
use crate::method::length::spread;
use crate::scalar::Scalar;
use crate::system::{Computation, Health, System};
use crate::vector::Vector;

/// The end of a step, and a vector of the spread of its rates, which has no derivatives.
struct OfFormula<F>(PhantomData<F>);

impl<F: Formula> Computation for OfFormula<F> {
    type Made<X: Copy + Debug> = (X, X);
    const VECTORS: usize = 1;
    const FROM_RATE: bool = false;

    #[inline]
    fn map<X: Copy + Debug, Y: Copy + Debug>(
        (end, spread): &(X, X),
        blank: Y,
        mut each: impl FnMut(&X, &mut Y),
    ) -> (Y, Y) {
        let mut all = (blank, blank);
        each(end, &mut all.0);
        each(spread, &mut all.1);
        all
    }

    #[allow(clippy::inline_always, reason = "as the formula")]
    #[inline(always)]
    fn of<M: System>(
        system: &M,
        (t, h): (M::S, M::S),
        u: &M::U,
        (x, _): (&M::X, &M::X),
    ) -> ((M::X, M::X), Health<M::S>) {
        let (mut rates, mut end) = (Evaluated::new(system, u), *x);
        let look = |x: &M::X, stages: &F::Stages<M::X>| spread::<F, M>(system, h, x, stages);
        let spread = F::step::<M, _>((t, h), &mut end, &mut rates, look);
        ((end, M::X::fill(spread)), rates.worst)
    }
}

/// Makes one step; gives the worst health of its stages, and true if its rates differ little.
#[inline(never)]
pub(super) fn step<F: Formula, M: System>(
    (system, u): (&M, &M::U),
    times: (M::S, M::S),
    x: &mut M::X,
) -> (Health<M::S>, bool) {
    let from = *x;
    let ((end, spread), health) = system.compute::<OfFormula<F>>(times, u, (&from, &from));
    *x = end;
    (health, (0..M::X::LEN).all(|i| spread.at(i).to_f64() <= 0.0))
}
