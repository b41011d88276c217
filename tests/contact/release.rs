//! Constraints and joints that hold while a condition does.

use plm::{Dop853, Mechanism as _, Moment as _};

use crate::declared::{Dog, Released};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

released!(ReleasedInAbsolute, absolute);

/// Energy to the moment of release, then a throw that keeps the angular velocity; the reaction is that of a pendulum.
fn thrown(mechanism: Scene) {
    let mut sim = mechanism.start_with(Dop853::new(1e-12)).unwrap();
    let g = 9.81_f64;
    let (start, inertia) = (sim.state_of("bob").angle, 2.5_f64);
    near(start, -60_f64.to_radians(), 1e-4);
    let speed = |angle: f64| (2.0 * 2.0 * g * (angle.cos() - start.cos()) / inertia).sqrt();
    while sim.state_of("bob").angle < 0.0 {
        sim.step(1e-3).unwrap();
    }
    let (angle, omega) = (sim.state_of("bob").angle, sim.state_of("bob").omega);
    near(omega, speed(angle), 1e-9);
    near(sim.state_of("bob").x, angle.sin(), 1e-14);
    near(sim.state_of("bob").y, -angle.cos(), 1e-14);
    // What the joint does to the ground: the weight and the centrifugal force of the bob.
    let alpha = -2.0 * g * angle.sin() / inertia;
    let down = 2.0 * (g + alpha * angle.sin() + omega * omega * angle.cos());
    near(sim.value_of("hinge.force.y"), -down, 1e-9);
    let mut before = sim.time();
    while sim.value_of("holds") > 0.5 {
        before = sim.time();
        sim.step(1e-3).unwrap();
    }
    assert!(sim.time() - before < 2e-3);
    let release = 30_f64.to_radians();
    let (vx, vy) = (speed(release) * release.cos(), speed(release) * release.sin());
    near(sim.state_of("bob").omega, speed(release), 1e-9);
    near(sim.state_of("bob").vx, vx, 1e-9);
    assert_eq!([sim.value_of("hinge.force.x"), sim.value_of("hinge.force.y")], [0.0; 2]);
    let gone = (sim.state_of("bob").x - release.sin()) / vx;
    sim.step(1.0).unwrap();
    let since = gone + 1.0;
    near(sim.state_of("bob").x, release.sin() + vx * since, 1e-8);
    near(sim.state_of("bob").y, -release.cos() + vy * since - 0.5 * g * since * since, 1e-8);
    near(sim.state_of("bob").angle, release + speed(release) * since, 1e-8);
}

#[test]
fn a_pendulum_is_let_go() {
    thrown(Released::new());
    thrown(ReleasedInAbsolute::new());
}

/// A damper acts as long as its joint holds.
#[test]
fn what_a_joint_has_beside_its_rows_goes_with_it() {
    let mut sim = Released::new().with("damping", 0.3).start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(2.0).unwrap();
    let omega = sim.state_of("bob").omega;
    assert!(sim.value_of("holds") < 0.5);
    sim.step(1.0).unwrap();
    near(sim.state_of("bob").omega, omega, 1e-15);
}

/// They meet at 1/3 s, and go on with the momentum of both.
#[test]
fn two_discs_are_locked_and_unlocked() {
    let mut sim = Dog::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(1.0 / 3.0 + 1e-9).unwrap();
    let together = (0.2 * 4.0 + 0.6) / 0.8;
    near(sim.state_of("first").omega, together, 1e-12);
    near(sim.state_of("second").omega, together, 1e-12);
    sim.step_to(2.5).unwrap();
    near(sim.state_of("first").angle, sim.state_of("second").angle, 1e-14);
    near(sim.state_of("first").angle, 1.0 / 3.0 + together * (2.5 - 1.0 / 3.0), 1e-9);
    sim.step_to(4.0).unwrap();
    near(sim.state_of("first").omega, together, 1e-12);
    near(sim.state_of("second").omega, 0.0, 0.0);
}
