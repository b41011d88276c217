//! Air: choked flow, chambers, cylinders.

use std::f64::consts::PI;

use plm::{Mechanism as _, Moment as _};

use crate::declared::Air;
use crate::scene::Named as _;

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within * known.abs().max(found.abs()), "{found} is not {known}");
}

const R: f64 = 287.05;
const T: f64 = 293.15;
const RHO: f64 = 1.185;

/// ISO 6358 with C = 1 L/(s bar) of an opening of one half, b = 0.3.
fn flow(p1: f64, p2: f64) -> f64 {
    let (high, low) = (p1.max(p2), p1.min(p2));
    let r = low / high;
    let choked = 1e-8 * RHO * high * (293.15_f64 / 340.0).sqrt();
    let at = |r: f64| (1.0 - ((r - 0.3) / 0.7).powi(2)).sqrt();
    let share = match r {
        r if r <= 0.3 => 1.0,
        r if r <= 0.999 => at(r),
        r => at(0.999) * (1.0 - r) / 0.001,
    };
    choked * share * if p1 < p2 { -1.0 } else { 1.0 }
}

#[test]
fn the_flow_is_choked_below_the_critical_ratio() {
    let mut sim = Air::new().start().unwrap();
    for p1 in [1e5, 3e5, 9e5_f64] {
        for ratio in [0.0, 0.1, 0.29, 0.31, 0.6, 0.95, 0.9985, 0.9992, 1.0] {
            for (left, right) in [(p1, p1 * ratio), (p1 * ratio, p1)] {
                sim.set_input("left", left);
                sim.set_input("right", right);
                sim.step(1e-6).unwrap();
                let known = flow(left, right);
                assert!(
                    (sim.value_of("nozzle.mass_flow") - known).abs() < 1e-12 * flow(p1, 0.0),
                    "{left} {right}"
                );
                near(sim.value_of("nozzle.normal_flow"), known / RHO, 1e-9);
                near(sim.value_of("nozzle.ratio"), ratio, 1e-15);
            }
        }
    }
}

/// dp/dt = -R T C rho0 p/V while it is choked: an exponential. Whatever left is missing in the vessel, p V = m R T.
#[test]
fn a_vessel_empties_exponentially_while_it_is_choked() {
    let mut sim = Air::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    let rate = R * T * 1e-8 * RHO / 1e-4;
    for k in 1..=24 {
        sim.step_to(0.01 * f64::from(k)).unwrap();
        let known = 8e5 * f64::exp(-rate * sim.time());
        if 101_325.0 / known < 0.4 {
            near(sim.value_of("vessel.pressure"), known, 1e-9);
        } else {
            assert!(sim.value_of("vessel.pressure") > known);
        }
        near(sim.value_of("left_over"), (sim.value_of("vessel.pressure") - 8e5) * 1e-4 / (R * T), 1e-8);
    }
    assert!(sim.value_of("vessel.pressure") < 2.5e5);
}

#[test]
fn air_that_stays_is_compressed_adiabatically() {
    let mut sim = Air::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    let area = PI / 4.0 * 0.05 * 0.05;
    let volume = |t: f64| 20e-6 + area * (0.4 - 0.2 * t);
    for k in 1..=7 {
        sim.step_to(0.03 * f64::from(k)).unwrap();
        near(sim.value_of("cap.volume"), volume(sim.time()), 1e-12);
        let pressure = 2e5 * (volume(0.0) / volume(sim.time())).powf(1.4);
        near(sim.value_of("cap.pressure"), pressure, 1e-9);
        near(sim.value_of("ram.force"), area * (pressure - 101_325.0), 1e-8);
    }
}

#[test]
fn a_pneumatic_cylinder_lifts_its_load_to_the_stop() {
    let mut sim = Air::new().start().unwrap();
    let (cap, ring) = (PI / 4.0 * 0.04 * 0.04, PI / 4.0 * (0.04 * 0.04 - 0.016 * 0.016));
    for k in 1..=8 {
        sim.step_to(0.08 * f64::from(k)).unwrap();
        let (v, x) = (sim.value_of("load.speed"), sim.value_of("lift.displacement"));
        let pressures = cap * (sim.value_of("lift.pressure1") - 101_325.0)
            - ring * (sim.value_of("lift.pressure2") - 101_325.0);
        let rub = 100.0 * v + 15.0 * v / f64::hypot(v, 1e-3);
        assert!(
            (sim.value_of("lift.force") - (pressures - rub + sim.value_of("lift.stop_force"))).abs() < 1e-9
        );
        near(sim.value_of("lift.volume1"), 50e-6 + cap * x, 1e-12);
        near(sim.value_of("lift.volume2"), 50e-6 + ring * (0.2 - x), 1e-12);
    }
    assert!(
        (0.199..0.201).contains(&sim.value_of("lift.displacement")),
        "{}",
        sim.value_of("lift.displacement")
    );
}
