//! Laws that no model may break: energy, reactions, what a lock-step integrator keeps.

use plm::{Dop853, Mechanism as _, Rk4, SemiImplicitEuler};

use crate::scene::{Named as _, Scene};
use crate::scenes::{s1, s2, s5, s6};

scene! {
    /// A cart with a pendulum: spring, damper, drive.
    pub Cart {
        gravity: 9.81 m/s^2;
        input push: N = 20 N;
        ground { port rail: (0, 0) m, axis: 10 deg; }
        body cart {
            mass: 2 kg;
            inertia: 0.1 kg*m^2;
            port slide: (0.1, 0) m;
            port pin: (0, 0.05) m;
            start angle: 10 deg;
        }
        body bob {
            mass: 1 kg;
            inertia: 0.02 kg*m^2;
            centre: (0.05, -0.4) m;
            port pin: (0, 0) m;
            start angle: 40 deg, locked;
            start omega: 2 rad/s, locked;
        }
        prismatic rail(ground.rail, cart.slide) { stiffness: 50 N/m; damping: 3 N*s/m; drive: push*sin(3*t*1 rad/s); }
        revolute pin(cart.pin, bob.pin) { stiffness: 2 N*m/rad; damping: 0.1 N*m*s/rad; rest: 0.3 rad; }
        output rail.force, pin.force;
    }
}

#[test]
fn energy_of_loops_without_loss_is_kept() {
    let mut sim = s2::FourBar::new().start_with(Dop853::new(1e-12)).unwrap();
    let before = sim.kinetic_energy() + sim.gravity_energy();
    sim.step(5.0).unwrap();
    let after = sim.kinetic_energy() + sim.gravity_energy();
    assert!((after - before).abs() < 1e-11 * before.abs(), "{:e}", after - before);
}

#[test]
fn energy_grows_by_the_work_of_the_loads() {
    // Simpson's rule over the power at the ends and in the middle of short intervals: error of order dt^4.
    let mut sim = Cart::new().start_with(Dop853::new(1e-11)).unwrap();
    let energy = |sim: &plm::Sim<Scene>| sim.kinetic_energy() + sim.gravity_energy();
    let before = energy(&sim);
    let mut work: f64 = 0.0;
    let dt = 1e-3;
    for _ in 0..1000 {
        let start = sim.load_power();
        sim.step(0.5 * dt).unwrap();
        let middle = sim.load_power();
        sim.step(0.5 * dt).unwrap();
        work += dt / 6.0 * (start + 4.0 * middle + sim.load_power());
    }
    let gained = energy(&sim) - before;
    assert!((gained - work).abs() < 1e-9 * work.abs().max(1.0), "{gained} {work}");
}

#[test]
fn reactions_carry_the_weight_and_the_acceleration() {
    // Newton's law for the whole double pendulum: the shoulder's force is the only one besides the weights.
    let mut sim = s1::DoublePendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    let momentum = |sim: &plm::Sim<Scene>| {
        let (a, b) = (sim.state_of("arm"), sim.state_of("forearm"));
        [10.0 * (a.vx + b.vx), 10.0 * (a.vy + b.vy)]
    };
    sim.step(0.3).unwrap();
    let before = momentum(&sim);
    let h = 1e-4;
    sim.step(h).unwrap();
    let force = sim.vector_of("shoulder.force");
    sim.step(h).unwrap();
    let after = momentum(&sim);
    let change = [(after[0] - before[0]) / (2.0 * h), (after[1] - before[1]) / (2.0 * h)];
    // `force` acts on the ground; the pendulum feels its opposite.
    assert!((change[0] + force[0]).abs() < 1e-3, "{change:?} {force:?}");
    assert!((change[1] + force[1] + 2.0 * 98.1).abs() < 1e-3, "{change:?} {force:?}");
}

#[test]
fn andrews_reactions_at_the_start_are_those_of_the_reference() {
    let sim = s5::Andrews::new().start().unwrap();
    // Forces in N on the crank at its bearing and at its pin, and on the rocker at its bearing; `force` is the force on
    // the first frame's body: the ground (hence the sign), the crank, the ground.
    let reference = [
        (sim.vector_of("r1.force"), [-98.614_979_623_379_07, 5.344_125_604_523_82]),
        (sim.vector_of("r2.force"), [-98.580_077_216_235_44, 5.908_959_324_494_304]),
        (sim.vector_of("r4.force"), [45.575_772_417_914_61, -107.119_019_522_453_23]),
    ];
    for (force, expected) in reference {
        for (found, expected) in force.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-8, "{force:?} {expected:?}");
        }
    }
}

#[test]
fn fixed_steps_converge_with_their_order() {
    let end = |h: f64| {
        let mut sim = s6::SliderCrank::new().start_with(Rk4::new(h).with_tolerance(1e-15)).unwrap();
        sim.step(0.25).unwrap();
        sim.state_of("crank").angle
    };
    let fine = end(1e-4);
    let ratio = (end(4e-3) - fine) / (end(2e-3) - fine);
    assert!((12.0..20.0).contains(&ratio), "{ratio}");
    let euler = |h: f64| {
        let mut sim = s6::SliderCrank::new().start_with(SemiImplicitEuler::new(h)).unwrap();
        sim.step(0.25).unwrap();
        sim.state_of("crank").angle
    };
    let ratio = (euler(2e-4) - fine) / (euler(1e-4) - fine);
    assert!((1.8..2.2).contains(&ratio), "{ratio}");
}
