//! Loops under extreme data: masses, speeds.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

use plm_run::AnyMethod;
use plm_runtime::{Fault, Stats};

use super::theory;
use crate::text::{By as _, Given as _, Named as _, Scene, scene};

fn swing() -> Scene {
    scene(include_str!("../declared/swing.plm"))
}

fn fast_crank() -> Scene {
    scene(include_str!("../declared/fast_crank.plm"))
}

/// Angle of the swing (rad) from the vertical after 5/4 periods; the known value is 0. And what was done.
pub fn swung(bars: f64, method: impl Into<AnyMethod<Scene>>) -> Result<(f64, Stats), Fault> {
    let mut sim = swing().with("bars", bars).by(method)?;
    sim.step(1.25 * theory::swing_period(bars))?;
    Ok((sim.body_of("left").angle + FRAC_PI_2, sim.stats()))
}

/// Angle of a crank that starts at a speed (rad/s), less that of so many whole turns, rad; and relative change of the energy.
pub fn whirled(speed: f64, turns: u32, method: impl Into<AnyMethod<Scene>>) -> Result<[f64; 2], Fault> {
    let mut sim = fast_crank().with_start("crank.omega", speed).by(method)?;
    let energy = sim.kinetic_energy();
    sim.step(f64::from(turns) * theory::slider_crank_turn(speed, FRAC_PI_3))?;
    Ok([sim.body_of("crank").angle - FRAC_PI_3 - f64::from(turns) * TAU, sim.kinetic_energy() / energy - 1.0])
}
