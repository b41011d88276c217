//! Runs of the manual's hydraulic arm: accuracy, and what ends them.

use plm::{Cause, Dop853, Moment as _};

use crate::demos::connect_plm_hyd::{ConnectPlmHyd, at_rest, on_the_stop};

/// All states every 5 ms for 4 s.
fn states(rtol: f64) -> Vec<Vec<f64>> {
    let mut sim = on_the_stop().unwrap().start_with(Dop853::new(rtol)).unwrap();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    sim.run(4.0, 0.005, |state| rows.push(state.x().to_vec())).unwrap();
    rows
}

#[test]
fn no_state_moves_by_more_than_a_ten_thousandth_of_its_range_if_the_tolerance_is_cut() {
    let (rough, fine) = (states(1e-6), states(1e-7));
    for k in 0..rough[0].len() {
        let range =
            fine.iter().fold((f64::MAX, f64::MIN), |(low, high), row| (row[k].min(low), row[k].max(high)));
        let moved = rough.iter().zip(&fine).map(|(a, b)| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        let range = range.1 - range.0;
        assert!(range > 0.0 && moved < 1e-4 * range, "state {k}: {moved:e} of {range:e}");
    }
}

#[test]
fn oil_that_is_torn_ends_the_run_and_names_the_chamber() {
    let mut sim =
        at_rest(&ConnectPlmHyd { rated_drop: 0.5e5, ..ConnectPlmHyd::new() }).unwrap().start().unwrap();
    let fault = sim.step(4.0).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("press.chamber1.above_vacuum", Cause::Required));
    assert_eq!(sim.time(), fault.time);
    // The state is where the requirement stops to hold, and it goes no further.
    assert!((sim.press_pressure1() + 101_325.0).abs() < 1.0, "{}", sim.press_pressure1());
    assert_eq!(sim.step(1e-3).unwrap_err().cause, Cause::Required);
    assert!(
        fault
            .to_string()
            .ends_with("s: press.chamber1.above_vacuum: this requirement does not hold any more")
    );
}

#[test]
fn a_start_below_vacuum_is_told_too() {
    let mut arm = ConnectPlmHyd::new();
    arm.start.line2_inlet_pressure.value = -1.1e5;
    let fault = arm.start().unwrap().step(1e-3).unwrap_err();
    assert_eq!((fault.part, fault.time), ("line2.inlet.above_vacuum", 0.0));
    assert!(matches!(fault.cause, Cause::NotMet { by } if by > 0.0), "{fault}");
}
