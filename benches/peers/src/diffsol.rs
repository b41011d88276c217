//! diffsol: its explicit method of order 5 (Tsitouras) and its BDF, on the minimal equations.

use std::cell::Cell;
use std::time::Instant;

use diffsol::{
    NalgebraLU, NalgebraMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector,
};

use crate::minimal::{Andrews, DoublePendulum, FourBar, Scene, SliderCrank};
use crate::{Peer, Run, Setting};

pub(crate) const PEERS: &[Peer] = &[
    peer("S1", "diffsol Tsit45", |rtol| run(DoublePendulum, Kind::Tsit45, rtol)),
    peer("S1", "diffsol BDF", |rtol| run(DoublePendulum, Kind::Bdf, rtol)),
    peer("S2", "diffsol Tsit45", |rtol| run(FourBar, Kind::Tsit45, rtol)),
    peer("S2", "diffsol BDF", |rtol| run(FourBar, Kind::Bdf, rtol)),
    peer("S5", "diffsol Tsit45", |rtol| run(Andrews, Kind::Tsit45, rtol)),
    peer("S5", "diffsol BDF", |rtol| run(Andrews, Kind::Bdf, rtol)),
    peer("S6", "diffsol Tsit45", |rtol| run(SliderCrank, Kind::Tsit45, rtol)),
    peer("S6", "diffsol BDF", |rtol| run(SliderCrank, Kind::Bdf, rtol)),
];

const fn peer(scene: &'static str, name: &'static str, run: fn(f64) -> Option<Run>) -> Peer {
    Peer { scene, name, setting: Setting::Tolerance, run }
}

#[derive(Clone, Copy)]
enum Kind {
    Tsit45,
    Bdf,
}

/// A scene to its end.
fn run<S: Scene>(scene: S, kind: Kind, rtol: f64) -> Option<Run> {
    let count = Cell::new(0_u64);
    let rate = |x: &[f64], _: &[f64], _: f64, dx: &mut [f64]| {
        count.set(count.get() + 1);
        scene.rate(x, dx);
    };
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(rtol)
        .atol([rtol])
        .rhs_implicit(rate, |x, _, _, v, product| along(scene, x, v, product))
        .init(|_, _, x| x.copy_from_slice(&scene.start()), S::SIZE)
        .build()
        .ok()?;
    let (seconds, x) = match kind {
        Kind::Tsit45 => advance(problem.tsit45().ok()?, S::UNTIL)?,
        Kind::Bdf => advance(problem.bdf::<NalgebraLU<f64>>().ok()?, S::UNTIL)?,
    };
    Some(Run { seconds, evaluations: count.get(), measured: scene.measured(&x) })
}

/// Steps to the end, in s; the time that this takes, and the state there.
fn advance<'a, E>(mut solver: impl OdeSolverMethod<'a, E>, until: f64) -> Option<(f64, Vec<f64>)>
where
    E: OdeEquations<T = f64> + 'a,
{
    let begin = Instant::now();
    solver.set_stop_time(until).ok()?;
    while !matches!(solver.step().ok()?, OdeSolverStopReason::TstopReached) {}
    let seconds = begin.elapsed().as_secs_f64();
    Some((seconds, solver.state().y.clone_as_vec()))
}

/// The product of the Jacobian with `v`, by a central difference: enough for Newton's method.
fn along<S: Scene>(scene: S, x: &[f64], v: &[f64], product: &mut [f64]) {
    const SHIFT: f64 = 6e-6;
    let shifted = |by: f64| x.iter().zip(v).map(|(x, v)| x + by * v).collect::<Vec<_>>();
    let mut after = vec![0.0; S::SIZE];
    scene.rate(&shifted(SHIFT), product);
    scene.rate(&shifted(-SHIFT), &mut after);
    for (product, after) in product.iter_mut().zip(after) {
        *product = (*product - after) / (2.0 * SHIFT);
    }
}
