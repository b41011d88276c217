//! Conditions that last a small part of a run.

use std::f64::consts::FRAC_PI_2;

use plm_run::AnyMethod;
use plm_runtime::{Fault, Stats};

use crate::text::{By as _, Given as _, Named as _, Scene, scene};

/// Length of the runs, s; the rotor comes down once in it.
pub const RUN: f64 = 10.0;

fn brush() -> Scene {
    scene(include_str!("../declared/brush.plm"))
}

fn clearance() -> Scene {
    scene(include_str!("../declared/clearance.plm"))
}

/// Half the angle within which a condition lasts a part of the run at 1 rad/s, and the height of the tip there.
fn window(part: f64) -> (f64, f64) {
    let half = 0.5 * part * RUN;
    // -cos(half), without what the difference from 1 loses.
    (half, 2.0 * (0.5 * half).sin().powi(2) - 1.0)
}

/// Angle and speed after the run less the known ones, rad and rad/s, in intervals of `interval`, s; and what was done.
///
/// The torque takes a quarter of 0.05 J over the window, which is passed with the mean of the speeds at its ends.
pub fn braked(
    part: f64,
    interval: f64,
    method: impl Into<AnyMethod<Scene>>,
) -> Result<([f64; 2], Stats), Fault> {
    let (half, height) = window(part);
    let declared = brush().with("height", height).with("torque", 0.0125 / (2.0 * half));
    let mut sim = declared.by(method)?;
    for _ in 0..(RUN / interval).round() as u32 {
        sim.step(interval)?;
    }
    let after = 0.75_f64.sqrt();
    let (before, within) = (3.0 * FRAC_PI_2 - half, 2.0 * half / f64::midpoint(1.0, after));
    let angle = 3.0 * FRAC_PI_2 + half + after * (RUN - before - within);
    let rotor = sim.body_of("rotor");
    Ok(([rotor.angle - angle, rotor.omega - after], sim.stats()))
}

/// When a run ends whose tip must stay above the same height, less the known time, s.
pub fn cleared(part: f64, interval: f64) -> Result<Option<f64>, Fault> {
    let (half, height) = window(part);
    let mut sim = clearance().with("height", height).begin()?;
    let ended = (0..(RUN / interval).round() as u32).find_map(|_| sim.step(interval).err());
    Ok(ended.map(|fault| fault.time - (3.0 * FRAC_PI_2 - half)))
}
