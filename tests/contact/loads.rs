//! Events that joints cause by what they carry: pins that break, loads that are crossed.

use plm::{Dop853, Mechanism as _};

use crate::machines::slider_crank;
use crate::near;
use crate::scene::Named as _;

const G: f64 = 9.81;

macro_rules! pendulum {
    ($name:ident, $formulation:ident) => {
        scene! {
            /// A pendulum that is let go from the horizontal, and counts how often its pin carries more than 30 N.
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                discrete place: rad = 0;
                discrete moment: s = 0;
                discrete strikes: 1 = 0;
                ground { port o: (0, 0) m; }
                body rod {
                    mass: 2 kg; inertia: 0.06 kg*m^2; port o: (-0.3, 0) m;
                    start angle: 0 deg, locked; start omega: 0 rad/s, locked;
                }
                revolute pin(ground.o, rod.o);
                discrete tangential: rad = 0;
                when rod.alpha > -20 rad/s^2 { tangential = rod.angle; }
                when norm(pin.force) > 30 N { place = rod.angle; moment = t; strikes = strikes + 1; }
                output place, moment, strikes, tangential, carries = norm(pin.force);
                output warns = if norm(pin.force) > 29 N then 1 else 0;
            }
        }
    };
}

pendulum!(InJoints, tree);
pendulum!(InBodies, absolute);

/// With k = m l^2/(J + m l^2) and the angle a from the vertical the pin carries m g sqrt((1 + 2 k)^2 cos^2 a + (1 - k)^2 sin^2 a).
#[test]
fn a_pendulum_tells_when_its_pin_carries_so_much() {
    let k = 2.0 * 0.09 / (0.06 + 2.0 * 0.09);
    let [along, across] = [1.0 + 2.0 * k, 1.0 - k].map(|factor: f64| factor * factor);
    let cosine = ((30.0_f64 / (2.0 * G)).powi(2) - across) / (along - across);
    let crosses = cosine.sqrt().acos();
    for pendulum in [InJoints::new(), InBodies::new()] {
        let mut sim = pendulum.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.1).unwrap();
        near(sim.value_of("warns"), 0.0, 0.0);
        sim.step_to(0.45).unwrap();
        near(sim.value_of("strikes"), 1.0, 0.0);
        near(sim.value_of("place"), -(core::f64::consts::FRAC_PI_2 - crosses), 1e-10);
        // alpha = -(g/l) k cos(angle).
        near(sim.value_of("tangential"), -(20.0 / (G * k / 0.3)).acos(), 1e-10);
        // It carries as much a second time on its way back.
        let first = sim.value_of("moment");
        assert!(sim.value_of("carries") > 30.0 && sim.value_of("warns") == 1.0);
        sim.step_to(3.0).unwrap();
        assert!(sim.value_of("strikes") >= 3.0);
        let mut again = pendulum.start_with(Dop853::new(1e-12)).unwrap();
        again.step_to(first).unwrap();
        near(again.value_of("carries"), 30.0, 1e-9);
    }
}

slider_crank!(CrankInCharts, loops, 60,
    allow(W0007);
    discrete place: rad = 0;
    when norm(rail.force) > 120 N { place = crank.angle; }
    output place, carries = norm(rail.force););
slider_crank!(CrankInBodies, absolute, 60,
    allow(W0007);
    discrete place: rad = 0;
    when norm(rail.force) > 120 N { place = crank.angle; }
    output place, carries = norm(rail.force););

#[test]
fn a_slider_crank_tells_when_its_rail_carries_so_much() {
    let places = [CrankInCharts::new(), CrankInBodies::new()].map(|crank| {
        let mut sim = crank.start_with(Dop853::new(1e-12)).unwrap();
        let mut time = 0.0;
        while sim.value_of("place") == 0.0 && time < 0.2 {
            time += 1e-3;
            sim.step_to(time).unwrap();
        }
        sim.value_of("place")
    });
    assert!(places[0] > 0.0);
    near(places[0], places[1], 1e-10);
    let mut sim = CrankInBodies::new().start_with(Dop853::new(1e-12)).unwrap();
    let (mut low, mut high) = (0.0, 0.2);
    for _ in 0..60 {
        let half: f64 = 0.5 * (low + high);
        let mut copy = CrankInBodies::new().start_with(Dop853::new(1e-12)).unwrap();
        copy.step_to(half).unwrap();
        *(if copy.state_of("crank").angle < places[0] { &mut low } else { &mut high }) = half;
    }
    sim.step_to(low).unwrap();
    near(sim.value_of("carries"), 120.0, 1e-6);
}

scene! {
    /// Four bodies that hang: in a pin that breaks, on one that breaks while it swings, on one that gives way, and as a beam on a pin and a
    /// support.
    pub Hangers {
        part pull(on: body) {
            input force: N = 0 N;
            force on on: (0 N, -force);
        }
        allow(W0002);
        gravity: 9.81 m/s^2;
        discrete holds: 1 = 1;
        discrete slung: 1 = 1;
        discrete broken: s = 0;
        discrete soft: s = 0;
        discrete lifted: s = 0;
        discrete early: 1 = 0;
        ground { port a: (0, 0) m; port b: (5, 0) m; port c: (10, 0) m; port d: (20, 0) m; }
        body chest { mass: 10 kg; inertia: 1 kg*m^2; port eye: (0, 0) m; }
        body sling {
            mass: 2 kg; inertia: 0.06 kg*m^2; port o: (-0.3, 0) m;
            start x: 5.3 m; start angle: 0 deg, locked; start omega: 0 rad/s, locked;
        }
        body light { mass: 1 kg; inertia: 1 kg*m^2; port eye: (0, 0) m; start x: 10 m; }
        body beam {
            mass: 4 kg; inertia: 1 kg*m^2; port d: (-1, 0) m; port e: (1, 0) m;
            start x: 21 m; start angle: 0 deg, locked; start omega: 0 rad/s, locked;
        }
        revolute pin(ground.a, chest.eye) { when: holds > 0.5; }
        revolute ring(ground.b, sling.o) { when: slung > 0.5; }
        revolute rubber(ground.c, light.eye) { compliance: 0.01 m/N; }
        revolute hinge(ground.d, beam.d);
        unilateral support: beam.e.y >= 0 m;
        pull first(chest) { force: 100 N/s*t; }
        pull second(beam) { force: 100 N/s*t; }
        when norm(pin.force) > 500 N { holds = 0; broken = t; }
        when norm(ring.force) > 30 N { slung = 0; }
        when norm(rubber.force) > 1.5*(1 kg)*9.81 m/s^2 { soft = t; }
        when norm(hinge.force) > 100 N { lifted = t; }
        when norm(hinge.force) > 1 N { early = 1; }
        output broken, soft, lifted, early, carries = norm(pin.force), hinges = norm(hinge.force);
        output torn = if norm(pin.force) > 400 N then 1 else 0;
    }
}

/// A pin breaks at (S - m g)/c, and the chest falls with its weight and the pull. A sling lets go at its angle, and its G flies on a
/// parabola. A rubber is drawn by m g (1 - cos w t), which is 3/2 m g at 2 pi/(3 w). A hinge carries half of weight and pull.
#[test]
fn pins_break_by_what_they_carry() {
    let mut sim = Hangers::new().start_with(Dop853::new(1e-12)).unwrap();
    let breaks = (500.0 - 10.0 * G) / 100.0;
    let soft = 2.0 * core::f64::consts::PI / 3.0 * 0.1;
    let k = 2.0 * 0.09 / (0.06 + 2.0 * 0.09);
    let [along, across] = [1.0 + 2.0 * k, 1.0 - k].map(|factor: f64| factor * factor);
    let cosine = (((30.0_f64 / (2.0 * G)).powi(2) - across) / (along - across)).sqrt();
    let sine = (1.0 - cosine * cosine).sqrt();
    let omega = (2.0 * k * G * cosine / 0.3).sqrt();
    sim.step_to(0.5).unwrap();
    near(sim.value_of("soft"), soft, 1e-10);
    // The sling flies on.
    sim.step_to(1.0).unwrap();
    near(sim.state_of("sling").omega, -omega, 1e-9);
    let since = (sim.state_of("sling").x - 5.0 - 0.3 * sine) / (-0.3 * omega * cosine);
    let y = -0.3 * cosine - 0.3 * omega * sine * since - 0.5 * G * since * since;
    near(sim.state_of("sling").y, y, 1e-8);
    sim.step_to(3.0).unwrap();
    near(sim.value_of("carries"), 10.0 * G + 300.0, 1e-9);
    near(sim.value_of("torn"), 0.0, 0.0);
    near(sim.value_of("hinges"), 0.5 * (4.0 * G + 300.0), 1e-9);
    near(sim.value_of("lifted"), (200.0 - 4.0 * G) / 100.0, 1e-10);
    near(sim.state_of("chest").y, 0.0, 0.0);
    sim.step_to(5.0).unwrap();
    near(sim.value_of("broken"), breaks, 1e-10);
    let since = 5.0 - breaks;
    let fall = 0.5 * (G + 10.0 * breaks) * since * since + 10.0 * since.powi(3) / 6.0;
    near(sim.state_of("chest").y, -fall, 1e-8);
    near(sim.value_of("carries"), 0.0, 0.0);
    // The condition held where the run began.
    near(sim.value_of("early"), 0.0, 0.0);
}
