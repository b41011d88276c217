//! Eight trajectories side by side, and one by one: time of a Runge-Kutta 4 step of each.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench lanes --features lanes
//! ```
//!
//! Names of scenes behind `--` choose among them. The eight start a hundredth of a radian apart. `formula` is one trajectory without a look at what it does, `sim` one
//! as users run it, `batch` one of eight in a [`Batch`], with the same looks.

#[path = "scenes/chain.rs"]
mod chain;
#[path = "../tests/it/scenes.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;
#[path = "scenes/steps.rs"]
mod steps;

use std::hint::black_box;
use std::time::{Duration, Instant};

use declared::{s1, s2, s5, s6};
use plm::runtime::lanes::Pack;
use plm::{Batch, Rk4};
use steps::{Level, Steps, steps};

chain::chain!(Chain16, 16);

/// Times that everything is measured, in turn, so that all see the same machine.
const ROUNDS: u32 = 40;
/// A measurement is at least this long: some thousand times what reading the clock costs.
const LENGTH: Duration = Duration::from_micros(500);

fn main() {
    println!("ns of a step and trajectory; fused multiply-add: {}", cfg!(feature = "fma"));
    println!(
        "{:<6} {:>9} {:>9} {:>9} {:>14} {:>10}",
        "scene", "formula", "sim", "batch", "formula/batch", "sim/batch"
    );
    table("S1", 1e-3, |turn| {
        let mut mechanism = s1::DoublePendulum::new();
        mechanism.start.arm.angle.value += turn;
        mechanism
    });
    table("S2", 1e-3, |turn| {
        let mut mechanism = s2::FourBar::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    table("S6", 1e-3, |turn| {
        let mut mechanism = s6::SliderCrank::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    table("S5", 1e-5, |turn| {
        let mut mechanism = s5::Andrews::new();
        mechanism.start.k1.angle.value += turn;
        mechanism
    });
    table("chain", 1e-3, |turn| {
        let mut mechanism = Chain16::new();
        mechanism.start.bar_0.angle.value += turn;
        mechanism
    });
}

/// Prints what a step costs in each way.
fn table<M: Pack<S = f64, G = [f64; 0]> + 'static>(name: &str, h: f64, turned: fn(f64) -> M) {
    let chosen: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if !chosen.is_empty() && !chosen.iter().any(|other| other == name) {
        return;
    }
    let mechanisms = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|lane| turned(0.01 * lane));
    let mut all = [
        (1, steps(mechanisms[0], h, Level::Formula)),
        (1, steps(mechanisms[0], h, Level::Sim)),
        (8, batch(&mechanisms, h)),
    ];
    let mut best = [f64::INFINITY; 3];
    let mut number = 16;
    while time(&mut all[2].1, number) < LENGTH {
        number *= 2;
    }
    for _ in 0..ROUNDS {
        for (best, (trajectories, steps)) in best.iter_mut().zip(&mut all) {
            let each = f64::from(number * *trajectories);
            *best = best.min(time(steps, number).as_secs_f64() * 1e9 / each);
        }
    }
    let [formula, sim, batch] = best;
    println!(
        "{name:<6} {formula:>9.1} {sim:>9.1} {batch:>9.1} {:>14.2} {:>10.2}",
        formula / batch,
        sim / batch
    );
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

fn time(steps: &mut Steps, number: u32) -> Duration {
    let begin = Instant::now();
    steps(number);
    begin.elapsed()
}
