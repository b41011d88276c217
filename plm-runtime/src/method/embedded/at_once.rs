//! Steps that are made at once, as one computation.

use core::fmt::Debug;
use core::marker::PhantomData;

use super::{Embedded, Pair};
use crate::method::{Context, Evaluated};
use crate::scalar::Real;
use crate::system::{Computation, Health, System};

/// Content of the dense output of such a step: most need values alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Known {
    Values,
    Derivatives,
}

/// A step of a pair without a decision and a second attempt: its end and its stages, which have derivatives or are
/// `VALUES`.
struct OfPair<P, const VALUES: bool>(PhantomData<P>);

impl<P: Pair, const VALUES: bool> Computation for OfPair<P, VALUES> {
    type Made<X: Copy + Debug> = (X, P::Stages<X>);
    const VECTORS: usize = if VALUES { 1 } else { 1 + P::KEPT };
    const FROM_RATE: bool = true;

    #[inline]
    fn map<X: Copy + Debug, Y: Copy + Debug>(
        (end, stages): &(X, P::Stages<X>),
        blank: Y,
        mut each: impl FnMut(&X, &mut Y),
    ) -> (Y, P::Stages<Y>) {
        let mut all = (blank, P::blank(blank));
        each(end, &mut all.0);
        P::map(stages, &mut all.1, each);
        all
    }

    #[allow(clippy::inline_always, reason = "as the stages")]
    #[inline(always)]
    fn of<M: System>(
        system: &M,
        (t, h): (M::S, M::S),
        u: &M::U,
        (x, first): (&M::X, &M::X),
    ) -> ((M::X, P::Stages<M::X>), Health<M::S>) {
        let (mut rates, mut stages) = (Evaluated::new(system, u), P::blank(*first));
        let end = P::step::<M>(t, h, x, first, &mut stages, &mut rates);
        ((end, stages), rates.worst)
    }
}

impl<M: System<S: Real>, P: Pair> Embedded<M, P> {
    /// The step as one computation. A separate function: its copies of the stages would take stack space in every
    /// caller.
    #[inline(never)]
    pub(super) fn computed<const VALUES: bool>(
        (context, time, x): (&Context<'_, M>, M::S, &M::X),
        rate: &M::X,
        h: M::S,
        k: &mut P::Stages<M::X>,
    ) -> (M::X, Health<M::S>) {
        let ((end, stages), worst) =
            context.system.compute::<OfPair<P, VALUES>>((time, h), &context.held, (x, rate));
        *k = stages;
        (end, worst)
    }
}
