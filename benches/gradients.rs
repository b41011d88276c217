//! Runs with derivatives beside runs without: time of each, and what one and eight directions cost.
//!
//! ```text
//! cargo bench --bench gradients
//! ```
#![allow(clippy::panic, reason = "benches")]

#[path = "scenes/chain.rs"]
mod chain;
#[path = "../tests/support/standard.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;

use std::hint::black_box;
use std::time::Instant;

use declared::{s1, s2, s6};
use plm::{By, Dop853, with_derivatives};

chain::chain!(Chain16, 16);

/// Times that every run is made, in turn, so that all see the same machine.
const ROUNDS: u32 = 30;

/// Times of runs of a mechanism by Dop853 at 1e-9 to a time: without derivatives, in one direction, in eight.
macro_rules! runs {
    ($name:literal, $mechanism:expr, $until:literal, $by:expr) => {{
        let mechanism = $mechanism;
        let by: [By<'_>; 8] = $by.map(By::Start);
        let mut best = [f64::INFINITY; 3];
        for _ in 0..ROUNDS {
            let times = [
                time(|| {
                    let mut sim = black_box(mechanism).start_with(Dop853::new(1e-9)).expect("it starts");
                    sim.step_to($until).expect("it runs");
                    black_box(&sim);
                }),
                time(|| {
                    let lifted = with_derivatives(black_box(&mechanism), [by[0]]).expect("it is known");
                    let mut sim = lifted.start_with(Dop853::new(1e-9.into())).expect("it starts");
                    sim.step_to($until.into()).expect("it runs");
                    black_box(&sim);
                }),
                time(|| {
                    let lifted = with_derivatives(black_box(&mechanism), by).expect("it is known");
                    let mut sim = lifted.start_with(Dop853::new(1e-9.into())).expect("it starts");
                    sim.step_to($until.into()).expect("it runs");
                    black_box(&sim);
                }),
            ];
            for (best, time) in best.iter_mut().zip(times) {
                *best = best.min(time);
            }
        }
        let [alone, one, eight] = best;
        println!("{:<10} {:>9.1} {:>6.2} {:>6.2}", $name, 1e6 * alone, one / alone, eight / alone);
    }};
}

fn time(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}

fn main() {
    println!("{:<10} {:>9} {:>6} {:>6}", "scene", "run, us", "one", "eight");
    let of_two = |a, b| [a, b, a, b, a, b, a, b];
    runs!("S1", s1::DoublePendulum::new(), 2.0, of_two("arm.angle", "arm.omega"));
    runs!("S2", s2::FourBar::new(), 2.0, of_two("crank.angle", "crank.omega"));
    runs!("S6", s6::SliderCrank::new(), 2.0, of_two("crank.angle", "crank.omega"));
    runs!("chain 16", Chain16::new(), 1.0, of_two("bar[0].angle", "bar[0].omega"));
}
