//! Joints with a condition that hold where a run begins: they are closed by the assembly of the start.

use plm::runtime::Cause;
use plm::{Dop853, Mechanism as _};

use crate::declared::HungInBodies;
use crate::near;
use crate::scene::{Given as _, Named as _};

hung!(InJoints, tree);

/// A bob at -60 deg hangs at (-sin 60 deg, -cos 60 deg) and swings with its rate; sides of 0.3, 0.4 and 0.5 m have the angle acos(0.6).
#[test]
fn joints_that_hold_are_closed_by_the_start() {
    for hung in [InJoints::new(), HungInBodies::new()] {
        let mut sim = hung.start_with(Dop853::new(1e-12)).unwrap();
        let angle = -60_f64.to_radians();
        near(sim.state_of("bob").angle, angle, 1e-15);
        near(sim.state_of("bob").x, angle.sin(), 1e-12);
        near(sim.state_of("bob").y, -angle.cos(), 1e-12);
        near(sim.state_of("bob").omega, 1.5, 1e-15);
        near(sim.state_of("bob").vx, 1.5 * angle.cos(), 1e-12);
        near(sim.state_of("bob").vy, 1.5 * angle.sin(), 1e-12);
        near(sim.state_of("crank").angle, 0.6_f64.acos(), 1e-12);
        near(sim.state_of("rod").angle, -(0.8_f64.acos()), 1e-12);
        assert_eq!(sim.contact_stats().impacts, 0);
        // The triangle stands, and the bob keeps its energy.
        sim.step_to(0.5).unwrap();
        near(sim.state_of("crank").angle, 0.6_f64.acos(), 1e-12);
        let (at, omega) = (sim.state_of("bob").angle, sim.state_of("bob").omega);
        near(1.25 * (omega * omega - 2.25), 2.0 * 9.81 * (at.cos() - angle.cos()), 1e-9);
        sim.step_to(1.1).unwrap();
        // After 1 s the rod falls.
        near(sim.state_of("rod").x, 2.34, 1e-12);
        near(sim.state_of("rod").y, 0.12 - 0.5 * 9.81 * 0.01, 1e-11);
    }
}

/// Where a joint does not hold at the start, it takes no part in it: the bob is thrown from where it was put.
#[test]
fn joints_that_do_not_hold_are_left_out() {
    let hung = InJoints::new().with_start("holds", 0.0);
    let mut sim = hung.start_with(Dop853::new(1e-12)).unwrap();
    near(sim.state_of("bob").x, 0.2, 0.0);
    near(sim.state_of("bob").y, 0.0, 0.0);
    near(sim.state_of("bob").vx, 0.0, 0.0);
    sim.step_to(0.1).unwrap();
    near(sim.state_of("bob").y, -0.5 * 9.81 * 0.01, 1e-12);
}

/// Locks that leave no pose are a fault that names the joint.
#[test]
fn a_start_that_no_pose_closes_names_the_joint() {
    let hung = InJoints::new().with_lock("bob.x", 0.2);
    let fault = hung.start_with(Dop853::new(1e-9)).map(|_| ()).unwrap_err();
    let is_named = match fault.cause {
        Cause::Redundant { joints, .. } => joints.to_string().contains("hook"),
        _ => fault.part == "hook",
    };
    assert!(is_named, "{fault}");
}
