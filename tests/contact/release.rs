//! Constraints and joints that hold while a condition does.

use plm::{Dop853, mechanism};

use crate::near;

macro_rules! pendulum {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            /// A pendulum that is let go on its way up, with a damper in its hinge.
            pub $name {
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                param damping: N*m*s = 0;
                discrete holds: 1 = 1;
                ground { port pivot: (0, 0) m; }
                body bob {
                    mass: 2 kg; inertia: 0.5 kg*m^2; port pivot: (0, 1) m;
                    start angle: -60 deg;
                    start x: -0.8660 m; start y: -0.5000 m;
                }
                revolute hinge(ground.pivot, bob.pivot) { damping: damping; when: holds > 0.5; }
                when bob.angle > 30 deg { holds = 0; }
                output holds, hinge.force, hinge.torque;
            }
        }
    };
}

pendulum!(Released, tree);
pendulum!(ReleasedInAbsolute, absolute);

/// Energy to the moment of release, then a throw that keeps the angular velocity; the reaction is that of a pendulum.
macro_rules! thrown {
    ($mechanism:expr) => {{
        let mut sim = $mechanism.start_with(Dop853::new(1e-12)).unwrap();
        let g = 9.81_f64;
        let (start, inertia) = (sim.bob().angle, 2.5_f64);
        near(start, -60_f64.to_radians(), 1e-4);
        let speed = |angle: f64| (2.0 * 2.0 * g * (angle.cos() - start.cos()) / inertia).sqrt();
        while sim.bob().angle < 0.0 {
            sim.step(1e-3).unwrap();
        }
        let (angle, omega) = (sim.bob().angle, sim.bob().omega);
        near(omega, speed(angle), 1e-9);
        near(sim.bob().x, angle.sin(), 1e-14);
        near(sim.bob().y, -angle.cos(), 1e-14);
        // What the joint does to the ground: the weight and the centrifugal force of the bob.
        let alpha = -2.0 * g * angle.sin() / inertia;
        let down = 2.0 * (g + alpha * angle.sin() + omega * omega * angle.cos());
        near(sim.hinge_force()[1], -down, 1e-9);
        let mut before = sim.time();
        while sim.holds() > 0.5 {
            before = sim.time();
            sim.step(1e-3).unwrap();
        }
        assert!(sim.time() - before < 2e-3);
        let release = 30_f64.to_radians();
        let (vx, vy) = (speed(release) * release.cos(), speed(release) * release.sin());
        near(sim.bob().omega, speed(release), 1e-9);
        near(sim.bob().vx, vx, 1e-9);
        assert_eq!(sim.hinge_force(), [0.0; 2]);
        let gone = (sim.bob().x - release.sin()) / vx;
        sim.step(1.0).unwrap();
        let since = gone + 1.0;
        near(sim.bob().x, release.sin() + vx * since, 1e-8);
        near(sim.bob().y, -release.cos() + vy * since - 0.5 * g * since * since, 1e-8);
        near(sim.bob().angle, release + speed(release) * since, 1e-8);
    }};
}

#[test]
fn a_pendulum_is_let_go() {
    thrown!(Released::new());
    thrown!(ReleasedInAbsolute::new());
}

/// A damper acts as long as its joint holds.
#[test]
fn what_a_joint_has_beside_its_rows_goes_with_it() {
    let mut sim = Released { damping: 0.3, ..Released::new() }.start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(2.0).unwrap();
    let omega = sim.bob().omega;
    assert!(sim.holds() < 0.5);
    sim.step(1.0).unwrap();
    near(sim.bob().omega, omega, 1e-15);
}

mechanism! {
    /// A dog that locks two discs where they meet.
    pub Dog {
        allow(W0002);
        discrete locked: 1 = 0;
        body first { mass: 1 kg; inertia: 0.2 kg*m^2; start omega: 4 rad/s; start angle: -1 rad; }
        body second { mass: 1 kg; inertia: 0.6 kg*m^2; start omega: 1 rad/s; }
        constraint lock: first.angle = second.angle { when: locked > 0.5; }
        when first.angle > second.angle { locked = 1; }
        when t > 2 s { locked = 0; }
        when t > 3 s { second.omega = 0 rad/s; }
        output moment = reaction(lock), locked;
    }
}

/// They meet at 1/3 s, and go on with the momentum of both.
#[test]
fn two_discs_are_locked_and_unlocked() {
    let mut sim = Dog::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(1.0 / 3.0 + 1e-9).unwrap();
    let together = (0.2 * 4.0 + 0.6) / 0.8;
    near(sim.first().omega, together, 1e-12);
    near(sim.second().omega, together, 1e-12);
    sim.step_to(2.5).unwrap();
    near(sim.first().angle, sim.second().angle, 1e-14);
    near(sim.first().angle, 1.0 / 3.0 + together * (2.5 - 1.0 / 3.0), 1e-9);
    sim.step_to(4.0).unwrap();
    near(sim.first().omega, together, 1e-12);
    near(sim.second().omega, 0.0, 0.0);
}
