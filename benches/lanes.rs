//! Eight trajectories side by side, and one by one: time of a Runge-Kutta 4 step of each.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench lanes --features lanes
//! ```
//!
//! Names of scenes after `--` choose among them. The eight start a hundredth of a radian apart. `formula` is one trajectory
//! without a look at what it does, `sim` one as users run it, `batch` one of eight in a [`Batch`], with the same looks.
//! `hand` is one of eight in a kernel that is written by hand (benches/kernels/), without a look, and none for the chain.
//! After these come steps of Moreau and Jean of mechanisms with contact, each by a simulation and by a batch.
//! `instructions` after `--` counts instructions instead, by valgrind.
#![allow(clippy::panic, reason = "benches")]

#[path = "scenes/chain.rs"]
mod chain;
#[path = "../examples/firmware/src/contact.rs"]
mod contact;
#[path = "scenes/count.rs"]
mod count;
#[path = "../tests/support/standard.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;
#[path = "scenes/steps.rs"]
mod steps;
#[path = "kernels/mod.rs"]
#[allow(dead_code, unused_imports)] // The bench of kernels uses more of it.
mod written;

use std::hint::black_box;
use std::time::{Duration, Instant};

use declared::{s1, s2, s5, s6};
use plm::runtime::lanes::Pack;
use plm::{Batch, MoreauJean, Rk4};
use steps::{Level, Steps, steps};

chain::chain!(Chain16, 16);

/// Times that every way is measured, in turn, so that all see the same machine.
const ROUNDS: u32 = 40;
/// Steps of a measurement, always the same: the longer a slider-crank accelerates, the more often its loop is looked at.
const STEPS: u32 = 1000;

fn main() {
    if count::counted(|name, who| scene(name).steps(who)) {
        return;
    }
    let (counts, names): (Vec<_>, Vec<_>) =
        count::arguments().into_iter().partition(|argument| argument == "instructions");
    let (unit, measure): (_, fn(&Scene) -> [f64; 4]) =
        if counts.is_empty() { ("ns", times) } else { ("instructions", instructions) };
    println!("{unit} of a step and trajectory; fused multiply-add: {}", cfg!(feature = "fma"));
    let [formula, sim, batch, hand] = WAYS;
    println!(
        "{:<8} {formula:>9} {sim:>9} {batch:>9} {hand:>9} {:>14} {:>10} {:>11}",
        "scene", "formula/batch", "sim/batch", "batch/hand"
    );
    for name in SCENES.into_iter().filter(|name| names.is_empty() || names.iter().any(|other| other == name))
    {
        let [formula, sim, batch, hand] = measure(&scene(name));
        print!("{name:<8} {formula:>9.1} {sim:>9.1} {batch:>9.1} ");
        let ratios = format!("{:>14.2} {:>10.2}", formula / batch, sim / batch);
        match written::named(name).lanes {
            Some(_) => println!("{hand:>9.1} {ratios} {:>11.2}", batch / hand),
            None => println!("{:>9} {ratios} {:>11}", "-", "-"),
        }
    }
    if counts.is_empty() && (names.is_empty() || names.iter().any(|name| name == "contact")) {
        println!("{:<22} {:>9} {:>9} {:>10}", "Moreau and Jean", "sim", "batch", "sim/batch");
        strides("four-bar with limits", |turn| {
            let mut mechanism = contact::Limits::new();
            mechanism.start.crank.angle.value += turn;
            mechanism
        });
        strides("rack with backlash", |turn| {
            let mut mechanism = contact::Rack::new();
            mechanism.start.pinion.omega.value += 100.0 * turn;
            mechanism
        });
        strides("ratchet", |turn| {
            let mut mechanism = contact::Ratchet::new();
            mechanism.start.wheel.omega.value += 10.0 * turn;
            mechanism
        });
    }
}

/// Times of a step of Moreau and Jean and trajectory, by eight simulations and by one batch of them.
fn strides<M: Pack<S = f64> + 'static>(name: &str, turned: fn(f64) -> M) {
    const H: f64 = 1e-3;
    let mechanisms = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|lane| turned(0.01 * lane));
    let sims = mechanisms.map(|one| one.start_with(MoreauJean::new(H)).expect("it can be assembled"));
    let alone: Steps = Box::new(move |steps| {
        for mut sim in black_box(sims) {
            sim.step(f64::from(steps) * H).expect("it can be moved");
            black_box(&sim);
        }
    });
    let start = Batch::new(sims);
    let together: Steps = Box::new(move |steps| {
        let mut batch = start;
        for outcome in batch.step(f64::from(steps) * H) {
            outcome.expect("it can be moved");
        }
        black_box(&batch);
    });
    let [sim, batch] = best([alone, together]).map(|best| best / 8.0);
    println!("{name:<22} {sim:>9.1} {batch:>9.1} {:>10.2}", sim / batch);
}

/// The ways that a step is made.
const WAYS: [&str; 4] = ["formula", "sim", "batch", "hand"];
const SCENES: [&str; 5] = ["S1", "S2", "S6", "S5", "chain 16"];

/// A mechanism with its steps.
struct Scene {
    name: &'static str,
    /// The steps of a way.
    steps: Box<dyn Fn(&str) -> Steps>,
}

impl Scene {
    /// Of mechanisms that start turned by an angle, in rad.
    fn new<M: Pack<S = f64, G = [f64; 0]> + 'static>(
        name: &'static str,
        h: f64,
        turned: fn(f64) -> M,
    ) -> Self {
        let mechanisms = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|lane| turned(0.01 * lane));
        let steps = move |way: &str| match way {
            "formula" => steps(mechanisms[0], h, Level::Formula),
            "sim" => steps(mechanisms[0], h, Level::Sim),
            "batch" => batch(&mechanisms, h),
            _ => written::named(name).lanes.map_or_else(|| -> Steps { Box::new(|_| ()) }, |lanes| lanes(h)),
        };
        Self { name, steps: Box::new(steps) }
    }

    fn steps(&self, way: &str) -> Steps {
        (self.steps)(way)
    }
}

/// The scene of a name.
fn scene(name: &str) -> Scene {
    match name {
        "S1" => Scene::new("S1", 1e-3, |turn| {
            let mut mechanism = s1::DoublePendulum::new();
            mechanism.start.arm.angle.value += turn;
            mechanism
        }),
        "S2" => Scene::new("S2", 1e-3, |turn| {
            let mut mechanism = s2::FourBar::new();
            mechanism.start.crank.angle.value += turn;
            mechanism
        }),
        "S6" => Scene::new("S6", 1e-3, |turn| {
            let mut mechanism = s6::SliderCrank::new();
            mechanism.start.crank.angle.value += turn;
            mechanism
        }),
        "S5" => Scene::new("S5", 1e-5, |turn| {
            let mut mechanism = s5::Andrews::new();
            mechanism.start.k1.angle.value += turn;
            mechanism
        }),
        _ => Scene::new("chain 16", 1e-3, |turn| {
            let mut mechanism = Chain16::new();
            mechanism.start.bar_0.angle.value += turn;
            mechanism
        }),
    }
}

/// Of a step and trajectory.
fn instructions(scene: &Scene) -> [f64; 4] {
    WAYS.map(|way| count::per_step(scene.name, way) / trajectories(way))
}

/// How many trajectories a step moves.
fn trajectories(way: &str) -> f64 {
    if matches!(way, "batch" | "hand") { 8.0 } else { 1.0 }
}

/// Times of a step and trajectory, ns.
fn times(scene: &Scene) -> [f64; 4] {
    let mut best = best(WAYS.map(|way| scene.steps(way)));
    for (best, way) in best.iter_mut().zip(WAYS) {
        *best /= trajectories(way);
    }
    best
}

/// The best of many times of a step, ns, the ways in turn, so that all see the same machine.
fn best<const N: usize>(mut all: [Steps; N]) -> [f64; N] {
    let mut best = [f64::INFINITY; N];
    for _ in 0..ROUNDS {
        for (best, steps) in best.iter_mut().zip(&mut all) {
            *best = best.min(time(steps).as_secs_f64() * 1e9 / f64::from(STEPS));
        }
    }
    best
}

/// Steps of eight mechanisms side by side.
fn batch<M: Pack<S = f64, G = [f64; 0]> + 'static>(mechanisms: &[M; 8], h: f64) -> Steps {
    let start = Batch::start(mechanisms, Rk4::new(h)).expect("the mechanisms can be assembled");
    Box::new(move |steps| {
        let mut batch = start;
        for outcome in batch.step(f64::from(steps) * h) {
            outcome.expect("the mechanisms can be moved");
        }
        black_box(&batch);
    })
}

fn time(steps: &mut Steps) -> Duration {
    let begin = Instant::now();
    steps(STEPS);
    begin.elapsed()
}
