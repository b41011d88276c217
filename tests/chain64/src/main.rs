//! Moves a chain of 64 bars and prints where it is, to the bit. CI builds it with all debug information at opt-level 0
//! and 3, and compares what the two print.

#[path = "../../../benches/scenes/chain.rs"]
mod chain;

use plm::runtime::Vector;
use plm::{Moment, Rk4};

chain::chain!(Chain64, 64);

fn main() -> Result<(), plm::Fault> {
    let mut sim = Chain64::new().start_with(Rk4::new(1e-3))?;
    sim.step(0.02)?;
    let x = sim.state().x();
    for index in 0..x.len() {
        println!("{:016x}", x.at(index).to_bits());
    }
    Ok(())
}
