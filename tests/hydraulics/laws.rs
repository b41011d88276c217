//! Every part's law beside formulas that were written down independently.

use std::f64::consts::PI;

use crate::{Random, assert_near};

plm::mechanism! {
    pub Bench {
        param gas: 1 = 0;
        param boiling: Pa = 0;
        input current: 1 = 0;
        sliding_mass rod() { mass: 3 kg; }
        cylinder press(rod.slider) {
            piston_diameter: 40 mm;
            rod_diameter: 25 mm;
            stroke: 0.3 m;
            friction: 150 N/(m/s);
            dead_volume: 30 cm^3;
            stop_stiffness: 1e7 N/m;
            stop_damping: 500 N/(m/s);
            chamber1.oil.gas_content: gas;
            chamber1.oil.polytropic_index: 1.4;
            chamber1.oil.vapour_pressure: boiling;
        }
        oil_line line(press.port1) { length: 2 m; diameter: 12 mm; }
        servo_valve valve(pump.port, line.port, press.port2, tank.port) {
            signal: current;
            rated_signal: 10;
            flow_pa: 11 L/min;
            flow_bt: 12 L/min;
            flow_pb: 13 L/min;
            flow_at: 14 L/min;
            rated_drop: 35 bar;
            transition: 0.4 bar;
            frequency: 60 Hz;
            damping_ratio: 0.7;
        }
        oil_source pump() { pressure: 140 bar; }
        oil_tank tank() { pressure: 1 bar; }
        output acceleration = rate(rod.speed), press.force, press.stop_force, press.lost;
        output rate1 = rate(press.pressure1), rate2 = rate(press.pressure2), rate_of_line = rate(line.pressure);
        output rate_of_flow = rate(line.flow), rate_of_opening = rate(valve.servo_speed);
        output valve.flow_a, valve.flow_b, valve.lost, pump.flow, tank_flow = tank.flow;
    }
}

const B: f64 = 1.7e9;

/// A state of the bench.
#[derive(Debug)]
struct Point {
    x: f64,
    v: f64,
    p1: f64,
    p2: f64,
    line: f64,
    flow: f64,
    spool: f64,
    swing: f64,
}

impl Point {
    fn random(random: &mut Random) -> Self {
        // One in three is at an end stop.
        let x = match random.between(0.0, 3.0) {
            near if near < 0.5 => random.between(-3e-6, 0.0),
            far if far < 1.0 => 0.3 + random.between(0.0, 3e-6),
            _ => random.between(0.0, 0.3),
        };
        Self {
            x,
            v: random.between(-1.0, 1.0),
            p1: random.between(-0.9e5, 150e5),
            p2: random.between(-0.9e5, 150e5),
            line: random.between(-0.9e5, 150e5),
            flow: random.between(-5e-4, 5e-4),
            spool: random.between(-1.3, 1.3),
            swing: random.between(-1.0, 1.0),
        }
    }

    fn bench(&self, gas: f64, boiling: f64) -> plm::Sim<Bench> {
        let mut bench = Bench { gas, boiling, ..Bench::new() };
        let start = &mut bench.start;
        start.rod_carriage.x.value = self.x;
        start.rod_carriage.vx.value = self.v;
        start.press_chamber1_pressure.value = self.p1;
        start.press_chamber2_pressure.value = self.p2;
        start.line_inlet_pressure.value = self.line;
        start.line_flow.value = self.flow;
        start.valve_servo_value.value = self.spool;
        start.valve_servo_swing.value = self.swing;
        bench.start().unwrap()
    }
}

/// L/min at 35 bar, through an edge that is open by a share, with the law of the square root.
fn turbulent(litres: f64, opening: f64, drop: f64) -> f64 {
    let rated = litres / 60_000.0 / f64::sqrt(35e5);
    // From laminar to turbulent around 0.4 bar: the fourth root of p^2 + p_t^2 in place of the root of p.
    rated * opening * drop / (drop * drop + 0.4e5 * 0.4e5).powf(0.25)
}

#[test]
fn pressures_flows_and_forces_follow_their_laws() {
    let mut random = Random(4);
    for _ in 0..200 {
        let point = Point::random(&mut random);
        let mut sim = point.bench(0.0, 0.0);
        let current = random.between(-15.0, 15.0);
        sim.input.current = current;
        let Point { x, v, p1, p2, line, flow, spool, swing } = point;
        let (area1, area2) = (PI / 4.0 * 0.04_f64.powi(2), PI / 4.0 * (0.04_f64.powi(2) - 0.025_f64.powi(2)));

        // A positive signal opens P to A and B to T.
        let (ahead, back) = (spool.clamp(0.0, 1.0), (-spool).clamp(0.0, 1.0));
        let (pa, bt) = (turbulent(11.0, ahead, 140e5 - line), turbulent(12.0, ahead, p2 - 1e5));
        let (pb, at) = (turbulent(13.0, back, 140e5 - p2), turbulent(14.0, back, line - 1e5));
        assert_near(sim.valve_flow_a(), pa - at, 1e-4, "flow at A");
        assert_near(sim.valve_flow_b(), pb - bt, 1e-4, "flow at B");
        assert_near(sim.pump_flow(), pa + pb, 1e-4, "flow of the source");
        assert_near(sim.tank_flow(), at + bt, 1e-4, "flow into the tank");
        let lost = pa * (140e5 - line) + bt * (p2 - 1e5) + pb * (140e5 - p2) + at * (line - 1e5);
        assert_near(sim.valve_lost(), lost, 10.0, "heat of the valve");

        // Continuity: V dp/dt = B (Q - dV/dt).
        let (volume1, volume2) = (30e-6 + area1 * x, 30e-6 + area2 * (0.3 - x));
        assert_near(sim.rate1(), B / volume1 * (flow - area1 * v), 1e7, "p1");
        assert_near(sim.rate2(), B / volume2 * (pb - bt + area2 * v), 1e7, "p2");
        let (length, bore) = (2.0, 0.012_f64);
        let section = PI / 4.0 * bore * bore;
        assert_near(sim.rate_of_line(), B / (section * length) * (pa - at - flow), 1e7, "line");
        // A plug of oil, and Hagen-Poiseuille.
        let friction = 128.0 * 0.051 * length / (PI * bore.powi(4)) * flow;
        let expected = (line - p1 - friction) * section / (850.0 * length);
        assert_near(sim.rate_of_flow(), expected, 1e-3, "flow of the line");

        let omega = 2.0 * PI * 60.0;
        let expected = omega * omega * (current / 10.0 - spool) - 2.0 * 0.7 * omega * omega * swing;
        assert_near(sim.rate_of_opening(), expected, omega * omega, "spool");

        let stop = stop(x, v);
        assert_near(sim.press_stop_force(), stop, 1.0, "end stop");
        let force = p1 * area1 - p2 * area2 - 150.0 * v + stop;
        assert_near(sim.press_force(), force, 1e3, "force of the cylinder");
        assert_near(sim.acceleration(), force / 3.0, 1e3, "rod");
    }
}

/// Stops at 0 and 0.3 m that never pull, damped from 1 um on.
fn stop(x: f64, v: f64) -> f64 {
    let contact = |depth: f64, speed: f64| {
        if depth <= 0.0 { 0.0 } else { (1e7 * depth + 500.0 * speed * f64::min(depth / 1e-6, 1.0)).max(0.0) }
    };
    contact(-x, -v) - contact(x - 0.3, v)
}

/// The modulus of a mixture by the change of its volume: gas and liquid, each by its own law.
#[test]
fn gas_softens_the_oil() {
    let mut random = Random(5);
    for _ in 0..100 {
        let mut point = Point::random(&mut random);
        (point.x, point.spool) = (0.1, 0.0);
        point.p1 = random.between(-0.95e5, 20e5);
        let gas = random.between(1e-4, 0.05);
        let sim = point.bench(gas, 0.0);
        let absolute = point.p1 + 101_325.0;
        let gas_volume = gas * (101_325.0 / absolute).powf(1.0 / 1.4);
        let volume = 1.0 - gas + gas_volume;
        // dV/dp of the liquid and of p V^n = constant.
        let change = (1.0 - gas) / B + gas_volume / (1.4 * absolute);
        let area = PI / 4.0 * 0.04_f64.powi(2);
        let expected = volume / change / (30e-6 + area * 0.1) * (point.flow - area * point.v);
        assert_near(sim.rate1(), expected, 1e5, "p1");
    }
}

#[test]
fn boiling_oil_is_as_soft_as_its_vapour() {
    let point = |p1| Point { x: 0.1, v: 0.5, p1, p2: 1e5, line: 0.0, flow: 0.0, spool: 0.0, swing: 0.0 };
    let area = PI / 4.0 * 0.04_f64.powi(2);
    let volume = 30e-6 + area * 0.1;
    let modulus =
        |absolute: f64| -point(absolute - 101_325.0).bench(0.0, 20_000.0).rate1() * volume / (area * 0.5);
    assert_near(modulus(20_001.0), B, B, "above the vapour pressure");
    for absolute in [10_000.0, 4_000.0, 500.0] {
        assert_near(modulus(absolute), 1.0 / (1.0 / B + 1.0 / absolute), absolute, "below half of it");
    }
    // No jump in between.
    let steps: Vec<f64> = (0..=1000).map(|k| 1.0 / modulus(10_000.0 + 10.0 * f64::from(k))).collect();
    let largest = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
    assert!(largest < 3e-3 * steps[0], "{largest:e} {:e}", steps[0]);
}

plm::mechanism! {
    /// Springs between two masses and two wheels.
    pub Springs {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        sliding_mass left() { mass: 1 kg; angle: 90 deg; }
        sliding_mass right() { mass: 1 kg; angle: 90 deg; }
        slider_spring soft(left.slider, right.slider) {
            stiffness: 70 N/m;
            damping: 3 N/(m/s);
            free_length: 0.2 m;
            preload: 11 N;
        }
        force_state_spring kept(left.slider, right.slider) { stiffness: 50 N/m; damping: 2 N/(m/s); }
        body wheel { mass: 1 kg; inertia: 0.5 kg*m^2; port o: (0, 0) m; start angle: 0.3 rad, locked; }
        revolute bearing(ground.o, wheel.o);
        body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port p: (0.1, 0.2) m; }
        frame_axes axes(plate.p);
        slider_velocity belt() { velocity: 0.7 m/s; }
        slider_ground wall() { position: -0.4 m; }
        slider_spring x(belt.slider, axes.x) { damping: 5 N/(m/s); }
        slider_spring y(wall.slider, axes.y) { stiffness: 8 N/m; }
        shaft_spring twist(bearing.shaft, axes.shaft) { stiffness: 4 N*m/rad; damping: 0.1 N*m/(rad/s); rest: 0.1 rad; preload: 2 N*m; }
        torque_state_spring held(bearing.shaft, axes.shaft) { stiffness: 3 N*m/rad; damping: 0.2 N*m/(rad/s); }
        output soft.force, kept.force, change = rate(kept.spring_force);
        output twist.torque, held.torque, change_of_torque = rate(held.spring_torque);
        output plate.alpha, ax = plate.ax, ay = plate.ay, belt.force, wall.force, axes.force;
    }
}

#[test]
fn springs_of_lines_and_shafts_follow_their_laws() {
    let mut random = Random(6);
    for _ in 0..50 {
        let mut draw = || random.between(-1.0, 1.0);
        let mut springs = Springs::new();
        let start = &mut springs.start;
        let (a, b, va, vb, kept, held) = (draw(), draw(), draw(), draw(), draw(), draw());
        (start.left_carriage.y.value, start.left_carriage.vy.value) = (a, va);
        (start.right_carriage.y.value, start.right_carriage.vy.value) = (b, vb);
        (start.kept_spring_force.value, start.held_spring_torque.value) = (kept, held);
        let (x, y, angle) = (draw(), draw(), draw());
        let plate = &mut start.plate;
        (plate.x.value, plate.y.value, plate.angle.value) = (x, y, angle);
        let (vx, vy, omega) = (draw(), draw(), draw());
        (plate.vx.value, plate.vy.value, plate.omega.value) = (vx, vy, omega);
        let spin = draw();
        start.wheel.omega.value = spin;
        let sim = springs.start().unwrap();

        assert_near(sim.soft_force(), 11.0 - 70.0 * (b - a - 0.2) - 3.0 * (vb - va), 1.0, "soft");
        assert_near(sim.kept_force(), kept - 2.0 * (vb - va), 1.0, "kept");
        assert_near(sim.change(), -50.0 * (vb - va), 1.0, "rate of the force");
        let twist = 2.0 - 4.0 * (angle - 0.3 - 0.1) - 0.1 * (omega - spin);
        assert_near(sim.twist_torque(), twist, 1.0, "twist");
        let moment = held - 0.2 * (omega - spin);
        assert_near(sim.held_torque(), moment, 1.0, "held");
        assert_near(sim.change_of_torque(), -3.0 * (omega - spin), 1.0, "rate of the torque");

        let (sin, cos) = angle.sin_cos();
        let arm = [0.1 * cos - 0.2 * sin, 0.1 * sin + 0.2 * cos];
        let force = [-5.0 * (vx - omega * arm[1] - 0.7), -8.0 * (y + arm[1] + 0.4)];
        assert_near(sim.ax(), force[0] / 2.0, 1.0, "x of the plate");
        assert_near(sim.ay(), force[1] / 2.0 - 9.81, 1.0, "y of the plate");
        let torque = arm[0] * force[1] - arm[1] * force[0] + twist + moment;
        assert_near(sim.plate_alpha(), torque / 0.3, 1.0, "turn of the plate");
        assert_near(sim.belt_force(), force[0], 1.0, "what the belt does");
        assert_near(sim.wall_force(), force[1], 1.0, "what the wall does");
    }
}
