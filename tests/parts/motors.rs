//! Motors, servos, prescribed motions, gas springs, counterweights.

use plm::{Dop853, Mechanism as _, Sim};

use crate::declared::{Motors, Springs};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

fn started(motors: &Scene) -> Sim<Scene> {
    motors.start_with(Dop853::new(1e-11)).unwrap()
}

/// L J w'' + R J w' + k^2 w = k V: two real roots here.
#[test]
fn a_dc_motor_answers_a_step_of_its_voltage() {
    let mut sim = started(&Motors::new());
    let (l, r, j, k, v) = (2e-2_f64, 0.5, 1e-3, 0.05, 12.0);
    let half = r / (2.0 * l);
    let root = half * half - k * k / (l * j);
    for time in [0.05, 0.2, 0.6] {
        sim.step_to(time).unwrap();
        let w = root.abs().sqrt();
        // Underdamped where the root is negative.
        let (cos, sin) = if root < 0.0 {
            ((w * time).cos(), (w * time).sin() / w)
        } else {
            ((w * time).cosh(), (w * time).sinh() / w)
        };
        let speed = v / k * (1.0 - (-half * time).exp() * (cos + half * sin));
        near(sim.value_of("six.speed"), speed, 1e-7);
        let current = (-half * time).exp() * sin * v / l;
        near(sim.value_of("motor.current"), current, 1e-7);
        near(sim.value_of("motor.energy"), l * current * current / 2.0, 1e-7);
        near(sim.value_of("motor.power"), k * speed * current, 1e-5);
        near(sim.value_of("motor.lost"), r * current * current, 1e-5);
        near(sim.value_of("motor.input_power"), v * current, 1e-5);
        near(sim.value_of("motor.back_emf"), k * speed, 1e-7);
    }
}

#[test]
fn a_motor_by_its_line_runs_up_and_a_servo_keeps_its_limits() {
    let mut sim = started(&Motors::new());
    // 2 N m (1/2 - w/300): a time constant of 0.01 300/2 s.
    sim.step_to(0.005).unwrap();
    near(sim.value_of("eight.speed"), 0.1 * 0.005 / 0.02, 1e-9);
    sim.step_to(0.3).unwrap();
    // The torque leaves its limit at 0.9 rad/s, after 0.18 s; then 1 - 0.1 exp(-(t - 0.18)/0.02).
    near(sim.value_of("eight.speed"), 1.0 - 0.1 * (-0.12_f64 / 0.02).exp(), 1e-8);
    near(sim.value_of("position.torque"), 0.1 * (-0.12_f64 / 0.02).exp(), 1e-8);
    sim.step_to(0.9).unwrap();
    near(sim.value_of("seven.speed"), 150.0 * (1.0 - (-0.9_f64 / 1.5).exp()), 1e-7);
    near(sim.value_of("curve.power"), sim.value_of("curve.torque") * sim.value_of("seven.speed"), 1e-12);
    sim.step_to(5.0).unwrap();
    near(sim.value_of("eight.angle"), 2.0, 1e-9);
    near(sim.value_of("position.error"), 0.0, 1e-9);
}

/// Inverse dynamics: J times the acceleration that is asked for.
#[test]
fn a_motion_takes_its_torque() {
    let mut sim = started(&Motors::new());
    sim.step_to(0.25).unwrap();
    // 10 s^3 - 15 s^4 + 6 s^5, twice: its second derivative is 2 (60 s - 180 s^2 + 120 s^3).
    near(sim.value_of("planned.torque"), 0.03 * 2.0 * (15.0 - 180.0 / 16.0 + 120.0 / 64.0), 1e-9);
    // A swing that is handed over every millisecond.
    let mut sim = started(&Motors::new().with("speed", 3.0));
    for k in 0..200 {
        let at = 1e-3 * f64::from(k);
        let (sin, cos) = (3.0 * at).sin_cos();
        for (name, value) in [("at", at), ("place", sin), ("speed", 3.0 * cos), ("gain", -9.0 * sin)] {
            sim.set_parameter(name, value);
        }
        sim.step(1e-3).unwrap();
        let (sin, cos) = (3.0 * (at + 1e-3)).sin_cos();
        near(sim.value_of("nine.angle"), sin, 1e-8);
        near(sim.value_of("nine.speed"), 3.0 * cos, 2e-5);
        near(sim.value_of("told.torque"), -9.0 * 0.03 * sin, 9.0 * 0.03 * 3e-3);
        near(sim.value_of("told.power"), sim.value_of("told.torque") * sim.value_of("nine.speed"), 1e-12);
    }
}

/// p V^n = p0 V0^n, and the work of the gas becomes motion.
#[test]
fn a_gas_spring_is_polytropic() {
    for index in [1.0, 1.4] {
        let mut sim = started(&Springs::new().with("index", index));
        let area = std::f64::consts::PI / 4.0 * 1e-4;
        let volume = |length: f64| 30e-6 - area * (0.5 - length);
        let pressure = |length: f64| 60e5 * (30e-6 / volume(length)).powf(index);
        near(sim.value_of("strut.gas_pressure"), pressure(0.3), 1e-3);
        near(sim.value_of("strut.force"), area * (pressure(0.3) - 1.01325e5), 1e-7);
        sim.step_to(0.03).unwrap();
        let length = sim.value_of("lid.x");
        assert!(length > 0.32 && length < 0.6, "{length}");
        near(sim.value_of("strut.gas_volume"), volume(length), 1e-15);
        let (from, to) = (volume(0.3), volume(length));
        let work = if index == 1.0 {
            60e5 * 30e-6 * (to / from).ln()
        } else {
            (pressure(0.3) * from - pressure(length) * to) / (index - 1.0)
        };
        near(2.5 * sim.state_of("lid").vx.powi(2), work - 1.01325e5 * (to - from), 1e-7);
    }
}

/// The moment of the weights about the pivot is nothing, whatever the angle; a cubic spring keeps its energy.
#[test]
fn a_counterweight_balances_and_a_spring_has_its_characteristic() {
    for angle in [0.0, 0.7, 2.0] {
        let motors = Springs::new().with_lock("arm.angle", angle);
        let sim = started(&motors);
        near(sim.value_of("balance.mass"), 4.0, 1e-12);
        near(sim.value_of("arm.alpha"), 0.0, 1e-9);
        // On the ground: both weights.
        near(sim.vector_of("pivot.force")[1], -6.0 * 9.81, 1e-9);
    }
    let mut sim = started(&Springs::new());
    sim.step_to(0.1).unwrap();
    let x = sim.value_of("cart.x") - 0.1;
    assert!(x < 0.0999, "{x}");
    near(sim.value_of("cart.vx").powi(2) + 2.5e3 * x.powi(4), 2.5e3 * 1e-4, 1e-10);
}
