//! Ropes: block and tackle, winch, capstan, a rope that gives way.

use plm::{Dop853, Mechanism as _, Sim};

use crate::declared::Ropes;
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

const G: f64 = 9.81;

fn started(ropes: &Scene) -> Sim<Scene> {
    ropes.start_with(Dop853::new(1e-11)).unwrap()
}

/// Tackle and winch stand still.
fn calm(heavy: f64) -> Scene {
    Ropes::new().with("counter", 2.0).with("heavy", heavy).with("hoisting", 9.81)
}

/// The block is pulled twice, the weight once: a = (2 m - M) g/(M + 4 m), T = 3 M m g/(M + 4 m).
#[test]
fn a_tackle_pulls_twice() {
    for weight in [1.0, 2.0, 2.5] {
        let mut sim = started(&Ropes::new().with("counter", weight));
        sim.step_to(0.4).unwrap();
        near(sim.value_of("block.vy"), 0.4 * (2.0 * weight - 4.0) * G / (4.0 + 4.0 * weight), 1e-9);
        near(sim.value_of("weight.vy"), -2.0 * sim.value_of("block.vy"), 1e-9);
        near(sim.value_of("tackle.tension"), 12.0 * weight * G / (4.0 + 4.0 * weight), 1e-9);
    }
}

/// A block that is thrown up leaves the rope slack: both fall freely. After that the rope becomes taut by an impact, in which the momenta go by 2
/// to 1 and its ends have one speed.
#[test]
fn a_rope_pulls_only() {
    // The weight rests on the rope at the start; a start with a slack that opens is no impact.
    let mut ropes = Ropes::new().with("counter", 2.0);
    ropes = ropes.with_start("block.vy", 1.0);
    let mut sim = started(&ropes);
    sim.step_to(0.1).unwrap();
    near(sim.value_of("tackle.tension"), 0.0, 0.0);
    near(sim.value_of("block.vy"), 1.0 - 0.1 * G, 1e-9);
    near(sim.value_of("weight.vy"), -0.1 * G, 1e-9);
    // Slack: 2 (t - g t^2/2) - g t^2/2 = 0.
    let taut = 4.0 / (3.0 * G);
    near(sim.value_of("tackle.slack"), 0.2 - 1.5 * G * 0.01, 1e-9);
    let (block, weight) = (1.0 - G * taut, -G * taut);
    sim.step_to(taut + 1e-6).unwrap();
    // Impulse J: 4 dv = 2 J, 2 dw = J, and 2 v + w = 0 after.
    let impulse = -(2.0 * block + weight) / (2.0 * 2.0 / 4.0 + 1.0 / 2.0);
    near(sim.value_of("block.vy"), block + impulse / 2.0, 1e-5);
    near(sim.value_of("weight.vy"), weight + impulse / 2.0, 1e-5);
}

/// The jumper comes as deep as m g (l + x) = c x^2/2.
#[test]
fn an_elastic_rope_catches_what_falls() {
    let mut sim = started(&calm(3.0));
    let (weight, stiffness) = (70.0 * G, 100.0);
    let deepest = (weight + (weight * weight + 2.0 * stiffness * weight * 9.5).sqrt()) / stiffness;
    // Free fall by 9.5 m, then from the middle of a swing.
    let fallen = (2.0 * 9.5 / G).sqrt();
    let rate = (stiffness / 70.0_f64).sqrt();
    let (speed, rest) = (G * fallen, weight / stiffness);
    sim.step_to(fallen - 1e-6).unwrap();
    near(sim.value_of("bungee.tension"), 0.0, 0.0);
    let lowest = fallen + (std::f64::consts::PI - (speed / rate / rest).atan()) / rate;
    sim.step_to(lowest).unwrap();
    near(sim.value_of("jumper.vy"), 0.0, 1e-6);
    near(sim.value_of("bungee.elongation"), deepest, 1e-7);
    near(sim.value_of("bungee.tension"), stiffness * deepest, 1e-5);
    near(sim.value_of("bungee.energy"), stiffness * deepest * deepest / 2.0, 1e-4);
    near(sim.value_of("bungee.lost"), 0.0, 1e-9);
}

/// exp(0.25 3/2 pi) = 3.248: 3 kg are held by 1 kg, and 4 kg run with g (M - m r)/(M + m r).
#[test]
fn a_capstan_holds_and_slips_by_euler_and_eytelwein() {
    let ratio = (0.25 * 1.5 * std::f64::consts::PI).exp();
    let mut held = started(&calm(3.0));
    held.step_to(2.0).unwrap();
    near(held.value_of("load.y"), 2.0, 1e-12);
    near(held.value_of("turns.tension_near"), 3.0 * G, 1e-9);
    near(held.value_of("turns.tension_far"), G, 1e-9);
    near(held.value_of("turns.torque"), -0.05 * 2.0 * G, 1e-9);
    for heavy in [4.0, 0.2] {
        let mut sim = started(&calm(heavy));
        sim.step_to(0.3).unwrap();
        let ratio = if heavy > 1.0 { ratio } else { 1.0 / ratio };
        let fall = G * (heavy - ratio) / (heavy + ratio);
        near(sim.value_of("load.vy"), -0.3 * fall, 1e-9);
        near(sim.value_of("turns.tension_near"), ratio * sim.value_of("turns.tension_far"), 1e-9);
        near(sim.value_of("turns.speed"), 0.3 * fall, 1e-9);
        near(
            sim.value_of("turns.lost"),
            (ratio - 1.0) * sim.value_of("turns.tension_far") * 0.3 * fall,
            1e-8,
        );
    }
}

/// 30 N m lift 10 kg by a drum of 0.1 m and 0.5 kg m^2: (30 - 0.981 10)/(0.5 + 0.1) rad/s^2.
#[test]
fn a_winch_lifts() {
    let mut sim = started(&Ropes::new());
    sim.step_to(0.2).unwrap();
    let alpha = (30.0 - 9.81) / 0.6;
    near(sim.value_of("drum.speed"), 0.2 * alpha, 1e-9);
    near(sim.value_of("crate.vy"), 0.02 * alpha, 1e-9);
    near(sim.value_of("lift.speed"), 0.02 * alpha, 1e-9);
    near(sim.value_of("hoist.tension"), 10.0 * (G + 0.1 * alpha), 1e-8);
}
