//! Flat poses: the rank of phi_q falls, branches cross, and the motion goes straight on.

use std::f64::consts::TAU;

use plm_runtime::{Dop853, Rk4};

use crate::scenes::flat::{
    Ladder as _, equal_bars, folded, folding, ladder, ladder_at, long_ladder, parallelogram, turning,
    turning_parallelogram,
};
use crate::scenes::run::Trace;
use crate::text::{By as _, deep};

/// Energy to 1e-7 of the start, joints closed, no window askew, and back upright after whole turns of known length.
///
/// The default tolerance is 1e-9 a step; over a hundred steps that may add up to 1e-7.
fn assert_turned(name: &str, trace: &Trace<4>, turns: u32) {
    assert!(trace.survived(), "{name}: {:?}", trace.end);
    let [energy, apart, askew] = [0, 1, 2].map(|column| trace.largest(column));
    assert!(energy < 1e-7 && apart < 1e-12 && askew < 1e-12, "{name}: {energy:e} {apart:e} {askew:e}");
    let after = trace.last()[3] + f64::from(turns) * TAU;
    assert!(after.abs() < 1e-7, "{name}: {after:e}");
}

#[test]
fn ladders_of_one_and_two_windows_turn_through_their_flat_poses() {
    assert_turned("1 window", &turning(&mut ladder(1).begin().unwrap(), 5, 100), 5);
    assert_turned("2 windows", &turning(&mut ladder(2).begin().unwrap(), 5, 100), 5);
}

#[test]
fn a_ladder_of_five_windows_turns_over_at_any_speed() {
    for speed in [0.3, 3.0, 30.0] {
        let name = format!("5 windows, {speed} m/s");
        deep(move || {
            assert_turned(&name, &turning(&mut ladder_at(speed).begin().unwrap(), 1, 1000), 1);
            // The same in steps of a millisecond.
            let mut sim = ladder_at(speed).begin().unwrap();
            let energy = sim.state().energy();
            let (mut lost, mut askew) = (0.0_f64, 0.0_f64);
            for _ in 0..600 {
                sim.step(1e-3).unwrap_or_else(|fault| panic!("{name}: {fault}"));
                lost = lost.max((sim.state().energy() / energy - 1.0).abs());
                askew = askew.max(sim.state().askew());
            }
            assert!(lost < 2e-11 && askew < 1e-13, "{name}: {lost:e} {askew:e}");
        });
    }
}

#[test]
fn a_ladder_of_five_windows_turns_over_at_any_tolerance() {
    for rtol in [1e-8, 1e-9, 1e-10, 3e-11, 1e-11, 3e-12, 1e-12] {
        deep(move || {
            let mut sim = long_ladder(5).by(Dop853::new(rtol)).unwrap();
            let trace = turning(&mut sim, 5, 100);
            assert!(trace.survived(), "{rtol:e}: {:?}", trace.end);
            let after = trace.last()[3] + 5.0 * TAU;
            assert!(after.abs() < 1000.0 * rtol + 5e-9, "{rtol:e}: {after:e}");
            assert_eq!(sim.stats().change_points, 10, "{rtol:e}");
        });
    }
}

#[test]
fn a_ladder_of_forty_windows_turns_through_its_flat_poses() {
    let trace = deep(|| turning(&mut long_ladder(40).begin().unwrap(), 2, 100));
    assert_turned("40 windows", &trace, 2);
}

#[test]
fn fixed_steps_carry_a_ladder_through_its_flat_poses() {
    // Without stabilisation it blows up at this step, at 4.61 s; with alpha = beta = 10 the position is wrong by 1.6e-4 m.
    let mut sim = ladder(2).by(Rk4::new(0.01)).unwrap();
    let trace = turning(&mut sim, 5, 100);
    assert!(trace.survived() && trace.largest(0) < 1e-7, "{:?} {:e}", trace.end, trace.largest(0));
    assert!(trace.largest(2) < 1e-12, "{:e}", trace.largest(2));
}

#[test]
fn a_parallelogram_stays_one_beyond_its_change_points() {
    let mut sim = parallelogram().begin().unwrap();
    let trace = turning_parallelogram(&mut sim, 5);
    assert!(trace.survived(), "{:?}", trace.end);
    let [energy, askew, after] = [0, 1, 2].map(|column| trace.largest(column));
    assert!(energy < 1e-9 && askew < 1e-12 && after < 1e-8, "{energy:e} {askew:e} {after:e}");
    // Twice a turn all bars lie in one line.
    assert_eq!(sim.stats().change_points, 10);
}

#[test]
fn a_folded_slider_crank_keeps_energy_and_branch() {
    // 1/2 8 (1/3 + 5/4 + 1/12) + 1/2 4^2 for crank, rod and slider, and the height of both bars.
    let known = 4.0 * 5.0 / 3.0 + 8.0 + 9.81 * 0.5_f64.sqrt();
    let trace = folding(&mut folded().begin().unwrap(), 10.0);
    assert_kept(&trace, known);
}

#[test]
fn a_slider_crank_of_equal_bars_keeps_its_47_50_joules() {
    let trace = folding(&mut equal_bars().begin().unwrap(), 10.0);
    assert_kept(&trace, 39.0 + 9.81 * 0.75_f64.sqrt());
    assert!((trace.last()[0] - 47.50).abs() < 0.005);
}

fn assert_kept(trace: &Trace<3>, known: f64) {
    assert!(trace.survived(), "{:?}", trace.end);
    let energies = trace.rows.iter().map(|(_, [energy, ..])| (energy / known - 1.0).abs());
    let lost = energies.fold(0.0, f64::max);
    assert!(lost < 1e-6, "{lost:e} of {known} J");
    let (branch, open) = (trace.largest(1), trace.largest(2));
    assert!(branch < 1e-12 && open < 1e-12, "{branch:e} rad, {open:e} m");
}
