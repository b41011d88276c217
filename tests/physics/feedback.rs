//! Forces that read accelerations and reactions: exact, where they are affine in them.

use plm::{Dop853, Mechanism as _};

use crate::scene::{Named as _, Scene};

/// A pendulum with `$more` and a moment of inertia.
macro_rules! pendulum {
    ($module:ident, $inertia:literal, { $($more:tt)* }) => {
        mod $module {
            scene! {
                pub Pendulum {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    body bob {
                        mass: 2 kg;
                        inertia: $inertia kg*m^2;
                        port pivot: (0.1, 0.7) m;
                        start angle: 50 deg, locked;
                    }
                    revolute hinge(ground.o, bob.pivot) { $($more)* }
                    state turned: rad/s = 0;
                    rate turned = bob.alpha;
                    output bob.alpha, hinge.force, turned;
                }
            }
        }
    };
}

pendulum!(heavier, 0.35, {});
pendulum!(fed_back, 0.05, { drive: -0.3 N*m*s^2*bob.alpha; });

/// A torque in proportion to the angular acceleration is a moment of inertia.
#[test]
fn a_torque_from_the_acceleration_is_inertia() {
    let mut plain = heavier::Pendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    let mut fed = fed_back::Pendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    for _ in 0..20 {
        plain.step(0.1).unwrap();
        fed.step(0.1).unwrap();
        assert!((plain.state_of("bob").angle - fed.state_of("bob").angle).abs() < 1e-10);
        assert!((plain.value_of("bob.alpha") - fed.value_of("bob.alpha")).abs() < 1e-9);
        for (plain, fed) in plain.vector_of("hinge.force").iter().zip(fed.vector_of("hinge.force")) {
            assert!((plain - fed).abs() < 1e-8);
        }
        // The state whose rate is the acceleration is the speed.
        assert!((fed.state_of("bob").omega - fed.value_of("turned")).abs() < 1e-10);
    }
}

/// A four-bar whose coupler feels a torque and whose follower a force, both from sensors when `$gain` is given.
macro_rules! four_bar {
    ($module:ident, { $($torque:tt)* }, { $($push:tt)* }, { $($inputs:tt)* }) => {
        mod $module {
            scene! {
                pub FourBar {
                    gravity: 9.81 m/s^2;
                    $($inputs)*
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
                    body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0.1) m; start angle: 20 deg; }
                    body follower { mass: 1.5 kg; inertia: 0.05 kg*m^2; port d: (-0.3, 0) m; port c: (0.3, 0) m; start angle: 80 deg; start x: 1 m; }
                    revolute oa(ground.a, crank.a);
                    revolute ab(crank.b, coupler.b);
                    revolute bc(coupler.c, follower.c);
                    revolute od(ground.d, follower.d);
                    force twist(coupler.b) { torque: $($torque)*; }
                    force push(follower.c) { x: $($push)*; }
                    output crank.alpha, coupler.ay, ab.force, od.force;
                }
            }
        }
    };
}

four_bar!(sensed, { 0.1 m*ab.force.x }, { -0.4 kg*coupler.ay + 0.2*od.force.y }, {});
four_bar!(given, { twisting }, { pushing }, { input twisting: N*m = 0; input pushing: N = 0; });

/// The same by an iteration from outside, of a mechanism without feedback in another formulation.
#[test]
fn sensors_in_a_loop_agree_with_an_iteration_from_outside() {
    let sensed = sensed::FourBar::new().start().unwrap();
    let mut given = given::FourBar::new().start().unwrap();
    for _ in 0..200 {
        let (twisting, pushing) = (
            0.1 * given.vector_of("ab.force")[0],
            -0.4 * given.value_of("coupler.ay") + 0.2 * given.vector_of("od.force")[1],
        );
        given.set_input("twisting", twisting);
        given.set_input("pushing", pushing);
    }
    let pairs = [
        (sensed.value_of("crank.alpha"), given.value_of("crank.alpha")),
        (sensed.value_of("coupler.ay"), given.value_of("coupler.ay")),
        (sensed.vector_of("ab.force")[0], given.vector_of("ab.force")[0]),
        (sensed.vector_of("od.force")[1], given.vector_of("od.force")[1]),
        (sensed.load_power(), given.load_power()),
    ];
    for (sensed, given) in pairs {
        assert!((sensed - given).abs() < 1e-10 * given.abs().max(1.0), "{sensed} {given}");
    }
}

/// What the sensors feed back does work, and the energy changes by it.
#[test]
fn energy_changes_by_the_work_of_the_feedback() {
    let mut sim = sensed::FourBar::new().start_with(Dop853::new(1e-11)).unwrap();
    let energy = |sim: &plm::Sim<Scene>| sim.kinetic_energy() + sim.gravity_energy();
    let (before, mut work, dt) = (energy(&sim), 0.0, 2e-3);
    for _ in 0..250 {
        let start = sim.load_power();
        sim.step(0.5 * dt).unwrap();
        let middle = sim.load_power();
        sim.step(0.5 * dt).unwrap();
        work += dt / 6.0 * (start + 4.0 * middle + sim.load_power());
    }
    let gained = energy(&sim) - before;
    assert!(work.abs() > 0.1, "{work}");
    assert!((gained - work).abs() < 1e-8, "{gained} {work}");
}

scene! {
    /// The pendulum above with sensors in place of expressions.
    pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob {
            mass: 2 kg;
            inertia: 0.05 kg*m^2;
            port pivot: (0.1, 0.7) m;
            start angle: 50 deg, locked;
        }
        acceleration_sensor spin(bob.pivot) { direction: rotary; gain: -0.3; }
        force_sensor load() { x: hinge.force.x; y: hinge.force.y; direction: y; gain: 0.5; offset: 4; }
        revolute hinge(ground.o, bob.pivot) { drive: 1 N*m*spin.signal; }
        output hinge.force, load.signal;
    }
}

/// A sensor in the loop is the expression that it stands for.
#[test]
fn a_sensor_feeds_back_exactly() {
    let mut plain = heavier::Pendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    let mut sensed = Pendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    for _ in 0..20 {
        plain.step(0.1).unwrap();
        sensed.step(0.1).unwrap();
        assert!((plain.state_of("bob").angle - sensed.state_of("bob").angle).abs() < 1e-10);
        assert!(
            (0.5 * (plain.vector_of("hinge.force")[1] - 4.0) - sensed.value_of("load.signal")).abs() < 1e-8
        );
    }
}
