//! Contact of shapes: circles, lines, polygons, profiles; wheels, cams and indexing.

use plm::runtime::contact::Mode;
use plm::{Mechanism, Moment, Sim};

mod cams;
mod circles;
mod grounds;
mod polygons;
mod polylines;
mod rolling;
mod wheels;

const G: f64 = 9.81;

/// Asserts that two numbers differ by `within` at most.
#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}

/// Runs to where a row opens, by bisection.
fn opens<M: Mechanism<S = f64>>(sim: &mut Sim<M>, row: &str) {
    let mut saved = sim.save();
    while sim.contact(row) == Some(Mode::Closed) {
        assert!(sim.state().time() < 10.0, "{row} does not open");
        saved = sim.save();
        sim.step(0.01).unwrap();
    }
    let (mut low, mut high) = (sim.state().time() - 0.01, sim.state().time());
    for _ in 0..30 {
        let half = 0.5 * (low + high);
        sim.resume(&saved);
        sim.step_to(half).unwrap();
        *(if sim.contact(row) == Some(Mode::Closed) { &mut low } else { &mut high }) = half;
    }
    sim.resume(&saved);
    sim.step_to(low).unwrap();
}
