//! The README's four-bar linkage: what turns its crank, and the page of which `docs/hero.sh` makes the README's moving pictures.
//!
//! ```sh
//! cargo run --release -p plm-program --example four_bar    # prints the README's figures and writes target/plm/four_bar.html
//! ```
#![allow(missing_docs, reason = "the macro declares a public module")]

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! { pub FourBar {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) cm; port d: (30, 0) cm; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 10 cm); port a: (-5, 0) cm; port b: (5, 0) cm; }
    body coupler { mass: 3 kg; inertia: 0.04 kg*m^2;
        port b: (-14, 0) cm; port c: (14, 0) cm; port tip: (0, 15) cm; }
    body rocker { mass: 2 kg; inertia: rod(2 kg, 25 cm);
        port c: (12.5, 0) cm; port d: (-12.5, 0) cm; start angle: 110 deg; }
    revolute pin_a(ground.a, crank.a);
    revolute pin_b(crank.b, coupler.b);
    revolute pin_c(coupler.c, rocker.c);
    revolute pin_d(ground.d, rocker.d);
    constraint motor: crank.angle = 1 rev/s*t;
    output coupler.tip.position in cm, torque = -reaction(motor);
    output pin_a.force, pin_b.force, pin_c.force, pin_d.force;
}}

/// What the README shows: a quarter of a turn from the start.
///
/// # Errors
/// A fault of the run.
pub fn quarter() -> Result<String, plm::Fault> {
    let mut sim = FourBar::new().start()?;
    sim.step(0.25)?;
    let ([x, y], torque) = (sim.coupler_tip_position(), sim.torque());
    Ok(format!("tip at ({x:.4}, {y:.4}) m, torque {torque:.4} N m"))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}", quarter()?);
    let options = Options::from_args()?;
    Program::new(FourBar::new()).until(2.0).every(0.01).with(&options)
}
