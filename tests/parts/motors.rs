//! Motors, servos, prescribed motions, gas springs, counterweights.

use plm::{Dop853, Sim};

use crate::near;

plm::mechanism! {
    pub Motors {
        gravity: 9.81 m/s^2;
        param index: 1 = 1.4;
        // A motion that is handed over: value, rate and acceleration at a time.
        param at: s = 0;
        param place: rad = 0;
        param speed: rad/s = 0;
        param gain: rad/s^2 = 0;
        ground { port o: (0, 0) m, axis: 0 deg; port base: (0, 0) m; port pivot: (5, 0) m; }
        rotor six() { inertia: 1e-3 kg*m^2; }
        dc_motor motor(six.shaft) { voltage: 12 volt; resistance: 0.5 ohm; inductance: 2e-2 henry; constant: 0.05 N*m/ampere; }
        rotor seven() { inertia: 0.01 kg*m^2; }
        motor_curve curve(seven.shaft) { stall_torque: 2 N*m; free_speed: 300 rad/s; command: 0.5; }
        rotor eight() { inertia: 0.02 kg*m^2; }
        servo position(eight.shaft) {
            target: 2 rad; position_gain: 20 Hz; speed_gain: 1 N*m/(rad/s); speed_limit: 1 rad/s; torque_limit: 0.1 N*m;
        }
        rotor nine() { inertia: 0.03 kg*m^2; }
        motion told(nine.shaft) { value: place + speed*(t - at) + gain*(t - at)^2/2; }
        rotor ten() { inertia: 0.03 kg*m^2; }
        motion planned(ten.shaft) { value: smooth_table(t, (0 s, 0 rad), (1 s, 2 rad)); }
        body lid { mass: 5 kg; inertia: 1 kg*m^2; port foot: (0, 0) m; start x: 0.3 m, locked; }
        prismatic guide(ground.o, lid.foot);
        gas_spring strut(ground.base, lid.foot) {
            extended_length: 0.5 m; rod_diameter: 10 mm; volume: 30 cm^3; pressure: 60 bar; polytropic_index: index;
        }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (-0.4, 0) m; port tail: (-0.6, 0) m; start x: 5.4 m; }
        revolute pivot(ground.pivot, arm.pivot);
        counterweight balance(arm.tail) { balances: 2 kg*0.4 m; arm: 0.2 m; radius: 5 cm; }
        body cart { mass: 2 kg; inertia: 1 kg*m^2; port foot: (0, 0) m; start x: 0.2 m; start y: 2 m; }
        ground { port low: (0, 2) m, axis: 0 deg; }
        prismatic line(ground.low, cart.foot);
        spring hard(ground.low, cart.foot) { free_length: 0.1 m; characteristic: 1e4 N/m^3*hard.displacement^3; }
        output motor.current, motor.back_emf, motor.energy, motor.input_power, motor.power, motor.lost, six.speed;
        output curve.power, curve.torque, seven.speed, position.torque, position.error, eight.speed, eight.angle;
        output told.torque, told.power, nine.angle, nine.speed, planned.torque, ten.speed;
        output strut.force, strut.gas_pressure, strut.gas_volume, lid.x, lid.vx, balance.mass, pivot.force, arm.alpha, cart.x, cart.vx;
    }
}

fn started(motors: &Motors) -> Sim<Motors> {
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
        near(sim.six_speed(), speed, 1e-7);
        let current = (-half * time).exp() * sin * v / l;
        near(sim.motor_current(), current, 1e-7);
        near(sim.motor_energy(), l * current * current / 2.0, 1e-7);
        near(sim.motor_power(), k * speed * current, 1e-5);
        near(sim.motor_lost(), r * current * current, 1e-5);
        near(sim.motor_input_power(), v * current, 1e-5);
        near(sim.motor_back_emf(), k * speed, 1e-7);
    }
}

#[test]
fn a_motor_by_its_line_runs_up_and_a_servo_keeps_its_limits() {
    let mut sim = started(&Motors::new());
    // 2 N m (1/2 - w/300): a time constant of 0.01 300/2 s.
    sim.step_to(0.005).unwrap();
    near(sim.eight_speed(), 0.1 * 0.005 / 0.02, 1e-9);
    sim.step_to(0.3).unwrap();
    // The torque leaves its limit at 0.9 rad/s, behind 0.18 s; then 1 - 0.1 exp(-(t - 0.18)/0.02).
    near(sim.eight_speed(), 1.0 - 0.1 * (-0.12_f64 / 0.02).exp(), 1e-8);
    near(sim.position_torque(), 0.1 * (-0.12_f64 / 0.02).exp(), 1e-8);
    sim.step_to(0.9).unwrap();
    near(sim.seven_speed(), 150.0 * (1.0 - (-0.9_f64 / 1.5).exp()), 1e-7);
    near(sim.curve_power(), sim.curve_torque() * sim.seven_speed(), 1e-12);
    sim.step_to(5.0).unwrap();
    near(sim.eight_angle(), 2.0, 1e-9);
    near(sim.position_error(), 0.0, 1e-9);
}

/// Inverse dynamics: J times the acceleration that is asked for.
#[test]
fn a_motion_takes_its_torque() {
    let mut sim = started(&Motors::new());
    sim.step_to(0.25).unwrap();
    // 10 s^3 - 15 s^4 + 6 s^5, twice: its second derivative is 2 (60 s - 180 s^2 + 120 s^3).
    near(sim.planned_torque(), 0.03 * 2.0 * (15.0 - 180.0 / 16.0 + 120.0 / 64.0), 1e-9);
    // A swing that is handed over every millisecond.
    let mut sim = started(&Motors { speed: 3.0, ..Motors::new() });
    for k in 0..200 {
        let at = 1e-3 * f64::from(k);
        let (sin, cos) = (3.0 * at).sin_cos();
        let motors = &mut sim.mechanism;
        (motors.at, motors.place, motors.speed, motors.gain) = (at, sin, 3.0 * cos, -9.0 * sin);
        sim.step(1e-3).unwrap();
        let (sin, cos) = (3.0 * (at + 1e-3)).sin_cos();
        near(sim.nine_angle(), sin, 1e-8);
        near(sim.nine_speed(), 3.0 * cos, 2e-5);
        near(sim.told_torque(), -9.0 * 0.03 * sin, 9.0 * 0.03 * 3e-3);
        near(sim.told_power(), sim.told_torque() * sim.nine_speed(), 1e-12);
    }
}

/// p V^n = p0 V0^n, and the work of the gas becomes motion.
#[test]
fn a_gas_spring_is_polytropic() {
    for index in [1.0, 1.4] {
        let mut sim = started(&Motors { index, ..Motors::new() });
        let area = std::f64::consts::PI / 4.0 * 1e-4;
        let volume = |length: f64| 30e-6 - area * (0.5 - length);
        let pressure = |length: f64| 60e5 * (30e-6 / volume(length)).powf(index);
        near(sim.strut_gas_pressure(), pressure(0.3), 1e-3);
        near(sim.strut_force(), area * (pressure(0.3) - 1.01325e5), 1e-7);
        sim.step_to(0.03).unwrap();
        let length = sim.lid_x();
        assert!(length > 0.32 && length < 0.6, "{length}");
        near(sim.strut_gas_volume(), volume(length), 1e-15);
        let (from, to) = (volume(0.3), volume(length));
        let work = if index == 1.0 {
            60e5 * 30e-6 * (to / from).ln()
        } else {
            (pressure(0.3) * from - pressure(length) * to) / (index - 1.0)
        };
        near(2.5 * sim.lid().vx.powi(2), work - 1.01325e5 * (to - from), 1e-7);
    }
}

/// The moment of the weights about the pivot is nothing, whatever the angle; a cubic spring keeps its energy.
#[test]
fn a_counterweight_balances_and_a_spring_has_its_characteristic() {
    for angle in [0.0, 0.7, 2.0] {
        let mut motors = Motors::new();
        motors.start.arm.angle.value = angle;
        motors.start.arm.angle.locked = true;
        let sim = started(&motors);
        near(sim.balance_mass(), 4.0, 1e-12);
        near(sim.arm_alpha(), 0.0, 1e-9);
        // On the ground: both weights.
        near(sim.pivot_force()[1], -6.0 * 9.81, 1e-9);
    }
    let mut sim = started(&Motors::new());
    sim.step_to(0.1).unwrap();
    let x = sim.cart_x() - 0.1;
    assert!(x < 0.0999, "{x}");
    near(sim.cart_vx().powi(2) + 2.5e3 * x.powi(4), 2.5e3 * 1e-4, 1e-10);
}
