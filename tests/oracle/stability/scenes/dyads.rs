//! A dyad that comes to its own limit, while the loop before it could go on.

use plm_run::AnySim;
use plm_runtime::{Dop853, Fault, Moment as _};

use super::run::{Trace, trace};
use crate::text::{By as _, Named as _, Scene, absolute, scene};

const STEPHENSON: &str = include_str!("../declared/stephenson.plm");

pub fn stephenson() -> Scene {
    scene(STEPHENSON)
}

/// Energy (relative change), angles of crank and arm (rad), and the sine between link and arm, which changes sign
/// where they stretch.
pub fn leading(sim: &mut AnySim<Scene>, until: f64) -> Trace<4> {
    let energy = sim.kinetic_energy() + sim.gravity_energy();
    trace(sim, until, 2e-4, |s| {
        let (link, arm) = (s.body_of("link").angle, s.body_of("arm").angle);
        [
            (s.kinetic_energy() + s.gravity_energy()) / energy - 1.0,
            s.body_of("crank").angle,
            arm,
            (link - arm).sin(),
        ]
    })
}

/// Largest difference of an angle from absolute coordinates, rad, both at a tolerance of 1e-11.
pub fn apart(until: f64) -> Result<f64, Fault> {
    let mut sim = stephenson().by(Dop853::new(1e-11))?;
    let mut other = scene(&absolute(STEPHENSON)).by(Dop853::new(1e-11))?;
    let mut largest = 0.0_f64;
    while sim.time() < until {
        sim.step(0.01)?;
        other.step(0.01)?;
        let pairs = ["crank", "rocker", "arm"].map(|bar| (sim.body_of(bar), other.body_of(bar)));
        largest = pairs.iter().fold(largest, |largest, (a, b)| largest.max((a.angle - b.angle).abs()));
    }
    Ok(largest)
}
