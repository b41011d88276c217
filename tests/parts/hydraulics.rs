//! Pumps, valves, accumulators and motors.

use std::f64::consts::{PI, TAU};

use plm::{Mechanism as _, Moment as _};

use crate::declared::{Circuit, Valves};
use crate::scene::Named as _;

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    let size = known.abs().max(found.abs());
    assert!((found - known).abs() <= within * size, "{found} is not {known}");
}

/// The law of turbulent flow that the orifice states: u/(u^2 + e^2)^(1/4), drops over the rated one.
fn orifice(rated_flow: f64, rated_drop: f64, drop: f64) -> f64 {
    let (u, e) = (drop / rated_drop, 5e3 / rated_drop);
    rated_flow * u / (u * u + e * e).sqrt().sqrt()
}

const LITRE_A_MINUTE: f64 = 1e-3 / 60.0;

#[test]
fn pump_and_relief_valve_balance() {
    let mut sim = Circuit::new().start().unwrap();
    sim.step(0.1).unwrap();
    // What the pump delivers goes through the valve.
    let delivered = |p: f64| 0.9 * 16e-6 * 25.0 - LITRE_A_MINUTE / 100e5 * p;
    let through = |p: f64| ((p - 150e5) / 10e5).clamp(0.0, 1.0) * orifice(20.0 * LITRE_A_MINUTE, 10e5, p);
    let (mut low, mut high) = (150e5, 160e5);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        *(if through(middle) < delivered(middle) { &mut low } else { &mut high }) = middle;
    }
    near(sim.value_of("line.pressure"), low, 1e-7);
    near(sim.value_of("feed.flow"), delivered(low), 1e-7);
    near(sim.value_of("relief.flow"), delivered(low), 1e-6);
    near(sim.value_of("relief.opening"), (low - 150e5) / 10e5, 1e-5);
    near(
        sim.value_of("feed.power"),
        sim.value_of("feed.flow") * sim.value_of("line.pressure") + sim.value_of("feed.lost"),
        1e-12,
    );
    let (leakage, speed) = (LITRE_A_MINUTE / 100e5, 25.0 * TAU);
    near(sim.value_of("feed.lost"), leakage * low * low + 0.02 * speed * speed, 1e-6);
}

#[test]
fn a_motor_turns_its_drum_and_all_power_is_found() {
    let mut sim = Circuit::new().start_with(plm::Dop853::new(1e-10)).unwrap();
    let displacement = 10e-6 / TAU;
    let settled = displacement * 100e5 / 0.4;
    for k in 1..=4 {
        let t = 0.05 * f64::from(k);
        sim.step_to(t).unwrap();
        let speed = settled * (1.0 - (-0.4 * t / 0.05_f64).exp());
        near(sim.state_of("drum").omega, speed, 1e-9);
        near(sim.value_of("motor.torque"), displacement * 100e5 - 0.1 * speed, 1e-9);
        near(
            sim.value_of("motor.flow") * 100e5,
            sim.value_of("motor.power") + sim.value_of("motor.lost"),
            1e-12,
        );
        near(sim.value_of("motor.power"), sim.value_of("motor.torque") * speed, 1e-9);
    }
}

/// A constant flow first fills the dead volume up to the charge, then compresses gas by p V^n = const.
#[test]
fn an_accumulator_follows_the_polytropic_law() {
    let mut sim = Circuit::new().start_with(plm::Dop853::new(1e-11)).unwrap();
    let (flow, charge, absolute) = (60.0 * LITRE_A_MINUTE, 50e5, 101_325.0);
    let stored = |p: f64| {
        let gas = ((charge + absolute) / (p.max(charge) + absolute)).powf(1.0 / 1.3) * 1e-3;
        (200e-6 * p / 1.7e9 + 1e-3 - gas, gas)
    };
    for k in 1..=8 {
        sim.step_to(0.05 * f64::from(k)).unwrap();
        let (volume, gas) = stored(sim.value_of("store.pressure"));
        near(volume, flow * sim.time(), 1e-9);
        near(sim.value_of("store.gas_volume"), gas, 1e-12);
        near(sim.value_of("store.oil_volume"), 1e-3 - gas, 1e-9);
    }
    assert!(sim.value_of("store.pressure") > 90e5);
}

#[test]
fn a_check_valve_opens_once_a_pulse_and_keeps_what_it_let_in() {
    let mut sim = Circuit::new().start().unwrap();
    sim.step_to(0.1).unwrap();
    assert_eq!([sim.value_of("openings"), sim.value_of("closings")], [1.0, 0.0]);
    sim.step_to(0.18).unwrap();
    assert_eq!([sim.value_of("openings"), sim.value_of("closings")], [1.0, 1.0]);
    let kept = sim.value_of("vessel.pressure");
    // Next to the highest pressure less the cracking pressure.
    assert!((18.9e5..19e5).contains(&kept), "{kept}");
    sim.step_to(0.26).unwrap();
    assert_eq!([sim.value_of("check.flow"), sim.value_of("vessel.pressure")], [0.0, kept]);
    // The second pulse finds it at the pressure of the first.
    sim.step_to(0.4).unwrap();
    assert!(sim.value_of("openings") <= 2.0 && (kept..19e5).contains(&sim.value_of("vessel.pressure")));
}

#[test]
fn valves_follow_their_laws_at_every_pressure_drop() {
    let mut sim = Valves::new().start().unwrap();
    for drop in [-30e5, -1e5, 0.0, 0.5e5, 4e5, 8e5, 60e5, 180e5, 220e5] {
        sim.set_input("drop", drop);
        for command in [-10.0, -1.5, 0.0, 0.3, 2.0, 6.0, 10.0] {
            sim.set_input("command", command);
            // The spool settles within 20 of its periods.
            sim.step(0.2).unwrap();
            let share = if command == 0.0 { 0.0 } else { (command.abs() / 10.0 - 0.04_f64).max(0.0) / 0.96 };
            let [ahead, back] = [1.0, -1.0]
                .map(|sense: f64| ((sense * share * f64::signum(command) - 0.2) / 0.8).clamp(0.001, 1.0));
            let edge = |from: f64, to: f64| orifice(20.0 * LITRE_A_MINUTE, 1e5, from - to);
            let flow_a = ahead * edge(drop, 30e5) - back * edge(30e5, 0.0);
            let flow_b = back * edge(drop, 50e5) - ahead * edge(50e5, 0.0);
            assert!((sim.value_of("valve.flow_a") - flow_a).abs() < 1e-9, "{drop} {command}");
            assert!((sim.value_of("valve.flow_b") - flow_b).abs() < 1e-9, "{drop} {command}");
            near(sim.value_of("valve.opening"), ahead - back, 1e-6);
        }
        let setting = 5.0 * LITRE_A_MINUTE;
        if drop >= 8e5 {
            near(sim.value_of("hold.flow"), setting, 1e-14);
        } else {
            near(
                sim.value_of("hold.flow"),
                orifice(setting, 8e5, drop) * (1.0 + f64::powi(5e3 / 8e5, 2)).powf(0.25),
                1e-12,
            );
        }
        let opening = ((drop + 3.0 * 40e5 - 4.0 * 5e5 - 230e5) / 20e5).clamp(0.0, 1.0);
        let free = ((5e5 - drop) / 0.5e5).clamp(0.0, 1.0);
        near(sim.value_of("holder.opening"), opening, 1e-12);
        near(
            sim.value_of("holder.flow"),
            (opening + free) * orifice(20.0 * LITRE_A_MINUTE, 1e5, drop - 5e5),
            1e-12,
        );
    }
}

#[test]
fn seals_of_a_cylinder_rub_and_leak() {
    let mut sim = Valves::new().start().unwrap();
    sim.step(1e-3).unwrap();
    let (v, area) = (5e-3_f64, PI / 4.0 * 0.04 * 0.04);
    let seals = 60.0 + 40.0 * f64::exp(-0.25);
    let rub = seals * v / f64::hypot(v, 1e-3);
    let between = sim.value_of("press.pressure1") - sim.value_of("press.pressure2");
    near(sim.value_of("press.force"), area * between - 200.0 * v - rub, 1e-12);
    let leak = 0.1 * LITRE_A_MINUTE / 100e5 * between;
    near(sim.value_of("press.leak_flow"), leak, 1e-12);
    near(sim.value_of("press.lost"), 200.0 * v * v + rub * v + leak * between, 1e-12);
    let volume = 50e-6 + area * (0.1 + v * sim.time());
    near(sim.value_of("rate1"), -1.7e9 * (leak + area * v) / volume, 1e-9);
}
