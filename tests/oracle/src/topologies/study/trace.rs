//! Paths of points of a mechanism from text over a turn of its crank.

use std::ops::ControlFlow;

use plm_dynamic::{Error, Integrator, Mechanism};

use super::chains::Point;

/// Samples of a turn.
pub const SAMPLES: usize = 180;

/// Poses of all bodies, by sample: x, y, m, and angle, rad.
pub type Poses = Vec<Vec<[f64; 3]>>;

/// Compiles a declaration and traces its bodies for a second.
///
/// # Errors
/// The diagnostics of a text that the compiler refuses, or the fault that ends the turn.
pub fn trace(text: &str) -> Result<Poses, Error> {
    let mut run = Mechanism::from_text(text)?.start_with(Integrator::Dop853(1e-9))?;
    let mut poses = Poses::new();
    run.record(1.0, 1.0 / SAMPLES as f64, |sample| {
        poses.push(sample.bodies.iter().map(|body| [body.x, body.y, body.angle]).collect());
        ControlFlow::Continue(())
    })?;
    // The last sample is the first one again.
    poses.truncate(SAMPLES);
    Ok(poses)
}

/// The path of a point, m.
pub fn path(poses: &Poses, point: Point) -> Vec<[f64; 2]> {
    let [px, py] = point.at.map(|coordinate| f64::from(coordinate) / 1e3);
    let place = |bodies: &Vec<[f64; 3]>| {
        let [x, y, angle] = bodies[point.body];
        let (sin, cos) = angle.sin_cos();
        [x + px * cos - py * sin, y + px * sin + py * cos]
    };
    poses.iter().map(place).collect()
}
