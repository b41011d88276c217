//! Joints with a condition that hold where a run begins: they are closed by the assembly of the start.

use plm::runtime::Cause;
use plm::{Dop853, mechanism};

use crate::near;

macro_rules! hung {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            /// A bob on a hook, and a rod that two joints with a condition make the last side of a triangle.
            pub $name {
                allow(W0002);
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                discrete holds: 1 = 1;
                ground { port pivot: (0, 0) m; port o: (2, 0) m; port d: (2.5, 0) m; }
                body bob {
                    mass: 2 kg; inertia: 0.5 kg*m^2; port pivot: (0, 1) m;
                    start angle: -60 deg, locked; start omega: 1.5 rad/s, locked;
                    start x: 0.2 m;
                }
                body crank {
                    mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; port a: (0.3, 0) m;
                    start angle: 40 deg;
                }
                body rod {
                    mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-0.2, 0) m; port d: (0.2, 0) m;
                    start x: 2.3 m; start angle: -20 deg;
                }
                revolute hook(ground.pivot, bob.pivot) { when: holds > 0.5; }
                revolute o(ground.o, crank.o);
                revolute a(crank.a, rod.a) { when: t < 1 s; }
                revolute d(rod.d, ground.d) { when: t < 1 s; }
                when bob.angle > 30 deg { holds = 0; }
                output hook.force, holds;
            }
        }
    };
}

hung!(InJoints, tree);
hung!(InBodies, absolute);

/// A bob at -60 deg hangs at (-sin 60 deg, -cos 60 deg) and swings with its rate; sides of 0.3, 0.4 and 0.5 m have the angle acos(0.6).
#[test]
fn joints_that_hold_are_closed_by_the_start() {
    macro_rules! check {
        ($name:ident) => {
            let mut sim = $name::new().start_with(Dop853::new(1e-12)).unwrap();
            let angle = -60_f64.to_radians();
            near(sim.bob().angle, angle, 1e-15);
            near(sim.bob().x, angle.sin(), 1e-12);
            near(sim.bob().y, -angle.cos(), 1e-12);
            near(sim.bob().omega, 1.5, 1e-15);
            near(sim.bob().vx, 1.5 * angle.cos(), 1e-12);
            near(sim.bob().vy, 1.5 * angle.sin(), 1e-12);
            near(sim.crank().angle, 0.6_f64.acos(), 1e-12);
            near(sim.rod().angle, -(0.8_f64.acos()), 1e-12);
            assert_eq!(sim.contact_stats().impacts, 0);
            // The triangle stands, and the bob keeps its energy.
            sim.step_to(0.5).unwrap();
            near(sim.crank().angle, 0.6_f64.acos(), 1e-12);
            let (at, omega) = (sim.bob().angle, sim.bob().omega);
            near(1.25 * (omega * omega - 2.25), 2.0 * 9.81 * (at.cos() - angle.cos()), 1e-9);
            sim.step_to(1.1).unwrap();
            // Behind 1 s the rod falls.
            near(sim.rod().x, 2.34, 1e-12);
            near(sim.rod().y, 0.12 - 0.5 * 9.81 * 0.01, 1e-11);
        };
    }
    check!(InJoints);
    check!(InBodies);
}

/// Where a joint does not hold at the start, it takes no part in it: the bob is thrown from where it was put.
#[test]
fn joints_that_do_not_hold_are_left_out() {
    let mut hung = InJoints::new();
    hung.start.holds.value = 0.0;
    let mut sim = hung.start_with(Dop853::new(1e-12)).unwrap();
    near(sim.bob().x, 0.2, 0.0);
    near(sim.bob().y, 0.0, 0.0);
    near(sim.bob().vx, 0.0, 0.0);
    sim.step_to(0.1).unwrap();
    near(sim.bob().y, -0.5 * 9.81 * 0.01, 1e-12);
}

/// Locks that leave no pose are a fault that names the joint.
#[test]
fn a_start_that_no_pose_closes_names_the_joint() {
    let mut hung = InJoints::new();
    hung.start.bob.x.value = 0.2;
    hung.start.bob.x.locked = true;
    let fault = hung.start_with(Dop853::new(1e-9)).map(|_| ()).unwrap_err();
    let is_named = match fault.cause {
        Cause::Redundant { joints, .. } => joints.to_string().contains("hook"),
        _ => fault.part == "hook",
    };
    assert!(is_named, "{fault}");
}
