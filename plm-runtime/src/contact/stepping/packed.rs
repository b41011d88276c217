//! Time steps of several mechanisms side by side: the motion of all at once in packed numbers, then the contact problems one by one.

use super::{Motion, Solution, Stride, drift, step_by};
use crate::contact::loads::Load;
use crate::contact::rows::{Law, Rows};
use crate::contact::{Contacts, Modal};
use crate::fault::Fault;
use crate::system::{Health, Rate};
use crate::vector::Vector;

/// A step to be made for one of several mechanisms, with the arguments of [`step`](super::step).
#[derive(Debug)]
pub struct Proposed<'a, M: Rate> {
    /// The mechanism.
    pub system: &'a M,
    /// The time step.
    pub stride: Stride<M::S>,
    /// Discrete state; after the step, that at its end.
    pub held: &'a mut M::U,
    /// State at the beginning of the step; after the step, that at its end.
    pub x: &'a mut M::X,
    /// Result of the step.
    pub made: &'a mut Option<Result<Solution<M::S>, Fault>>,
}

/// Makes the steps that are proposed, with the bits of [`step`](super::step) with one evaluation. `stride` and `x` are the packed steps and
/// states of all lanes, `motion` gives the motion of all at a time and a state, and `take` the value of a lane.
pub fn packed_steps<M: Contacts<N>, P: Rate, const N: usize, const K: usize>(
    (stride, x): (&Stride<P::S>, &P::X),
    motion: impl FnOnce(P::S, &P::X) -> Motion<P::S, P::X, N>,
    proposed: [Option<Proposed<'_, M>>; K],
    take: impl Fn(&P::S, usize) -> M::S,
) {
    let ([ahead, _], mut place) = (stride.parts(), *x);
    drift::<P>(ahead, &mut place);
    let all = motion(stride.t + ahead, &place);
    for (lane, proposed) in proposed.into_iter().enumerate() {
        if let Some(Proposed { system, stride, held, x, made }) = proposed {
            let own = |_: M::S, held: &M::U, _: &M::X| {
                of_lane::<M, P, N>(&all, (system, held), |number| take(number, lane))
            };
            *made = Some(step_by::<M, N, 1>(system, &stride, (held, x), own, |_, _, _| Ok(())));
        }
    }
}

/// Motion of one lane, with the signs of reactions of its own discrete state.
#[allow(clippy::inline_always, reason = "what is written is not copied")]
#[inline(always)]
fn of_lane<M: Contacts<N>, P: Rate, const N: usize>(
    all: &Motion<P::S, P::X, N>,
    (system, held): (&M, &M::U),
    take: impl Fn(&P::S) -> M::S,
) -> Motion<M::S, M::X, N> {
    let numbers = |packed: &P::X| M::X::from_fn(|i| take(&packed.at(i)));
    let mut motion = Motion {
        rate: numbers(&all.rate),
        responses: all.responses.each_ref().map(numbers),
        rows: Rows::none(),
        health: Health(take(&all.health.0)),
    };
    motion.rows.take(&all.rows, &take, |row| system.law(row) == Law::Friction);
    for (load, negative) in motion.rows.load.iter_mut().zip(held.modes().negative) {
        if let Load::Line { .. } = load {
            *load = Load::Line { negative };
        }
    }
    motion
}
