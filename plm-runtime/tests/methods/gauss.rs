//! Gauss collocation: order, symmetries, long runs.

use core::f64::consts::TAU;

use plm_runtime::method::Gauss;
use plm_runtime::{Cause, Mechanism, Method};

use crate::oscillator::{Oscillator, error, oscillator};
use crate::smooth::{DoublePendulum, Kepler, Spring};

fn error_with(method: impl Method<Oscillator<f64>>) -> f64 {
    let mut sim = oscillator().start_with(method).unwrap();
    sim.step(2.0).unwrap();
    error(2.0, &sim.x)
}

#[test]
fn orders_are_4_and_6() {
    let two = (error_with(Gauss::<_, 2>::new(0.1)) / error_with(Gauss::<_, 2>::new(0.05))).log2();
    let three = (error_with(Gauss::<_, 3>::new(0.2)) / error_with(Gauss::<_, 3>::new(0.1))).log2();
    println!("Gauss 2: {two:.3}, Gauss 3: {three:.3}");
    assert!((two - 4.0).abs() < 0.05, "{two}");
    assert!((three - 6.0).abs() < 0.1, "{three}");
}

/// The double pendulum of the long runs: large swings, not yet chaotic over the time that they take.
fn double_pendulum() -> DoublePendulum<f64> {
    DoublePendulum { gravity: 9.81, first: 0.9, second: 0.3 }
}

#[test]
fn the_way_back_is_the_way_out() {
    // Chaos would amplify rounding; this amplitude does not.
    let system = DoublePendulum { first: 0.3, second: 0.2, ..double_pendulum() };
    let mut sim = system.start_with(Gauss::<_, 3>::new(0.01)).unwrap();
    let start = sim.x;
    sim.step(10.0).unwrap();
    (sim.x[2], sim.x[3]) = (-sim.x[2], -sim.x[3]);
    sim.step(10.0).unwrap();
    for i in 0..4 {
        assert!((sim.x[i] - start[i]).abs() < 1e-13, "{:?} {start:?}", sim.x);
    }
}

#[test]
fn energy_does_not_drift() {
    let system = double_pendulum();
    let mut sim = system.start_with(Gauss::<_, 3>::new(0.01)).unwrap();
    let start = system.energy(&sim.x);
    let mut errors = Vec::new();
    sim.run(1000.0, 1.0, |moment| errors.push((system.energy(&moment.x) - start) / start)).unwrap();
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    let worst = errors.iter().fold(0.0, |worst, e| f64::max(worst, e.abs()));
    let drift = (mean(&errors[800..]) - mean(&errors[..200])).abs();
    println!("worst {worst:e}, drift {drift:e} in 1e5 steps; {:?}", sim.stats());
    assert!(worst < 2e-11, "{worst:e}");
    assert!(drift < 1e-12, "{drift:e}");
}

#[test]
fn quadratic_invariants_are_kept_to_rounding() {
    let mut sim = Kepler { e: 0.3 }.start_with(Gauss::<_, 2>::new(TAU / 200.0)).unwrap();
    let momentum = |x: &[f64; 4]| x[0] * x[3] - x[1] * x[2];
    let start = momentum(&sim.x);
    let mut worst: f64 = 0.0;
    sim.run(100.0 * TAU, TAU, |moment| worst = worst.max((momentum(&moment.x) - start).abs())).unwrap();
    println!("angular momentum {worst:e} in 2e4 steps");
    // The sums of 2e4 steps round off 1e-16 each: 1.4e-14 as a random walk.
    assert!(worst < 1e-14, "{worst:e}");
}

#[test]
fn rounding_grows_as_a_random_walk_at_most() {
    // The exact solution of the method is a rotation of constant radius; 1e6 steps, 160 periods.
    let mut sim = Spring { w: 1.0_f64, z: 0.0 }.start_with(Gauss::<_, 3>::new(1e-3)).unwrap();
    let mut worst: f64 = 0.0;
    sim.run(1000.0, 10.0, |moment| {
        let [q, v] = moment.x;
        worst = worst.max((q * q + v * v - 1.0).abs());
    })
    .unwrap();
    println!("energy {worst:e} in 1e6 steps; {:?}", sim.stats());
    assert!(worst < 1e-15, "{worst:e}");
}

#[test]
fn few_iterations_are_needed() {
    let mut sim = double_pendulum().start_with(Gauss::<_, 2>::new(0.01)).unwrap();
    sim.step(1.0).unwrap();
    let per_step = sim.stats().evaluations as f64 / sim.stats().steps as f64;
    println!("{per_step} evaluations a step");
    assert!(per_step < 20.0, "{per_step}");
    assert_eq!((sim.stats().jacobians, sim.stats().factorisations), (0, 0));
}

#[test]
fn steps_that_are_too_long_for_the_stiffness_are_refused() {
    let mut sim = Spring { w: 1e4, z: 0.0 }.start_with(Gauss::<_, 2>::new(0.01)).unwrap();
    let fault = sim.step(1.0).unwrap_err();
    assert_eq!(fault.cause, Cause::NotConverged { step: 0.01 });
    assert_eq!((sim.time, sim.x), (0.0, [1.0, 0.0]));
}

#[test]
fn another_step_length_takes_the_stages_along() {
    // Intervals of changing length: the guess is wrong by more, the result is not.
    let mut sim = oscillator().start_with(Gauss::<_, 3>::new(0.05)).unwrap();
    for dt in [0.05, 0.03, 0.12, 0.2, 0.6, 1.0] {
        sim.step(dt).unwrap();
    }
    assert!(error(2.0, &sim.x) < 2e-9, "{}", error(2.0, &sim.x));
}
