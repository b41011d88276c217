//! Guards at a state.

use core::marker::PhantomData;

use crate::fault::{Cause, Fault};
use crate::method::Context;
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value, values};
use crate::vector::Vector;

/// Asks for the guards at a time and a state.
struct At<'a, S, X, G>(S, &'a X, PhantomData<G>);

impl<S: Real, X: Vector<S>, G: Vector<S>> Question<S> for At<'_, S, X, G> {
    type Answer = G;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> G {
        let Self(time, x, _) = self;
        values(&guards(system, value(time), held, &values(x)))
    }
}

/// Guards at the state reached, as values; a fault if one of them is not finite.
pub(super) fn guards_here<M: System<S: Real>>(context: &Context<'_, M>) -> Result<M::G, Fault> {
    let g: M::G = context.system.ask(&context.held, At(context.time, &context.x, PhantomData));
    if g.is_finite() {
        return Ok(g);
    }
    let index = (0..M::G::LEN).find(|i| !g.at(*i).is_finite()).unwrap_or(0);
    Err(Fault::of_part(context.time.to_f64(), context.system.guard_name(index), Cause::NotFinite))
}

/// Guards of a state.
pub(super) fn guards<M: System>(system: &M, t: M::S, u: &M::U, x: &M::X) -> M::G {
    let mut g = M::G::fill(M::S::lit(0.0));
    system.guards(t, u, x, &mut g);
    g
}
