//! Between the coordinates of a chart and the poses of all bodies.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::joints::coordinates::Coordinates;
use super::motion::solution::measure;
use super::motion::{self, Motion};
use crate::derive::Equations;
use crate::formulate::function::{Function, Place, stored};
use crate::model::Model;

/// Pose and velocity of every body.
pub(super) fn pose(model: &Model, motion: &Motion) -> Function {
    let coordinates = motion.coordinates;
    let (mut q, mut v) = (Vec::new(), Vec::new());
    for body in 0..model.bodies.len() {
        let absolute_angle = coordinates.absolute_angles[body];
        q.push_all(motion.position[body].components());
        q.push(motion.angle(absolute_angle));
        v.push_all(motion.velocity[body].components());
        v.push(motion.omega[absolute_angle.orientation]);
    }
    let mut results = stored("q", q.iter());
    results.extend(stored("v", v.iter()));
    if !motion.solutions.is_empty() {
        results.push((Place::Value, measure(&motion.solutions)));
    }
    Function::of_results(results)
}

/// The coordinates and their rates at a pose.
pub(super) fn from_pose(
    model: &Model,
    equations: &Equations,
    coordinates: &Coordinates,
    independent: &[usize],
) -> Function {
    let values: Vec<Expr> = independent
        .iter()
        .map(|&unknown| motion::of_pose(model, coordinates, coordinates.unknowns[unknown]))
        .collect_vec();
    let mut flow: Vec<(Expr, Expr)> =
        equations.q.iter().copied().zip(equations.v.iter().copied()).collect_vec();
    flow.push((model.time, Expr::ONE));
    let rates = algebra::directionals(&values, &flow);
    Function::of_results(stored("x", values.iter().chain(&rates)))
}
