//! Simulations of some points, which run to a time side by side.

use plm_runtime::lanes::Pack;
use plm_runtime::method::{Embedded, Pair};
use plm_runtime::{Fault, Moment, Sim};

use crate::batch::{Failure, caught};

/// A simulation by a pair of formulas.
type ByPair<M, Q> = Sim<M, Embedded<M, Q>>;

/// Points that a thread takes at once: lanes that are done are filled from them.
pub(crate) const TOGETHER: usize = 64;

/// Gives `done` the place of each point, and its result or why there is none, in the order in which they end.
pub(crate) fn together<P, M: Pack<S = f64>, Q: Pair, T>(
    points: impl IntoIterator<Item = P>,
    until: f64,
    (start, result): (&impl Fn(P) -> Result<ByPair<M, Q>, Fault>, &impl Fn(&ByPair<M, Q>) -> T),
    mut done: impl FnMut(usize, Result<T, Failure>),
) {
    let (mut sims, mut left) = (Vec::new(), Vec::new());
    for (place, point) in points.into_iter().enumerate() {
        match caught(|| start(point)) {
            Ok(Ok(sim)) => {
                let dt = until - sim.state().time();
                sims.push((sim, dt));
                left.push(Some(place));
            }
            Ok(Err(fault)) => done(place, Err(Failure::Fault(fault))),
            Err(words) => done(place, Err(Failure::Panic(words))),
        }
    }
    let ended = |number: usize, sim, outcome: Result<(), Fault>| {
        let seen = || caught(|| result(&sim)).map_err(Failure::Panic);
        if let Some(place) = left.get_mut(number).and_then(Option::take) {
            done(place, outcome.map_err(Failure::Fault).and_then(|()| seen()));
        }
    };
    if let Err(words) = caught(|| run_all(sims, ended)) {
        for place in left.into_iter().flatten() {
            done(place, Err(Failure::Panic(words.clone())));
        }
    }
}

/// Steps each run for its interval, s, and hands it with its number to `done`.
#[cfg(feature = "lanes")]
fn run_all<M: Pack<S = f64>, Q: Pair>(
    runs: Vec<(ByPair<M, Q>, f64)>,
    done: impl FnMut(usize, ByPair<M, Q>, Result<(), Fault>),
) {
    plm_runtime::lanes::run_all::<M, crate::lanes::F64x8, Q, _>(runs, done);
}

/// Steps each run for its interval, s, and hands it with its number to `done`.
#[cfg(not(feature = "lanes"))]
fn run_all<M: Pack<S = f64>, Q: Pair>(
    runs: Vec<(ByPair<M, Q>, f64)>,
    mut done: impl FnMut(usize, ByPair<M, Q>, Result<(), Fault>),
) {
    for (number, (mut sim, dt)) in runs.into_iter().enumerate() {
        let outcome = sim.step(dt);
        done(number, sim, outcome);
    }
}
