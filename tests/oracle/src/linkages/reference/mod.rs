//! The reference: slow, in double-double numbers, in absolute coordinates, by Taylor series.
//!
//! It shares nothing with `plm`: no formula, no number type, no method.

pub mod check;
pub mod dd;
mod linear;
mod model;
mod tape;
mod taylor;

use dd::Dd;
use model::Model;
pub use taylor::{Accuracy, Motion, Stop};

use crate::scene::Scene;

/// Start of a scene: guesses of pose and velocity, and the coordinates (3 a body) that are kept.
#[derive(Clone, Debug, Default)]
pub struct Begin {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Coordinates whose place and velocity stay as they are.
    pub locked: Vec<usize>,
}

/// A moment of a motion.
#[derive(Clone, Debug)]
pub struct Sample {
    /// (x, y, theta) of each body.
    pub q: Vec<Dd>,
    pub v: Vec<Dd>,
    /// Kinetic energy and that of gravity, J.
    pub energy: [Dd; 2],
}

/// A motion that was followed.
#[derive(Clone, Debug)]
pub struct Course {
    pub samples: Vec<Sample>,
    pub steps: usize,
}

/// The scene assembled: pose and velocity that satisfy the constraints to all digits.
///
/// # Errors
/// [`Stop::Open`] if no pose or no velocities are found that satisfy the constraints.
pub fn assemble(scene: &Scene, begin: &Begin) -> Result<(Vec<Dd>, Vec<Dd>), Stop> {
    let mut model = Model::new(scene);
    let mut weights = vec![Dd::ONE; model.inverse.len()];
    begin.locked.iter().for_each(|index| weights[*index] = Dd::ZERO);
    let mut q: Vec<Dd> = begin.q.iter().map(|q| Dd::from(*q)).collect();
    let mut gap = f64::INFINITY;
    for _ in 0..60 {
        model.pose(&q);
        gap = model.correct_pose(&weights, &mut q);
        if !(gap > 1e-29 * model.size) {
            break;
        }
    }
    if !(gap < 1e-24 * model.size) {
        return Err(Stop::Open);
    }
    model.pose(&q);
    let mut v: Vec<Dd> = begin.v.iter().map(|v| Dd::from(*v)).collect();
    let mut most = 0.0;
    for _ in 0..3 {
        most = model.correct_velocity(&weights, &mut v);
    }
    let fastest = v.iter().fold(1.0_f64, |fastest, v| fastest.max(v.hi.abs()));
    if !(most < 1e-20 * fastest) {
        return Err(Stop::Open);
    }
    Ok((q, v))
}

/// The motion from an assembled state, sampled at `times`.
///
/// # Errors
/// [`Stop::Creeps`] if steps become too short or too many.
pub fn follow(
    scene: &Scene,
    (q, v): (Vec<Dd>, Vec<Dd>),
    times: &[f64],
    accuracy: Accuracy,
) -> Result<Course, Stop> {
    let model = Model::new(scene);
    let first = model.energy(&q, &v);
    let mut samples = vec![Sample { q: q.clone(), v: v.clone(), energy: first }];
    let mut motion = Motion::new(model, accuracy, q, v);
    let mut next = times.iter().copied().filter(|time| *time > 0.0).peekable();
    motion.advance(times.last().copied().unwrap_or(0.0), |motion, end| {
        while let Some(time) = next.next_if(|time| *time <= end) {
            let (q, v) = motion.at(time);
            let energy = motion.model.energy(&q, &v);
            samples.push(Sample { q, v, energy });
        }
    })?;
    Ok(Course { samples, steps: motion.steps })
}

/// Energy of the joints' springs at a pose, J.
pub fn spring_energy(scene: &Scene, q: &[Dd]) -> Dd {
    let mut model = Model::new(scene);
    model.pose(q);
    model.spring_energy()
}
