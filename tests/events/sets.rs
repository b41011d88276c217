//! Events that set states, against closed forms.

use plm::{BodyState, Dop853, Mechanism as _, Moment as _};

use crate::declared::{Ball, FourBar, InAbsolute, InTree, Oven};
use crate::scene::{Named as _, Scene};

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}

/// t_n+1 = t_n + 2 e^n sqrt(2 h/g).
#[test]
fn a_ball_is_thrown_back() {
    let mut sim = Ball::new().start_with(Dop853::new(1e-11)).unwrap();
    let (first, e): (f64, f64) = ((2.0_f64 / 9.81).sqrt(), 0.5);
    let mut begins = first;
    for n in 1..5 {
        let flight = 2.0 * e.powi(n) * first;
        sim.step_to(begins + 0.5 * flight).unwrap();
        near(sim.state_of("ball").y, e.powi(2 * n), 1e-10);
        near(sim.value_of("bounces"), f64::from(n), 0.0);
        begins += flight;
    }
    let second = first * (1.0 + 2.0 * e);
    near(sim.value_of("warmth"), second + 3.0 * (sim.time() - second), 1e-10);
}

/// Cooling ln(20/10) s, heating ln(30/20) s.
#[test]
fn a_relay_has_hysteresis_and_a_clock_samples() {
    let mut sim = Oven::new().start_with(Dop853::new(1e-12)).unwrap();
    let first = (15.0_f64 / 10.0).ln();
    let (heats, cools) = ((30.0_f64 / 20.0).ln(), 2.0_f64.ln());
    for k in 0..5 {
        let begun = first + f64::from(k) * (heats + cools);
        sim.step_to(begun + 1e-9).unwrap();
        near(sim.value_of("heat"), 290.0, 1e-6);
        near(sim.value_of("on"), 1.0, 0.0);
        sim.step_to(begun + heats + 1e-9).unwrap();
        near(sim.value_of("heat"), 300.0, 1e-6);
        near(sim.value_of("on"), 0.0, 0.0);
    }
    let time = sim.time();
    near(sim.value_of("samples") + sim.value_of("full"), (time * 10.0).floor(), 0.0);
    let at = 0.1 * (time * 10.0).floor();
    let since = at - (first + 4.0 * (heats + cools));
    near(
        sim.value_of("last"),
        if since > heats { 280.0 + 20.0 * (heats - since).exp() } else { 320.0 - 30.0 * (-since).exp() },
        1e-8,
    );
}

/// The hinge is stopped by impulses at the first body; the second one keeps its angular momentum about the hinge.
fn stopped(mechanism: Scene) -> f64 {
    let mut sim = mechanism.start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.25 - 1e-9).unwrap();
    let (first, second) = (sim.state_of("first"), sim.state_of("second"));
    let (sin, cos) = (0.4 * second.angle.sin(), 0.4 * second.angle.cos());
    let momentum = 0.2 * second.omega + cos * second.vy - sin * second.vx;
    sim.step_to(0.25).unwrap();
    near(sim.state_of("first").omega, 0.0, 1e-12);
    near(sim.state_of("first").vx.hypot(sim.state_of("first").vy), 0.0, 1e-12);
    near(sim.state_of("second").omega, momentum / (0.2 + 0.16), 1e-7);
    near(sim.state_of("first").angle, first.angle, 1e-8);
    sim.state_of("second").omega
}

#[test]
fn a_velocity_is_set_as_by_impulses() {
    near(stopped(InTree::new()), stopped(InAbsolute::new()), 1e-9);
}

#[test]
fn a_loop_goes_on_with_the_velocity_that_was_set() {
    let mut sim = FourBar::new().start_with(Dop853::new(1e-11)).unwrap();
    while sim.state_of("crank").angle < 400_f64.to_radians() - 1e-2 {
        sim.step(1e-3).unwrap();
    }
    let ratio = |crank: BodyState<f64>, rocker: BodyState<f64>| rocker.omega / crank.omega;
    let mut before = ratio(sim.state_of("crank"), sim.state_of("rocker"));
    while sim.state_of("crank").omega > 2.5 {
        before = ratio(sim.state_of("crank"), sim.state_of("rocker"));
        sim.step(1e-6).unwrap();
    }
    near(sim.state_of("crank").angle, 400_f64.to_radians(), 1e-5);
    near(sim.state_of("crank").omega, 2.0, 1e-5);
    near(ratio(sim.state_of("crank"), sim.state_of("rocker")), before, 1e-5);
    let energy = sim.kinetic_energy();
    sim.step(1.0).unwrap();
    near(sim.kinetic_energy(), energy, 1e-9);
    assert!(sim.drift().phi < 1e-12);
}
