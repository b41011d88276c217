//! Long runs: drift of joints and energy, phase, chaos.

use std::f64::consts::FRAC_PI_2;

use plm_runtime::{Dop853, Rk4};

use crate::scenes::dead::{quadrorhomb_on_a_spring, swinging};
use crate::scenes::run::trace;
use crate::scenes::standard::{double_pendulum, four_bar};
use crate::scenes::theory::{G, S1_AT_10, pendulum_period};
use crate::scenes::trees::{pendulum, phase};
use crate::text::{By as _, Named as _, deep};

/// 64 eps L, the gap that rounding may leave in joints of a mechanism of the size L.
fn rounding(length: f64) -> f64 {
    64.0 * f64::EPSILON * length
}

#[test]
fn quadrorhomb_swings_without_drift() {
    // 2e4 of the 1e6 steps that the program makes.
    let trace = deep(|| {
        let mut sim = quadrorhomb_on_a_spring().by(Rk4::new(1e-3)).unwrap();
        swinging(&mut sim, 20.0, 0.1)
    });
    assert!(trace.survived(), "{:?}", trace.end);
    assert!(
        trace.largest(0) < 1e-8 && trace.largest(1) < 1e-9,
        "{:e} {:e}",
        trace.largest(0),
        trace.largest(1)
    );
}

#[test]
fn the_four_bar_swings_without_drift() {
    let mut sim = four_bar().by(Rk4::new(1e-3)).unwrap();
    let energy = sim.kinetic_energy() + sim.gravity_energy();
    let trace = trace(&mut sim, 50.0, 0.1, |s| {
        let [x, y] = s.body_of("coupler").point(0.45, 0.0);
        let [u, v] = s.body_of("rocker").point(0.35, 0.0);
        [(s.kinetic_energy() + s.gravity_energy()) / energy - 1.0, (x - u).hypot(y - v)]
    });
    assert!(trace.survived(), "{:?}", trace.end);
    assert!(
        trace.largest(0) < 1e-8 && trace.largest(1) < 1e-9,
        "{:e} {:e}",
        trace.largest(0),
        trace.largest(1)
    );
}

#[test]
fn a01_keeps_its_phase() {
    assert!((pendulum_period(G.sqrt(), FRAC_PI_2) - 2.367_841_947_576_237_45).abs() < 1e-15 * 4.0);
    let mut sim = pendulum().by(Dop853::new(1e-12)).unwrap();
    let trace = phase(&mut sim, 100.0, 1.0);
    assert!(trace.survived(), "{:?}", trace.end);
    // A phase that is wrong by an error of the frequency of 1e-12 grows by 4e-12 rad/s.
    assert!(trace.largest(0) < 1e-8, "{:e} rad", trace.largest(0));
    assert!(trace.largest(1) < 1e-10, "{:e} J", trace.largest(1));
}

#[test]
fn s1_over_ten_seconds_is_worth_seven_digits() {
    let mut sim = double_pendulum().by(Dop853::new(1e-13)).unwrap();
    sim.step(10.0).unwrap();
    let [arm, forearm] = S1_AT_10;
    let off = (sim.body_of("arm").angle - arm).abs().max((sim.body_of("forearm").angle - forearm).abs());
    // Rounding of 1e-16 grows 1e8-fold; a method adds its own.
    assert!(off < 1e-4, "{off:e} rad");
    assert!(off > rounding(1.0), "better than rounding allows: {off:e} rad");
}
