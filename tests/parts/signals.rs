//! Signals that are bounded, switched and sampled.

use std::f64::consts::{PI, TAU};

use plm::{Mechanism as _, Moment as _};

use crate::declared::{Delays, Hiss, Signals};
use crate::scene::{Given as _, Named as _};

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}");
}

#[test]
fn bounds_of_a_signal_and_of_its_rate_are_kept() {
    let mut sim = Signals::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    for k in 1..=37 {
        sim.step_to(0.027 * f64::from(k)).unwrap();
        let t = sim.time();
        // At the greatest rate up to rate times lag, then exponentially.
        let climb = if t < 0.4 { 2.0 * t } else { 1.0 - 0.2 * f64::exp(-(t - 0.4) / 0.1) };
        near(sim.value_of("climb.value"), climb, 1e-9);
        let fall = if t < 0.45 { 1.0 - 4.0 * t } else { -1.0 + 0.2 * f64::exp(-(t - 0.45) / 0.05) };
        near(sim.value_of("fall.value"), fall, 1e-9);
        near(sim.value_of("bounded.value"), (2.0 * (TAU * t).sin()).clamp(-0.5, 1.0), 1e-12);
    }
}

/// On from a twelfth of a period on, off from seven twelfths on.
#[test]
fn a_switch_with_hysteresis_turns_at_both_bounds() {
    let mut sim = Signals::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    for k in 1..=24 {
        sim.step_to(0.05 * f64::from(k)).unwrap();
        let t = sim.time();
        let (turns, phase) = (t.floor(), t - t.floor());
        let on = turns * 0.5 + (phase - 1.0 / 12.0).clamp(0.0, 0.5);
        near(sim.value_of("area"), 3.0 * on - 2.0 * (t - on), 1e-9);
        let is_on = (1.0 / 12.0..7.0 / 12.0).contains(&phase);
        near(sim.value_of("relay.value"), if is_on { 3.0 } else { -2.0 }, 0.0);
    }
}

#[test]
fn samples_come_out_late() {
    let mut sim = Delays::new().start().unwrap();
    for k in 0..60 {
        // In the middle between two samples.
        sim.step_to(0.02 * f64::from(k) + 0.01).unwrap();
        near(sim.value_of("late.value"), 0.02 * f64::from((k - 4).max(0)), 1e-12);
        let last = ((sim.time() / 0.028).floor() - 1.0).max(0.0);
        near(sim.value_of("one.value"), (TAU * 0.028 * last).sin(), 1e-12);
    }
}

/// The plant between samples in closed form, the controller by its difference equation.
#[test]
fn a_sampled_controller_is_its_difference_equation() {
    let mut sim = Signals::new().start_with(plm::Dop853::new(1e-12)).unwrap();
    let (period, decay) = (0.01, f64::exp(-0.01 / 0.05));
    let [mut plant, mut value, mut sum, mut last] = [0.0; 4];
    let (mut bounded, mut free) = (0, 0);
    for k in 1..60 {
        plant = value + (plant - value) * decay;
        let error = 1.0 - plant;
        let wanted = 2.0 * error + 20.0 * (sum + period * error) + 5e-3 * (error - last) / period;
        if (0.0..=1.05).contains(&wanted) {
            sum += period * error;
            free += 1;
        } else {
            bounded += 1;
        }
        (value, last) = (wanted.clamp(0.0, 1.05), error);
        sim.step_to(period * (f64::from(k) + 0.5)).unwrap();
        near(sim.value_of("control.value"), value, 1e-8);
        near(sim.value_of("plant"), value + (plant - value) * decay.sqrt(), 1e-8);
    }
    assert!(bounded > 3 && free > 40, "{bounded} {free}");
    near(sim.value_of("plant"), 1.0, 1e-2);
}

/// Park and Miller state the number that the seed 1 leads to by 10 000 steps: 1043618065.
#[test]
fn noise_is_the_published_sequence() {
    let mut seed = 1_u64;
    let mut next = || {
        seed = seed * 16807 % 2_147_483_647;
        seed as f64
    };
    // The last 300 of them are those of 150 normal numbers.
    let begins = (0..9700).map(|_| next()).last().unwrap();
    let mut mechanism = Hiss::new();
    mechanism = mechanism.with_start("normal.seed", begins);
    mechanism = mechanism.with_start("even.seed", begins);
    let mut sim = mechanism.start_with(plm::Rk4::new(0.05)).unwrap();
    let modulus = 2_147_483_647.0;
    for k in 1..=150 {
        sim.step_to(1e-3 * (f64::from(k) + 0.5)).unwrap();
        let (first, second) = (next() / modulus, next() / modulus);
        let known = 2.0 + 0.5 * (-2.0 * first.ln()).sqrt() * (2.0 * PI * second).cos();
        near(sim.value_of("normal.value"), known, 1e-12);
        if k == 2 {
            let first = begins * 16807.0 % modulus;
            assert_eq!(sim.value_of("even.seed"), first);
            near(sim.value_of("even_value"), 12.0_f64.sqrt() * (first / modulus - 0.5), 1e-15);
        }
    }
    assert_eq!(sim.value_of("normal.seed"), 1_043_618_065.0);
}
