//! Conditions that last a small part of a run.

use plm_runtime::method::RadauIia5;
use plm_runtime::{Dop853, Dopri5, Rk4};

use crate::scenes::short_events::{braked, cleared};

#[test]
fn a_brush_is_found_whatever_interval_is_asked_for() {
    for part in [0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        for interval in [10.0, 1.0, 0.1, 0.01] {
            let ([angle, speed], stats) = braked(part, interval, Dop853::default()).unwrap();
            assert_eq!(stats.switches, 2, "{part:e} of the run, intervals of {interval} s");
            // The height of the window's ends is rounded by 1e-16 m: for the last one by 1e-5 of what it is below -1 m.
            assert!(speed.abs() < 5e-8 && angle.abs() < 5e-7, "{part:e}, {interval} s: {angle:e} {speed:e}");
            let early = cleared(part, interval).unwrap().unwrap();
            assert!(early.abs() < 5e-11, "{part:e}, {interval} s: {early:e} s");
        }
    }
}

#[test]
fn other_methods_find_it_too() {
    for part in [1e-2, 1e-6] {
        let found = [
            braked(part, 10.0, Dopri5::new(1e-8)).unwrap(),
            braked(part, 10.0, RadauIia5::new(1e-8)).unwrap(),
        ];
        for ([angle, speed], stats) in found {
            assert_eq!(stats.switches, 2, "{part:e} of the run");
            assert!(speed.abs() < 1e-7 && angle.abs() < 5e-7, "{part:e}: {angle:e} {speed:e}");
        }
    }
}

#[test]
fn steps_of_equal_length_count_what_they_pass_over() {
    for part in [1e-4, 1e-6] {
        let ([_, speed], stats) = braked(part, 10.0, Rk4::new(0.01)).unwrap();
        assert_eq!((stats.switches, stats.passed_over), (0, 1), "{part:e} of the run");
        assert!((speed - (1.0 - 0.75_f64.sqrt())).abs() < 1e-9, "it is not braked: {speed}");
    }
}
