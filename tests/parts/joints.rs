//! Limits and friction of joints.

use plm::{Dop853, Mechanism as _};

use crate::declared::{Frictions, Limits};
use crate::scene::{Given as _, Named as _};

const G: f64 = 9.81;

/// Asserts that two numbers differ by `within` at most.
#[track_caller]
pub(crate) fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}

/// The arithmetic-geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// At the bottom the pendulum strikes with e: it rises to e^2 of the height, and each flight takes half a period of its own amplitude.
#[test]
fn a_pendulum_strikes_the_limit_of_its_hinge() {
    let mut sim = Limits::new().start_with(Dop853::new(1e-11)).unwrap();
    let (inertia, mgl, e) = (0.5 + 2.0, 2.0 * G, 0.8);
    let quarter = |amplitude: f64| {
        let k = (0.5 * amplitude).sin();
        (inertia / mgl).sqrt() * core::f64::consts::FRAC_PI_2 / mean(1.0, (1.0 - k * k).sqrt())
    };
    let mut height = 1.0 - 70_f64.to_radians().cos();
    let mut time = quarter(70_f64.to_radians());
    for _ in 0..4 {
        let speed = (2.0 * mgl * height / inertia).sqrt();
        sim.step_to(time - 1e-9).unwrap();
        near(sim.state_of("bob").omega, speed, 1e-7);
        sim.step_to(time + 1e-9).unwrap();
        near(sim.state_of("bob").omega, -e * speed, 1e-7);
        height *= e * e;
        let amplitude = (1.0 - height).acos();
        sim.step_to(time + quarter(amplitude)).unwrap();
        near(sim.state_of("bob").angle, -amplitude, 1e-9);
        near(sim.state_of("bob").omega, 0.0, 1e-7);
        time += 2.0 * quarter(amplitude);
    }
}

/// Spring and damper that push and do not pull leave e = exp(-(beta/omega) (pi - 2 atan(beta/omega))) of the speed, after t = (pi - 2
/// atan(beta/omega))/omega (T. Schwager, T. Poeschel, Granular Matter 9, 2007).
#[test]
fn an_elastic_limit_gives_back_what_its_damper_leaves() {
    let (inertia, stiffness, damping) = (0.5, 5e3_f64, 8.0);
    let beta = damping / (2.0 * inertia);
    let omega = (stiffness / inertia - beta * beta).sqrt();
    let angle = core::f64::consts::PI - 2.0 * (beta / omega).atan();
    let e = (-beta / omega * angle).exp();
    let mut sim = Limits::new().with("loss", damping).start_with(Dop853::new(1e-11)).unwrap();
    let (mut time, mut speed, mut way) = (0.0, 4.0, 1.0);
    for side in [-1.0, 1.0, -1.0] {
        time += way / speed;
        // The deepest point, where the speed is zero.
        let deepest = (omega / beta).atan() / omega;
        sim.step_to(time + deepest).unwrap();
        near(sim.state_of("disc").omega, 0.0, 1e-7);
        let depth = speed / omega * (-beta * deepest).exp() * (omega * deepest).sin();
        near(sim.state_of("disc").angle, side * (1.0 + depth), 1e-9);
        let [up, down] = [sim.value_of("axle.lower_limit_torque"), sim.value_of("axle.upper_limit_torque")];
        let [pushing, other] = if side < 0.0 { [up, down] } else { [down, up] };
        near(pushing, stiffness * depth, 1e-5);
        near(other, 0.0, 0.0);
        // It leaves before the spring is free, and flies from there to the other limit.
        time += angle / omega;
        sim.step_to(time + 1e-6).unwrap();
        way = 2.0 + speed / omega * e * angle.sin();
        speed *= e;
        near(sim.state_of("disc").omega, -side * speed, 1e-9);
    }
}

/// A sled without friction strikes with e, and comes to rest on its limit at 0.5 m: T = t (1 + 2 e/(1 - e)), after which the limit carries it.
#[test]
fn a_slide_comes_to_rest_on_its_limit() {
    let mut sim = Limits::new().start_with(Dop853::new(1e-11)).unwrap();
    let a = G * 20_f64.to_radians().sin();
    let first = (2.0 * 0.5 / a).sqrt();
    sim.step_to(first + 1e-9).unwrap();
    near((sim.state_of("sled").vx.powi(2) + sim.state_of("sled").vy.powi(2)).sqrt(), 0.5 * a * first, 1e-7);
    assert!(sim.state_of("sled").vx < 0.0);
    // The highest point after the first impact, a quarter of the way up.
    sim.step_to(first * 1.5).unwrap();
    near((sim.state_of("sled").x - 10.0) / 20_f64.to_radians().cos(), 0.375, 1e-9);
    sim.step_to(first * 3.0 + 1e-3).unwrap();
    near((sim.state_of("sled").x - 10.0) / 20_f64.to_radians().cos(), 0.5, 1e-12);
    near(sim.value_of("slope.upper_limit_force"), 2.0 * a, 1e-9);
    let rest = sim.state_of("sled").x;
    sim.step_to(10.0).unwrap();
    near(sim.state_of("sled").x, rest, 1e-12);
}

/// A block that falls 0.5 m on a spring is stopped at depth + 0.5 = k depth^2/(2 m g), without loss.
#[test]
fn an_elastic_limit_of_a_slot_holds_a_fall() {
    let mut sim = Limits::new().start_with(Dop853::new(1e-11)).unwrap();
    let (weight, stiffness) = (2.0 * G, 1e4_f64);
    let depth = (weight + (weight * weight + 2.0 * stiffness * weight * 0.5).sqrt()) / stiffness;
    // Free fall, then half a turn of the spring's circle about the depth of rest.
    let fall = (2.0 * 0.5 / G).sqrt();
    let omega = (stiffness / 2.0).sqrt();
    let touch = (G * fall / omega).atan2(-weight / stiffness);
    sim.step_to(fall + touch / omega).unwrap();
    near(sim.state_of("block").y, -0.5 - depth, 1e-9);
    near(sim.state_of("block").vy, 0.0, 1e-6);
    near(sim.value_of("slot.lower_limit_force"), stiffness * depth, 1e-5);
    sim.step_to(2.0 * (fall + touch / omega)).unwrap();
    near(sim.state_of("block").y, 0.0, 1e-8);
}

/// The jack pushes with 40 N less 10 N of its seals to the end of its stroke, 0.2 m away, and stays there.
#[test]
fn a_jack_stops_at_the_end_of_its_stroke() {
    let mut sim = Limits::new().start_with(Dop853::new(1e-11)).unwrap();
    let arrival = (2.0 * 0.2 * 4.0 / 30.0_f64).sqrt();
    sim.step_to(arrival * 0.5).unwrap();
    near(sim.state_of("rod").x, 20.5 + 0.05, 1e-11);
    near(sim.value_of("ram.friction_force"), -10.0, 1e-12);
    near(sim.value_of("ram.lost"), 10.0 * sim.state_of("rod").vx, 1e-11);
    sim.step_to(arrival - 1e-9).unwrap();
    near(sim.state_of("rod").vx, 30.0 / 4.0 * arrival, 1e-7);
    sim.step_to(arrival + 1.0).unwrap();
    near(sim.state_of("rod").x, 20.7, 1e-12);
    near(sim.state_of("rod").vx, 0.0, 1e-12);
    // How the seals and the end of the stroke share the push is left open: the sum is not.
    near(sim.value_of("ram.upper_limit_force") - sim.value_of("ram.friction_force"), 40.0, 1e-9);
}

/// The pin carries the weight, and brakes by M(omega) = seal + mu m g r with Stribeck's fall and viscous: t = int J domega/M, until it
/// sticks.
#[test]
fn a_pin_brakes_by_stribecks_law() {
    let mut sim = Frictions::new().start_with(Dop853::new(1e-11)).unwrap();
    let load = 3.0 * G * 0.02;
    let moment = |omega: f64| {
        let share = (-(omega / 0.5).powi(2)).exp();
        0.03 + 0.02 * share + (0.2 + 0.3 * share) * load + 0.01 * omega
    };
    // Simpson's rule from `to` to 4 rad/s.
    let time = |to: f64| {
        let (n, h) = (4000, (4.0 - to) / 4000.0);
        let at = |k: usize| 0.02 / moment(to + h * k as f64);
        let inner: f64 = (1..n).map(|k| at(k) * if k % 2 == 1 { 4.0 } else { 2.0 }).sum();
        h / 3.0 * (at(0) + inner + at(n))
    };
    for omega in [2.0, 0.6, 0.1] {
        sim.step_to(time(omega)).unwrap();
        near(sim.state_of("disc").omega, omega, 1e-9);
        near(sim.value_of("axle.friction_torque"), -moment(omega) + 0.01 * omega, 1e-9);
        near(sim.value_of("axle.lost"), moment(omega) * omega, 1e-9);
    }
    sim.step_to(time(0.0) - 1e-7).unwrap();
    assert!(sim.state_of("disc").omega > 0.0);
    sim.step_to(time(0.0) + 1e-7).unwrap();
    near(sim.state_of("disc").omega, 0.0, 1e-13);
    let angle = sim.state_of("disc").angle;
    sim.step_to(60.0).unwrap();
    near(sim.state_of("disc").angle, angle, 1e-13);
}

/// tan 20 deg = 0.364: with a static coefficient of 0.37 the sled holds, and slides as soon as 5 N push; with 0.36 it slides at once.
#[test]
fn a_slide_on_an_incline_holds_or_slides() {
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let mut sim = Frictions::new().start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(0.999).unwrap();
    near(sim.state_of("sled").x, 10.0, 1e-12);
    near(sim.value_of("slope.friction_force"), -2.0 * G * sin, 1e-10);
    sim.step_to(2.0).unwrap();
    let a = G * (sin - 0.3 * cos) + 5.0 / 2.0;
    near((sim.state_of("sled").x - 10.0) / cos, 0.5 * a, 1e-9);
    near(sim.value_of("slope.friction_force"), -0.3 * 2.0 * G * cos, 1e-10);
    let mut sim = Frictions::new().with("slope_friction", 0.29).start_with(Dop853::new(1e-11)).unwrap();
    sim.step_to(1.0).unwrap();
    near((sim.state_of("sled").x - 10.0) / cos, 0.5 * G * (sin - 0.29 * cos), 1e-9);
}

/// A hinge that lets go takes its friction and its limit with it: the wheel falls and turns on evenly.
#[test]
fn friction_and_limits_go_with_their_joint() {
    let mut sim = Frictions::new().start_with(Dop853::new(1e-11)).unwrap();
    let brake = 0.2 * 0.02 * 3.0 * G / 0.02;
    sim.step_to(0.1).unwrap();
    near(sim.state_of("wheel").omega, 4.0 - 0.1 * brake, 1e-10);
    sim.step_to(0.5).unwrap();
    let omega = 4.0 - 0.2 * brake;
    near(sim.state_of("wheel").omega, omega, 1e-10);
    near(sim.state_of("wheel").angle, 0.2 * (4.0 - 0.1 * brake) + 0.3 * omega, 1e-10);
    near(sim.state_of("wheel").y, -0.5 * G * 0.09, 1e-10);
}

/// G is 0.3 m before the middle of a guide of 0.4 m: its ends carry 1.25 and 0.25 times the weight, and rub by their sum.
#[test]
fn a_guide_rubs_at_both_ends() {
    let mut sim = Frictions::new().start_with(Dop853::new(1e-11)).unwrap();
    let brake = 0.25 * 1.5 * G;
    let stop = 3.0 / brake;
    sim.step_to(0.5 * stop).unwrap();
    near(sim.value_of("case.friction_force"), -2.0 * brake, 1e-10);
    near(sim.state_of("drawer").vx, 1.5, 1e-10);
    sim.step_to(stop + 1.0).unwrap();
    near(sim.state_of("drawer").x, 30.3 + 1.5 * stop, 1e-10);
    near(sim.state_of("drawer").vx, 0.0, 1e-13);
}

/// The slot carries the weight: the block is braked by mu g and turns on.
#[test]
fn a_block_rubs_in_its_slot() {
    let mut sim = Frictions::new().start_with(Dop853::new(1e-11)).unwrap();
    let stop = 3.0 / (0.25 * G);
    sim.step_to(0.5 * stop).unwrap();
    near(sim.value_of("slot.friction_force"), -0.25 * 2.0 * G, 1e-11);
    sim.step_to(stop + 1.0).unwrap();
    near(sim.state_of("block").x, 15.0 + 9.0 / (2.0 * 0.25 * G), 1e-10);
    near(sim.state_of("block").vx, 0.0, 1e-13);
    near(sim.state_of("block").omega, 2.0, 1e-12);
}
