//! Loops that come next to flat: they turn back sharply, each on its own side, and keep their energy.

use std::f64::consts::FRAC_PI_2;

use plm_runtime::Moment as _;

use crate::scenes::near_singular::{
    Passed, cranks, energy, folding, from, nearly_parallel, parallel, swinging,
};
use crate::scenes::theory::{G, bisect, pendulum_angle};
use crate::text::{By as _, Given as _, Scene};

/// The default tolerance is 1e-9 a step; over the steps of a turn that may add up to some 1e-8.
fn assert_passed(name: &str, by: f64, passed: &Passed) {
    assert!(passed.end.is_ok(), "{name}, {by:e} m: {:?}", passed.end);
    assert!(passed.energy < 2e-8, "{name}, {by:e} m: {:e} of the energy", passed.energy);
    assert!(passed.late.abs() < 3e-9, "{name}, {by:e} m: {:e} s", passed.late);
    assert_eq!(passed.change_points, u64::from(by == 0.0), "{name}, {by:e} m");
}

#[test]
fn nearly_parallel_cranks_turn_back_where_their_lengths_say() {
    for by in [0.0, 1e-14, -1e-11, 1e-6, -1e-4, 1e-2] {
        assert_passed("four-bar", by, &parallel(by, 0.8).unwrap());
    }
}

#[test]
fn a_nearly_folded_slider_crank_turns_back_where_its_lengths_say() {
    for by in [0.0, -1e-14, 1e-9, -1e-5, 1e-3] {
        assert_passed("slider-crank", by, &folding(by, 0.6).unwrap());
    }
}

/// Lengths that differ by nine units in their last place are not equal.
#[test]
fn the_last_digits_of_lengths_decide() {
    for by in [2e-15, -2e-15] {
        assert_passed("slider-crank", by, &folding(by, 0.6).unwrap());
    }
}

/// The right crank after a run of `until`, s, in which the energy is kept.
fn keeps_energy(name: &str, linkage: &Scene, until: f64) -> [f64; 2] {
    let mut sim = linkage.begin().unwrap();
    let trace = swinging(&mut sim, until);
    assert!(trace.survived() && trace.largest(0) < 2e-8, "{name}: {:?}, {:e}", trace.end, trace.largest(0));
    assert!(sim.stats().near_singular > 0 && sim.stats().change_points == 0, "{name}: {:?}", sim.stats());
    cranks(&sim)[1]
}

/// Cranks of 1/3 m and 0.3333333 m, of 0.5 m and 0.500001 m, under gravity, in either formulation.
#[test]
fn cranks_that_were_rounded_differently_keep_their_energy() {
    for (left_length, right_length) in [(1.0 / 3.0, 0.333_333_3), (0.5, 0.500_001)] {
        let name = format!("{left_length} and {right_length} m");
        let [found, other] = nearly_parallel().map(|linkage| {
            let linkage = linkage.with("gravity_y", G).with("span", 1.0);
            let linkage = linkage.with("left_length", left_length).with("right_length", right_length);
            keeps_energy(&name, &from(&linkage, FRAC_PI_2, 3.0), 0.6)
        });
        let off = [0, 1].map(|k| (found[k] - other[k]).abs());
        assert!(off[0] < 2e-8 && off[1] < 2e-7, "{name}: {off:?}");
    }
}

/// Cranks that are alike move as one pendulum, wherever they start; the known angle of it at a time.
///
/// Both cranks of 0.5 m and the bar, of 1 kg and 0.1 kg m^2 each: m g (r/2 + r/2 + r) over 2 (I + m r^2/4) + m r^2.
fn pendulum(angle: f64, speed: f64) -> impl Fn(f64) -> f64 {
    let w = (G / (2.0 * (0.1 + 0.0625) + 0.25)).sqrt();
    let hanging = angle + FRAC_PI_2;
    let amplitude = (hanging.cos() - 0.5 * (speed / w).powi(2)).acos();
    // It comes to its highest place so much later.
    let highest = match speed {
        0.0 => 0.0,
        _ => bisect(0.0, 0.5 / w, |t| pendulum_angle(w, amplitude, t) > hanging),
    };
    move |t| pendulum_angle(w, amplitude, (t - highest).abs()) - FRAC_PI_2
}

/// From an angle next to flat: what is locked starts as it is locked, and the cranks stay parallel beyond flat.
fn assert_swings(name: &str, linkage: &Scene, angle: f64, speed: f64) {
    let mut sim = from(linkage, angle, speed).begin().unwrap();
    let [left, right] = cranks(&sim);
    assert_eq!(left, [angle, speed], "{name}");
    assert!((right[1] - speed).abs() < 4e-10, "{name}: {:e} rad/s", right[1]);
    let (known, mut off) = (pendulum(angle, speed), 0.0_f64);
    let end = sim.run(0.4, 1e-2, |state| {
        let ([left, right], known) = (cranks(state), known(state.time()));
        off = off.max((left[0] - known).abs()).max((right[0] - known).abs());
    });
    assert!(end.is_ok() && off < 1e-9, "{name}: {off:e} rad, {end:?}");
    assert!(sim.stats().change_points > 0, "{name}");
}

#[test]
fn starts_next_to_flat_are_what_was_declared() {
    for (angle, speed) in [(0.05_f64.to_radians(), 0.1), (1e-3, 0.1), (0.5_f64.to_radians(), 0.0)] {
        let [loops, absolute] = nearly_parallel().map(|linkage| linkage.with("gravity_y", G));
        assert_swings(&format!("{angle} rad, {speed} rad/s"), &loops, angle, speed);
        assert_swings(&format!("{angle} rad, {speed} rad/s, absolute"), &absolute, angle, speed);
    }
}

/// Samples within the steps that lead over flat poses lie on the way: a turn at constant speed.
#[test]
fn samples_within_a_step_over_a_flat_pose_lie_on_the_way() {
    let [linkage, _] = nearly_parallel();
    let linkage = linkage.with("span", 1.0).with("left_length", 0.6).with("right_length", 0.6);
    let mut sim = from(&linkage, 1.0, 7.0).begin().unwrap();
    let begun = energy(&sim);
    let mut off = [0.0_f64; 2];
    sim.run(20.0, 1e-3, |state| {
        off[0] = off[0].max((energy(state) / begun - 1.0).abs());
        off[1] = off[1].max((cranks(state)[0][0] - 1.0 - 7.0 * state.time()).abs());
    })
    .unwrap();
    assert!(off[0] < 1e-10 && off[1] < 1e-9, "{off:?}");
    assert_eq!(sim.stats().change_points, 44);
}
