//! Times of a step of `Rk4`: interpreted from text, over compiled by rustc. `cargo run --release -p plm-dynamic --example speed`
//! prints a line for each mechanism; ratios of one run are what counts.
#![allow(unused_qualifications, unreachable_pub, missing_docs, reason = "emitted code")]

#[path = "../../tests/snapshots/double_pendulum.rs"]
mod double_pendulum;
#[path = "../../tests/snapshots/driven_crank.rs"]
mod driven_crank;
#[path = "../../tests/snapshots/four_bar.rs"]
mod four_bar;

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use plm::Rk4;
use plm::runtime::{Described, Mechanism};
use plm_dynamic::{Compiled, Dynamic};

const STEPS: u32 = 2000;

/// The least time of a step of ten runs, ns.
fn time<M: Mechanism<S = f64>>(mechanism: M) -> Result<f64, plm::Fault> {
    let mut least = f64::INFINITY;
    for _ in 0..10 {
        let mut sim = mechanism.start_with(Rk4::new(1e-4))?;
        let begin = Instant::now();
        sim.step(1e-4 * f64::from(STEPS))?;
        least = least.min(begin.elapsed().as_secs_f64() * 1e9 / f64::from(STEPS));
        black_box(sim.state());
    }
    Ok(least)
}

fn compare<M: Described<S = f64>>(name: &str, mechanism: M) -> Result<(), Box<dyn Error>> {
    let begin = Instant::now();
    let dynamic: Dynamic<f64, 24, 32, 64> = Compiled::new(name, M::DECLARATION)?.mechanism()?;
    let ready = begin.elapsed().as_secs_f64() * 1e3;
    let (compiled, interpreted) = (time(mechanism)?, time(dynamic)?);
    println!(
        "{name}: text to mechanism {ready:.0} ms; a step {interpreted:.0} ns, compiled {compiled:.0} ns, ratio {:.1}",
        interpreted / compiled
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    compare("double pendulum", double_pendulum::DoublePendulum::new())?;
    compare("four-bar", four_bar::FourBar::new())?;
    compare("driven crank", driven_crank::DrivenCrank::new())
}
