//! What contact costs, and how its errors follow the tolerance.

use plm::{Dop853, Mechanism as _};

use super::one_body::Body;
use crate::declared::Oscillator;
use crate::near;
use crate::scene::{Given as _, Named as _};

/// Ten cycles of stick and slip, into the eleventh slip (case C06, a closed form): no error is larger than ten times the tolerance.
#[test]
fn errors_follow_the_tolerance_through_ten_cycles() {
    let (begins, period, after): (f64, f64, f64) = (0.3924, 0.727_836_962_770_418_5, 0.2);
    let (sin, cos) = (10.0 * after).sin_cos();
    let known = 0.024_525 + 0.014_715 * cos + 0.01 * sin;
    for tolerance in [1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
        let belt =
            Oscillator::new().with("kinetic", 0.25 * 9.81).with("adhesion", 0.4 * 9.81).with("belt", 0.1);
        let belt = belt.with_start("mass.x", 0.0).with_start("mass.vx", 0.1);
        let mut sim = belt.start_with(Dop853::new(tolerance)).unwrap();
        sim.step_to(begins + 10.0 * period + after).unwrap();
        near(sim.state_of("mass").x, known, 10.0 * tolerance);
    }
}

/// Twenty bounces of a ball, whose flights are one step each by a method of order eight.
#[test]
fn an_event_costs_at_most_sixty_evaluations() {
    let ball = Body::new().with("e", 0.9).with_start("body.y", 1.0);
    let mut sim = ball.start_with(Dop853::new(1e-10)).unwrap();
    let first = (2.0 / 9.81_f64).sqrt();
    sim.step_to(first * (1.0 + 2.0 * (0.9 - 0.9_f64.powi(20)) / 0.1)).unwrap();
    let (impacts, evaluations) = (sim.contact_stats().impacts, sim.stats().evaluations);
    assert_eq!(impacts, 20);
    assert!(evaluations <= 60 * impacts, "{evaluations} of {impacts}");
}
