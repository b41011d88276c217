//! The example of hardware in the loop keeps what the book says of it.
#![allow(clippy::unwrap_used, missing_docs, unreachable_pub, dead_code, reason = "tests")]

#[path = "../examples/real_time/accuracy.rs"]
mod accuracy;
#[path = "../examples/real_time/clock.rs"]
mod clock;
#[path = "../examples/real_time/plants.rs"]
mod plants;

use accuracy::{errors, reference, run};
use clock::measured;

/// The lever goes up and down once.
const PERIODS: u32 = 1000;

#[test]
fn thin_lines_step_at_1_khz_where_rk4_needs_20() {
    let known = reference(PERIODS).unwrap();
    let implicit = run(PERIODS, 1, plants::arm::State::step_linearly_implicit).unwrap();
    let largest = errors(&implicit, &known).into_iter().fold(0.0, f64::max);
    assert!(largest < 0.01, "{largest}");

    let explicit = |division| run(PERIODS, division, plants::arm::State::step_rk4);
    for division in [1, 5, 10] {
        let found = explicit(division).map(|found| errors(&found, &known).into_iter().fold(0.0, f64::max));
        assert!(!found.is_ok_and(|error| error < 0.1), "{division}");
    }
    let largest = errors(&explicit(50).unwrap(), &known).into_iter().fold(0.0, f64::max);
    assert!(largest < 1e-4, "{largest}");
}

#[test]
fn a_loop_against_the_clock_is_played_again_to_the_bit() {
    let beats = measured(1000, 0.2, 2.0, || plants::four_bar(1e-3)).unwrap();
    assert_eq!(beats.len(), 200);
    assert!(beats.iter().all(|beat| beat.input.is_finite() && beat.took.as_secs() < 1), "{beats:?}");
    assert!(measured(1000, 0.2, 0.2, || plants::arm(1e-3)).is_ok());
}
