//! Tasks with what catches, knocks and stops.

use std::f64::consts::TAU;

use super::{G, check};

/// The crank lifts 80 kg and the inertia of the pinion evenly; let go, they rise on and fall back to the last of teeth of 18 deg.
#[test]
fn a_jack_with_a_ratchet_and_a_latch() {
    let (mass, radius, crank, time) = (80.0, 0.06, 60.0, 0.3);
    let moved = mass + 2e-3 / (radius * radius);
    let lifted = 0.5 * (crank / radius - mass * G) / moved * time * time;
    let speed = 2.0 * lifted / time;
    let top = lifted + speed * speed / (2.0 * mass * G / moved);
    let tooth = TAU / 20.0 * radius;
    let held = (top / tooth).floor() * tooth;
    assert!(held + lifted > 0.2);
    check(
        "latch",
        &[
            ("the crank is let go at", lifted * 1e3, 1e-7),
            ("the pawl holds at", held * 1e3, 1e-7),
            ("the pawl bears", mass * G * radius, 1e-8),
            ("the latch holds at", 200.0, 1e-7),
            ("the latch bears", mass * G, 1e-7),
            ("it lets go, turned down by", ((1000.0 - mass * G) * radius * 10.0).ceil() / 10.0, 1e-9),
        ],
    );
}

/// The yoke takes the ram along until it is fastest, at 90 deg. Then the ram flies on evenly, and the yoke falls behind by
/// a (p - sin p) while its crank turns by p: at twice the clearance the pin strikes.
#[test]
fn a_pin_with_play() {
    let (a, mass, turn) = (0.05, 20.0, 0.2);
    let speed = TAU / turn;
    let mut p = 0.3_f64;
    for _ in 0..20 {
        p -= (a * (p - p.sin()) - 0.2e-3) / (a * (1.0 - p.cos()));
    }
    let strike = a * speed * (1.0 - p.cos());
    check(
        "clearance",
        &[
            ("the crank stands at", 90.0 + p.to_degrees(), 1e-6),
            ("the pin strikes with", strike, 1e-8),
            ("impulse of a knock", mass * strike, 1e-7),
            ("knocks in two turns", 4.0, 0.0),
            ("power of the knocks", 2.0 * 0.5 * mass * strike * strike / turn, 1e-7),
            ("greatest force between knocks", mass * a * speed * speed, 1e-5),
        ],
    );
}

/// The stop feels I/r^2 of the door on a spring and a damper. It spares the hinges at the centre of percussion, 2/3 of the width.
#[test]
fn a_door_at_its_stop() {
    let (mass, width, inertia) = (25.0, 0.9, 25.0 * 0.81 / 3.0);
    let (stiffness, damping) = (1e6, 2e3);
    let strike = |reach: f64| {
        let (felt, speed) = (inertia / (reach * reach), 2.0 * reach);
        let beta = 0.5 * damping / felt;
        let omega = (stiffness / felt - beta * beta).sqrt();
        let end = (std::f64::consts::PI - 2.0 * (beta / omega).atan()) / omega;
        let force = |t: f64| {
            let (sin, cos) = (omega * t).sin_cos();
            let decay = speed * (-beta * t).exp();
            stiffness * decay * sin / omega + damping * decay * (cos - beta / omega * sin)
        };
        let most = (0..=10_000).map(|k| force(end * f64::from(k) / 1e4)).fold(0.0, f64::max);
        let hinge = most * (1.0 - 0.5 * mass * width * reach / inertia);
        [most, hinge.abs(), 2.0 * (-beta * end).exp()]
    };
    let ([stop, spared, back], [handle, hinge, _]) = (strike(0.6), strike(0.85));
    check(
        "door_stop",
        &[
            ("force of the stop at 0.60 m", stop, 1e-4 * stop),
            ("force across the hinges then", spared, 1e-6),
            ("the door comes back with", back, 1e-4),
            ("force of the stop at 0.85 m", handle, 1e-4 * handle),
            ("force across the hinges there", hinge, 1e-4 * hinge),
        ],
    );
}
