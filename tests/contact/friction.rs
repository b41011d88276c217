//! Friction that sticks and slips.

use plm::{Dop853, Mechanism as _};

use crate::declared::Oscillator;
use crate::near;
use crate::scene::{Given as _, Named as _};

scene! {
    pub Block {
        part hand(on: body) {
            param force: N;
            force on on: (force, 0 N);
        }
        gravity: 9.81 m/s^2;
        param push: N = 29 N;
        body block { mass: 10 kg; inertia: 1 kg*m^2; }
        constraint level: block.angle = 0;
        hand hand(block) { force: push; }
        unilateral floor: block.y >= 0 m;
        friction slip: rate(block.x) within 0.3*reaction(floor);
        output push_of_floor = reaction(floor);
        output drag = reaction(slip);
    }
}

/// 29 N of 29.43 N: nothing moves, in few steps. 30 N: it accelerates.
#[test]
fn a_block_near_its_bound_stays_for_an_hour() {
    let mut sim = Block::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(3600.0).unwrap();
    assert_eq!((sim.state_of("block").x, sim.state_of("block").vx), (0.0, 0.0));
    assert!(sim.stats().steps < 20, "{:?}", sim.stats());
    near(sim.value_of("push_of_floor"), 98.1, 1e-12);
    near(sim.value_of("drag"), -29.0, 1e-12);

    let mut sim = Block::new().with("push", 30.0).start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(2.0).unwrap();
    near(sim.state_of("block").x, 0.5 * (30.0 - 29.43) / 10.0 * 4.0, 1e-12);
}

/// J. P. Den Hartog: amplitudes fall by 2 mu N / k, until the mass rests within mu N / k.
#[test]
fn a_coulomb_oscillator_comes_to_rest() {
    let mut sim = Oscillator::new().start_with(Dop853::new(1e-12)).unwrap();
    let half = core::f64::consts::PI / 10.0;
    for (k, turn) in [0.1, -0.08038, 0.06076, -0.04114, 0.02152, -0.0019].into_iter().enumerate() {
        sim.step_to(half * k as f64).unwrap();
        near(sim.state_of("mass").x, turn, 1e-10);
    }
    sim.step_to(1.6).unwrap();
    let (place, steps) = (sim.state_of("mass").x, sim.stats().steps);
    sim.step(3600.0).unwrap();
    assert_eq!((sim.state_of("mass").x, sim.state_of("mass").vx), (place, 0.0));
    assert!(sim.stats().steps - steps < 20);
    near(sim.value_of("drag"), 100.0 * place, 1e-12);
}

/// Static above kinetic friction: it sticks to the belt, breaks away, and is caught.
#[test]
fn a_mass_on_a_belt_sticks_and_slips() {
    let belt = Oscillator::new()
        .with("kinetic", 0.25 * 9.81)
        .with("adhesion", 0.4 * 9.81)
        .with("belt", 0.1)
        .with_start("mass.x", 0.0)
        .with_start("mass.vx", 0.1);
    let mut sim = belt.start_with(Dop853::new(1e-12)).unwrap();
    let (first, slips, period) = (0.3924, 0.433_536_962_770_418_6, 0.727_836_962_770_418_5);
    for k in 0..10 {
        let begun = first + f64::from(k) * period;
        sim.step_to(begun).unwrap();
        near(sim.state_of("mass").x, 0.03924, 1e-9);
        sim.step_to(begun + slips).unwrap();
        near(sim.state_of("mass").x, 0.00981, 1e-9);
        sim.step_to(begun + slips + 0.1).unwrap();
        near(sim.state_of("mass").x, 0.01981, 1e-9);
    }
    assert_eq!(sim.contact_stats().ambiguous, 0);
}

scene! {
    pub Disc {
        gravity: 9.81 m/s^2;
        body disc { mass: 2 kg; inertia: 1 kg*m^2; start y: 1 m; start vx: 5 m/s; }
        unilateral floor: disc.y >= 1 m;
        friction slip: rate(disc.x + (1 m)*disc.angle) within 0.2*reaction(floor);
        discrete backs: 1 = 0;
        discrete lifts: 1 = 0;
        when rate(disc.x + (1 m)*disc.angle) < 0 m/s { backs = backs + 1; }
        when disc.y > 1 m { lifts = lifts + 1; }
        output backs, lifts;
    }
}

/// v_0 becomes v_0/(1 + c) at v_0 c/(mu g (1 + c)), c = I/(m r^2); then it rolls.
#[test]
fn a_disc_that_was_thrown_begins_to_roll() {
    let mut sim = Disc::new().start_with(Dop853::new(1e-12)).unwrap();
    let (time, way, speed) = (0.849_473_326_537_546_7, 3.539_471_920_906_444_6, 10.0 / 3.0);
    sim.step_to(time).unwrap();
    near(sim.state_of("disc").x, way, 1e-5);
    sim.step_to(time + 2.0).unwrap();
    near(sim.state_of("disc").vx, speed, 1e-12);
    // While it rolls its slip is rounding of either sign, and so is the gap: neither is an event.
    assert_eq!((sim.value_of("backs"), sim.value_of("lifts"), sim.stats().switches), (0.0, 0.0, 1));
    near(sim.state_of("disc").x, 3.539_471_935_1 + 2.0 * speed, 1e-6);
    near(sim.state_of("disc").omega, -speed, 1e-12);
}

scene! {
    pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port pivot: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 1e-14 kg*m^2; port pivot: (0, 1) m; start angle: 60 deg, locked; }
        revolute hinge(ground.pivot, bob.pivot);
        friction drag: rate(bob.angle) within 0.2 N*m;
    }
}

/// m g l (cos theta' - cos theta) = T (theta - theta') from turn to turn.
#[test]
fn a_pendulum_with_a_rough_hinge_loses_its_work() {
    let mut sim = Pendulum::new().start_with(Dop853::new(1e-12)).unwrap();
    let turns = [-0.998_334_532_278_349_8, 0.950_310_223_978_209_7, -0.903_052_596_006_498_4];
    let mut found = Vec::new();
    let mut before = -1.0;
    while found.len() < 3 {
        sim.step(1e-3).unwrap();
        if (sim.state_of("bob").omega > 0.0) != (before > 0.0) {
            found.push(sim.state_of("bob").angle);
        }
        before = sim.state_of("bob").omega;
    }
    for (found, turn) in found.iter().zip(turns) {
        near(*found, turn, 1e-5);
    }
}

scene! {
    pub Clutch {
        part motor(on: body) {
            param torque: N*m;
            torque on on: torque;
        }
        param engine: N*m = 30 N*m;
        body first { mass: 1 kg; inertia: 0.2 kg*m^2; start omega: 200 rad/s; }
        body second { mass: 1 kg; inertia: 0.5 kg*m^2; start omega: 20 rad/s; }
        motor engine_(first) { torque: engine; }
        friction plates: rate(first.angle - second.angle) within 50 N*m;
        output torque = reaction(plates);
    }
}

/// With 30 N m of the engine the plates lock at 0.9 s and 110 rad/s, and carry 21.43 N m.
#[test]
fn a_clutch_locks() {
    let mut sim = Clutch::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.9).unwrap();
    near(sim.state_of("first").omega, 110.0, 1e-9);
    sim.step_to(1.0).unwrap();
    near(sim.state_of("first").omega, sim.state_of("second").omega, 1e-12);
    near(sim.value_of("torque"), -21.428_571_428_571_43, 1e-10);
}

scene! {
    pub Clamped {
        input clamp: N = 5 N;
        body block { mass: 1 kg; inertia: 1 kg*m^2; start vx: 1 m/s; }
        constraint level: block.angle = 0;
        constraint height: block.y = 0;
        friction pads: rate(block.x) within clamp;
    }
}

/// An input that makes a bound negative is a fault as soon as it is set, not a friction that drives.
#[test]
fn a_negative_bound_is_told() {
    let mut sim = Clamped::new().start().unwrap();
    sim.step_to(0.1).unwrap();
    near(sim.state_of("block").vx, 0.5, 1e-12);
    sim.set_input("clamp", -5.0);
    let fault = sim.step(0.1).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "t = 0.1 s: pads: the bound of friction must be finite and not negative, found -5 N or N m"
    );
}
