//! Moves a chain of 64 bars, and a ladder of ten four-bars over its flat pose, and prints where they are, to the bit. CI
//! builds it with all debug information at opt-level 0 and 3, and compares what the two print.
//!
//! Each runs on a stack that is small beside what full matrices of its constraints would take; one that overflows ends the
//! program.

#[path = "../../../benches/scenes/chain.rs"]
mod chain;
mod ladder;

use std::fmt::Write;
use std::thread;

use plm::runtime::Vector;
use plm::{Fault, Moment, Rk4};

chain::chain!(Chain64, 64);

/// A quarter of what a spawned thread has, as 64 bars are a quarter of 256, and ten four-bars of 40.
const STACK: usize = 512 << 10;
/// The same with optimisation.
const OPTIMISED: usize = STACK / 2;

fn main() -> Result<(), Fault> {
    print!("{}", on_a_small_stack(chain)?);
    print!("{}", on_a_small_stack(ladder)?);
    Ok(())
}

fn chain() -> Result<String, Fault> {
    let mut sim = Chain64::new().start_with(Rk4::new(1e-3))?;
    sim.step(0.02)?;
    Ok(bits(sim.state().x()))
}

/// The bars lie in one line after half a turn of the first: numbers of twice the precision lead over that pose.
fn ladder() -> Result<String, Fault> {
    let mut sim = ladder::Ladder10::new().start()?;
    sim.step(1.0)?;
    assert!(sim.stats().near_singular > 0 && sim.stats().change_points == 1);
    Ok(bits(sim.state().x()))
}

fn bits<X: Vector<f64>>(x: &X) -> String {
    let mut text = String::new();
    for index in 0..X::LEN {
        let _ = writeln!(text, "{:016x}", x.at(index).to_bits());
    }
    text
}

fn on_a_small_stack(run: fn() -> Result<String, Fault>) -> Result<String, Fault> {
    let size = if cfg!(debug_assertions) { STACK } else { OPTIMISED };
    let thread = thread::Builder::new().stack_size(size).spawn(run);
    let outcome = thread.ok().and_then(|thread| thread.join().ok());
    outcome.unwrap_or_else(|| Err(Fault::new(0.0, plm::Cause::NotFinite)))
}
