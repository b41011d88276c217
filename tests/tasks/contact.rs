//! Tasks with friction and impact.

use std::f64::consts::TAU;

use super::{G, check};

/// Uphill a block loses g (sin + mu cos), downhill it gains g (sin - mu cos); it stays where tan < mu_0.
#[test]
fn a_block_on_a_slope() {
    let (mass, speed, mu) = (5.0, 3.0, 0.3);
    let up = |angle: f64| {
        let loss = G * (angle.sin() + mu * angle.cos());
        [speed / loss, speed * speed / (2.0 * loss)]
    };
    let (gentle, steep) = (20_f64.to_radians(), 30_f64.to_radians());
    let ([gentle_time, gentle_way], [steep_time, steep_way]) = (up(gentle), up(steep));
    assert!(gentle.tan() < 0.4 && steep.tan() > 0.4);
    let gain = G * (steep.sin() - mu * steep.cos());
    check(
        "incline",
        &[
            ("20 deg: slides up for", gentle_time, 1e-9),
            ("20 deg: comes to rest at", gentle_way, 1e-9),
            ("20 deg: is held by", mass * G * gentle.sin(), 1e-9),
            ("30 deg: slides up for", steep_time, 1e-9),
            ("30 deg: is back at", steep_time + (2.0 * steep_way / gain).sqrt(), 1e-9),
            ("30 deg: with a speed of", (2.0 * steep_way * gain).sqrt(), 1e-9),
        ],
    );
}

/// While it rolls, T = a r (m + J/r^2); it slips where m a exceeds mu_0 m g, and then the road gives mu m g.
#[test]
fn a_driven_wheel() {
    let (mass, inertia, radius, rise) = (320.0, 0.9, 0.3, 400.0);
    let (mu, still) = (0.7, 0.9);
    let felt = radius * (mass + inertia / (radius * radius));
    let torque = still * G * felt;
    let time = torque / rise;
    let speed = rise * time * time / (2.0 * felt);
    let left = 3.0 - time;
    let later = speed + mu * G * left;
    let turning =
        speed / radius + (0.5 * rise * (9.0 - time * time) - mu * mass * G * radius * left) / inertia;
    check(
        "wheel",
        &[
            ("slips from a torque of", torque, 1e-8),
            ("at a speed of", speed, 1e-9),
            ("speed after 3 s", later, 1e-7),
            ("slip after 3 s", radius * turning - later, 1e-5),
            ("traction after 3 s", mu * mass * G, 1e-8),
        ],
    );
}

/// On the cam the force is k (y - y_0) + m y''; a valve that flies swings about the place where its spring is free.
#[test]
fn a_valve_on_its_cam() {
    let (mass, stiffness, lift): (f64, f64, f64) = (0.2, 20e3, 4e-3);
    let stretched = |angle: f64| 0.01 + lift * (1.0 - angle.cos());
    let force =
        |speed: f64, angle: f64| stiffness * stretched(angle) + mass * lift * speed * speed * angle.cos();
    let samples = |speed: f64| (0..).map(|k| f64::from(k) * 1e-5).take_while(move |t| speed * t < TAU);
    let least = samples(600.0).map(|t| force(600.0, 600.0 * t)).fold(f64::INFINITY, f64::min);
    let speed = 750.0;
    let inertial = mass * lift * speed * speed;
    let leaves = (-(stiffness * lift + stiffness * 0.01) / (inertial - stiffness * lift)).acos();
    let (place, velocity, rate) = (stretched(leaves), lift * leaves.sin() * speed, (stiffness / mass).sqrt());
    let gap = |t: f64| {
        let (sin, cos) = (rate * (t - leaves / speed)).sin_cos();
        place * cos + velocity / rate * sin - stretched(speed * t)
    };
    let flight = samples(speed).filter(|t| speed * t > leaves);
    let highest = flight.map(gap).take_while(|gap| *gap > 0.0).fold(0.0, f64::max);
    check(
        "cam",
        &[
            ("600 rad/s: least force", least, 1e-6),
            ("750 rad/s: lifts off at", leaves.to_degrees(), 1e-5),
            ("750 rad/s: flies as high as", 1000.0 * highest, 1e-6),
        ],
    );
}

/// A pin takes mu r m g; both ends of a guide press with F e/L, so that a drawer jams beside its guide from L/(2 mu) on.
#[test]
fn friction_in_joints() {
    let (torque, inertia, speed) = (0.12 * 0.01 * 8.0 * G, 0.5 * 8.0 * 0.04, 100.0 * TAU / 60.0);
    let friction = |offset: f64| 0.3 * f64::max(2.0 * G, 2.0 * 60.0 * offset / 0.15);
    assert!(friction(0.26) > 60.0 && friction(0.24) < 60.0);
    check(
        "joint_friction",
        &[
            ("friction of the pin", torque, 1e-12),
            ("the wheel stops after", inertia * speed / torque, 1e-8),
            ("turns until then", 0.5 * inertia * speed * speed / torque / TAU, 1e-8),
            ("acceleration of the drawer, pulled 100 mm beside", (60.0 - friction(0.1)) / 2.0, 1e-9),
            ("acceleration, pulled 260 mm beside", 0.0, 1e-9),
        ],
    );
}

/// Torques about the pivot of a finger: the pin of the slide, the part's side, and half the part's weight while friction holds it.
#[test]
fn a_gripper() {
    let (slide, part, mu) = (0.3, 1.0, 0.4);
    let pin = |pull: f64| 0.5 * (pull - slide * G);
    let half = 0.5 * part * G;
    let strong = (20.0 * pin(150.0) - 10.0 * half) / 80.0;
    let weak = 20.0 * pin(80.0) / (80.0 + 10.0 * mu);
    assert!(half < mu * strong && half > mu * weak);
    let limit = 2.0 * (80.0 * half / mu + 10.0 * half) / 20.0 + slide * G;
    check(
        "gripper",
        &[
            ("a pad presses with, at 150 N", strong, 1e-9),
            ("the part is held from a pull of", limit, 1e-6),
            ("a pad presses with, at 80 N", weak, 1e-9),
            ("the part falls then with", G - 2.0 * mu * weak / part, 1e-9),
        ],
    );
}

/// A ball comes back to e^2 of its height; all bounces last (1 + e)/(1 - e) times the first fall. Flights of 1000 roundings of a metre
/// are none: they begin with v = 2 um/s, and would take 2 v/(g (1 - e)) = 2 us.
#[test]
fn a_ball() {
    let (height, e) = (1.0, 0.8);
    let fall: f64 = (2.0 * height / G).sqrt();
    check(
        "bounce",
        &[
            ("height after the first bounce", e * e * height, 1e-9),
            ("height after the second bounce", e * e * e * e * height, 1e-9),
            ("lies still from", fall * (1.0 + e) / (1.0 - e), 3e-6),
            ("presses on the floor with", 0.6 * G, 1e-9),
        ],
    );
}

/// The foot stops at once, the leg springs back and is pushed on its way out; its end takes the foot along by an impact. The push begins
/// at 1 mm/s, 10 nm above the lowest point.
#[test]
fn a_hopper() {
    let (hull, foot, stiffness, preload, thrust) = (4.0, 0.5, 2000.0, 50.0, 40.0);
    let jump = |height: &f64| {
        let square = 2.0 * G * height;
        let pressed = hull * G - preload;
        let shorter = (pressed + (pressed * pressed + stiffness * hull * (square - 1e-6)).sqrt()) / stiffness;
        let leaves: f64 = (square + 2.0 * thrust * shorter / hull).sqrt() * hull / (hull + foot);
        Some(leaves * leaves / (2.0 * G))
    };
    let heights: Vec<f64> = std::iter::successors(Some(0.3), jump).take(11).collect();
    check(
        "hopper",
        &[
            ("first jump", heights[1], 1e-9),
            ("second jump", heights[2], 1e-9),
            ("tenth jump", heights[10], 1e-8),
        ],
    );
}
