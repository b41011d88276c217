//! The example of hardware in the loop keeps what the book says of it.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use super::accuracy::{errors, reference, run};
use super::clock::{Beat, failed_periods, measured};
use super::plants::{self, Made};

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

/// The lever jumps from one end to the other, as a loop finds it that has stood still: a step of 1 ms is refused, shorter ones are made,
/// and the arm comes to where it is by a method with error control.
#[test]
fn a_jump_that_a_step_cannot_take_is_made_in_parts() {
    let period = 1e-3;
    let mut step = plants::arm(period).unwrap();
    let mut sim = plants::Arm::new().start_with(plm::RadauIia5::new(1e-9)).unwrap();
    let mut beats = Vec::new();
    let (mut largest, mut angles) = (0.0_f64, Vec::new());
    for k in 0..60 {
        let input = if (k / 20) % 2 == 0 { 1.0 } else { -1.0 };
        let (angle, made) = step(input);
        beats.push(Beat { input, late: Duration::from_millis(k), took: Duration::ZERO, made });
        sim.input.lever = input;
        sim.step(period).unwrap();
        angles.push(sim.arm().angle);
        largest = largest.max((angle - sim.arm().angle).abs());
    }
    let in_parts = beats.iter().filter(|beat| matches!(beat.made, Made::InParts(..))).count();
    assert!(in_parts > 0 && beats.iter().all(|beat| !matches!(beat.made, Made::Held(_))), "{beats:?}");
    // A step is refused where its error is 5 % of a state.
    let range =
        angles.iter().copied().fold(f64::MIN, f64::max) - angles.iter().copied().fold(f64::MAX, f64::min);
    let told = failed_periods(period, &beats);
    println!("{}\n{largest:e} rad of {range:e}", told.join("\n"));
    assert!(largest < 0.05 * range, "{largest} rad of {range}");
    assert!(told[0].contains("ms late, input ") && told[0].contains("shorter steps ("), "{told:?}");
}

/// A host that is busy stops the loop for a while: the steps are made up for, and the last bit is that of the run that is played again.
#[test]
fn a_loop_that_is_held_up_goes_on_and_says_how_late_it_was() {
    const HELD_UP: Duration = Duration::from_millis(40);
    let first = AtomicBool::new(true);
    let beats = measured(1000, 0.2, 2.0, || {
        // The run that is played again is not held up.
        let (slow, mut step, mut count) = (first.swap(false, Ordering::Relaxed), plants::arm(1e-3)?, 0);
        Ok(move |input: f64| {
            count += 1;
            if slow && count == 50 {
                std::thread::sleep(HELD_UP);
            }
            // A lever that has jumped in the meantime.
            step(if count >= 50 { -input.signum() } else { input.signum() })
        })
    })
    .unwrap();
    assert!(beats.len() == 200 && beats[50].late + Duration::from_millis(1) >= HELD_UP, "{:?}", beats[50]);
}
