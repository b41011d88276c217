//! Near singular poses: the equations in absolute coordinates, in numbers of twice the precision.

use plm_runtime::charts::{self, Charted};
use plm_runtime::singular::ExtendedPrecision;
use plm_runtime::{DoubleDouble, Real, Scalar, Step, absolute};

use crate::handle::{Dynamic, Frame, Held};

type Wide<S> = DoubleDouble<S>;

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> ExtendedPrecision<NQ, NC, N> for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type Extended = Dynamic<Wide<S>, NQ, NC, N, L, H, R, P>;
    type Inputs = Held<Wide<S>, NQ, L, H, R>;

    fn extended(&self) -> Self::Extended {
        self.map(&|number| Wide::written(number))
    }

    fn extended_with_inputs(&self, held: &Self::U) -> (Self::Extended, Self::Inputs) {
        (self.extended(), Self::map_held(held, &|number| Wide::of(number)))
    }

    fn accelerate(
        extended: &Self::Extended,
        t: Wide<S>,
        u: &Self::Inputs,
        x: &[Wide<S>; N],
        dx: &mut [Wide<S>; N],
    ) {
        let mut lambda = [Wide::<S>::ZERO; NC];
        *dx = [Wide::<S>::ZERO; N];
        extended.run(&extended.model.absolute.dynamics, &Frame::of_state(t, u, x), [dx, &mut lambda]);
    }

    fn is_charted(&self) -> bool {
        Dynamic::is_charted(self)
    }

    fn may_be_singular(&self) -> bool {
        self.model.lowered.may_be_singular
    }

    fn crossed(step: &Step<'_, Self>) -> S {
        if Dynamic::is_charted(step.system) { charts::crossed(step) } else { S::ZERO }
    }

    fn is_near(held: &Self::U) -> bool {
        charts::is_free::<Self>(held)
    }

    fn full(&self, t: S, held: &Self::U, x: &[S; N]) -> [S; N] {
        if self.is_absolute() { *x } else { full(self, t, held, x) }
    }

    fn hold(&self, held: &mut Self::U, x: &mut [S; N], full: &[S; N]) {
        if self.is_absolute() { *x = *full } else { charts::hold::<Self, N>(held, x, full) }
    }

    fn flat_part(&self, t: S, full: &[S; N]) -> &'static str {
        let (q, v): ([S; NQ], [S; NQ]) = absolute::split(full);
        if self.is_absolute() {
            absolute::flat_part::<_, _, NQ, NC>(self, t, &q)
        } else {
            charts::flat_part(self, t, &q, &v)
        }
    }
}

/// The state in absolute coordinates, of one in joint coordinates.
pub(super) fn full<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
>(
    mechanism: &Dynamic<S, NQ, NC, N, L, H, R, P>,
    t: S,
    held: &Held<S, NQ, L, H, R>,
    x: &[S; N],
) -> [S; N] {
    let (q, v, _) = Charted::pose(mechanism, t, held, x);
    let mut full = *x;
    absolute::join(&q, &v, &mut full);
    full
}
