//! Clutches, torque limiters, freewheels and brakes: times, heat, self-energising shoes.

use plm::{Dop853, Mechanism as _, Sim};

use crate::declared::{Brakes, Clutches};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

fn started(brakes: &Scene) -> Sim<Scene> {
    brakes.start_with(Dop853::new(1e-10)).unwrap()
}

/// C = 2 0.3 1 kN 5 cm = 30 N m: the speeds meet after dw J1 J2/((J1 + J2) C), and the heat is J1 J2/(J1 + J2) dw^2/2.
#[test]
fn a_clutch_locks_in_time_and_with_its_heat() {
    let mut sim = started(&Clutches::new());
    let reduced = 0.2 * 0.3 / 0.5;
    let time = 80.0 * reduced / 30.0;
    sim.step_to(time - 1e-6).unwrap();
    near(sim.value_of("coupling.locked"), 0.0, 0.0);
    near(sim.value_of("coupling.torque"), 30.0, 1e-12);
    sim.step_to(time + 1e-6).unwrap();
    near(sim.value_of("coupling.locked"), 1.0, 0.0);
    near(sim.value_of("heat"), 0.5 * reduced * 80.0 * 80.0, 1e-6);
    sim.step_to(3.0).unwrap();
    near(sim.value_of("one.speed"), (0.2 * 100.0 + 0.3 * 20.0) / 0.5, 1e-9);
    near(sim.value_of("coupling.speed"), 0.0, 1e-12);
    near(sim.value_of("coupling.torque"), 0.0, 1e-9);
}

/// 2 N m on 0.4 kg m^2 for 1 s, then -2 N m on 0.1 kg m^2 alone; from 2 s on it catches up what it has lost, in 1 s.
#[test]
fn a_freewheel_takes_along_and_overruns() {
    let mut sim = started(&Clutches::new());
    sim.step_to(0.9).unwrap();
    near(sim.value_of("hub.torque"), 1.5, 1e-9);
    near(sim.value_of("hub.locked"), 1.0, 0.0);
    sim.step_to(1.5).unwrap();
    near(sim.value_of("four.speed"), 5.0, 1e-9);
    near(sim.value_of("three.speed"), 5.0 - 10.0, 1e-9);
    near(sim.value_of("hub.torque"), 0.0, 0.0);
    sim.step_to(2.999).unwrap();
    near(sim.value_of("hub.locked"), 0.0, 0.0);
    sim.step_to(4.0).unwrap();
    near(sim.value_of("four.speed"), 5.0 + 5.0, 1e-9);
    near(sim.value_of("three.speed"), 10.0, 1e-9);
}

/// J. E. Shigley, C. R. Mischke, Mechanical Engineering Design, example 16-2: 366 and 162 N m of the shoes.
#[test]
fn a_drum_brake_presses_its_leading_shoe_on() {
    for sense in [1.0, -1.0] {
        let mut brakes = Brakes::new();
        brakes = brakes.with_start("five.wheel.omega", 20.0 * sense);
        brakes = brakes.with_start("six.wheel.omega", 20.0 * sense);
        let mut sim = started(&brakes);
        sim.step_to(0.1).unwrap();
        near(sim.value_of("drum.leading_torque"), 366.0, 1.0);
        near(sim.value_of("drum.trailing_torque"), 162.0, 1.0);
        let both = sim.value_of("drum.leading_torque") + sim.value_of("drum.trailing_torque");
        near(sim.value_of("drum.torque"), -sense * both, 1e-9);
        near(sim.value_of("drum.lost"), both * (20.0 - 0.1 * both / 10.0), 1e-6);
        let shoe = if sense > 0.0 {
            sim.value_of("drum.leading_torque")
        } else {
            sim.value_of("drum.trailing_torque")
        };
        near(sim.value_of("pair.torque"), -2.0 * sense * shoe, 1e-9);
        sim.step_to(1.0).unwrap();
        near(sim.value_of("drum.torque"), 0.0, 1e-9);
    }
}

/// The speed 10 - 10 t + t^2/2 is zero at 10 - sqrt(80) s. What holds is 15 N m, which the drive t N m reaches at 15 s; what slips is 10 N m.
#[test]
fn a_brake_stops_holds_and_breaks_away() {
    let mut sim = started(&Brakes::new());
    let rest = 10.0 - 80_f64.sqrt();
    sim.step_to(1.0).unwrap();
    near(sim.value_of("seven.speed"), 0.5, 1e-9);
    near(sim.value_of("stop.lost"), 5.0, 1e-8);
    sim.step_to(rest + 1e-6).unwrap();
    near(sim.value_of("seven.speed"), 0.0, 1e-9);
    sim.step_to(14.0).unwrap();
    near(sim.value_of("stop.torque"), -14.0, 1e-9);
    sim.step_to(16.0).unwrap();
    near(sim.value_of("stop.torque"), -10.0, 1e-12);
    near(sim.value_of("seven.speed"), (36.0 - 25.0) / 2.0, 1e-8);
}

/// The driver jumps by dw = 80 rad/s: the slip ends after J1 J2 dw/((J1 + J2) T), and its heat is J1 J2 dw^2/(2 (J1 + J2)).
#[test]
fn a_torque_limiter_slips_after_a_jump_until_the_speeds_meet() {
    let mut sim = started(&Clutches::new());
    let reduced = 0.2 * 0.3 / 0.5;
    let end = 0.1 + reduced * 80.0 / 30.0;
    sim.step_to(0.05).unwrap();
    near(sim.value_of("limiter.locked"), 1.0, 0.0);
    near(sim.value_of("limiter.torque"), 0.0, 1e-9);
    sim.step_to(0.1 + 1e-9).unwrap();
    near(sim.value_of("driver.omega"), 100.0, 1e-6);
    near(sim.value_of("driven.omega"), 20.0, 1e-6);
    sim.step_to(end - 1e-6).unwrap();
    near(sim.value_of("limiter.locked"), 0.0, 0.0);
    near(sim.value_of("limiter.torque"), 30.0, 1e-12);
    near(sim.value_of("limiter.slip"), -30.0 / reduced * 1e-6, 1e-9);
    near(sim.value_of("limiter.lost"), 30.0 * 30.0 / reduced * 1e-6, 1e-7);
    sim.step_to(end + 1e-6).unwrap();
    near(sim.value_of("limiter.locked"), 1.0, 0.0);
    near(sim.value_of("slip_heat"), 0.5 * reduced * 80.0 * 80.0, 1e-6);
    near(sim.value_of("driver.omega"), (0.2 * 100.0 + 0.3 * 20.0) / 0.5, 1e-9);
}

/// Of a drive M, the limiter carries M J2/(J1 + J2) while it holds: 1.5 30 N m at 1.75 s, for M = 100 N m/s (t - 1 s). After that the
/// slip has the rate 30/J2 - (M - 30)/J1.
#[test]
fn a_torque_limiter_breaks_away_at_its_static_torque() {
    let mut sim = started(&Clutches::new());
    sim.step_to(1.7499).unwrap();
    near(sim.value_of("limiter.locked"), 1.0, 0.0);
    near(sim.value_of("limiter.torque"), 74.99 * 0.6, 1e-9);
    sim.step_to(1.8).unwrap();
    near(sim.value_of("limiter.torque"), 30.0, 1e-12);
    let slip = (30.0 / 0.3 + 30.0 / 0.2) * 0.05 - 50.0 / 0.2 * (0.8 * 0.8 - 0.75 * 0.75);
    near(sim.value_of("limiter.slip"), slip, 1e-8);
    near(sim.value_of("limiter.lost"), -30.0 * slip, 1e-6);
}
