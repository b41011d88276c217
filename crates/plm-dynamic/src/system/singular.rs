//! Near singular poses: the equations in absolute coordinates, in numbers of twice the precision.

use plm_runtime::singular::{ByMechanism, ExtendedPrecision};
use plm_runtime::{DoubleDouble, Real, Scalar};

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
    type Coordinates = ByMechanism;

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

    fn may_be_singular(&self) -> bool {
        self.model.lowered.may_be_singular
    }
}
