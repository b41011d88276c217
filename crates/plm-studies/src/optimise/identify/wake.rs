//! Unknowns that readings do not change with where they stand, but do beside it.
//!
//! A restitution of zero, the friction of a load that is none, a stiffness of what is not stretched: there the derivative vanishes, and no
//! step of a search leaves the place.

use nalgebra::DVector;
use plm_runtime::Fault;

use super::problem::Readings;
use super::statistics::NO_EFFECT;
use crate::optimise::least_squares::{Evaluation, Found, Limits, Problem, minimise};
use crate::optimise::mechanism::{Integration, Optimisable};

/// Parts of the size of an unknown by which it is moved to see whether readings change with it there.
const MOVES: [f64; 8] = [0.1, -0.1, 1.0, -1.0, 0.5, -0.5, 0.01, -0.01];
/// A search begins anew so often at most.
const ROUNDS: usize = 4;

/// The first values of a search: unknowns that have no effect at their guesses are moved to where they have one, if there is such a place.
///
/// # Errors
/// The fault at the guesses.
pub(super) fn awake<M: Optimisable, D: Integration<M>>(
    problem: &mut Readings<M, D>,
    mut z: DVector<f64>,
) -> Result<DVector<f64>, Fault> {
    let at = problem.evaluate(&z)?;
    for k in asleep(problem, &at, &z) {
        let moved = moved(problem, &z, k);
        let best = moved.into_iter().min_by(|(_, a), (_, b)| a.total_cmp(b));
        z = best.map_or(z, |(there, _)| there);
    }
    Ok(z)
}

/// Searches again from beside a minimum in which unknowns have no effect, as long as the residuals are smaller there.
///
/// # Errors
/// The fault at a point that had none.
pub(super) fn left<M: Optimisable, D: Integration<M>>(
    problem: &mut Readings<M, D>,
    mut found: Found,
    limits: &Limits,
) -> Result<Found, Fault> {
    for _ in 0..ROUNDS {
        let here = found.at.residuals.norm();
        let places = asleep(problem, &found.at, &found.z);
        let all = places.into_iter().flat_map(|k| moved(problem, &found.z, k));
        let best = all.min_by(|(_, a), (_, b)| a.total_cmp(b)).filter(|(_, size)| *size < here);
        let Some((there, _)) = best else { break };
        let iterations = found.iterations;
        found = minimise(problem, &there, limits)?;
        found.iterations += iterations;
    }
    Ok(found)
}

/// The unknowns that have no effect at a point, and may move.
fn asleep<M: Optimisable, D: Integration<M>>(
    problem: &Readings<M, D>,
    at: &Evaluation,
    z: &DVector<f64>,
) -> Vec<usize> {
    let least = NO_EFFECT * at.residuals.amax().max(1.0);
    let size = |k: usize| problem.scale(k).max(z[k].abs());
    let sleeps = |k: &usize| {
        let [low, high] = problem.bounds(*k);
        low < high && at.jacobian.column(*k).norm() * size(*k) <= least
    };
    (0..problem.places.len()).filter(sleeps).collect()
}

/// Points beside another one at which this unknown has an effect, each with the norm of the residuals.
fn moved<M: Optimisable, D: Integration<M>>(
    problem: &mut Readings<M, D>,
    z: &DVector<f64>,
    k: usize,
) -> Vec<(DVector<f64>, f64)> {
    let ([low, high], size) = (problem.bounds(k), problem.scale(k).max(z[k].abs()));
    let mut found = Vec::new();
    for part in MOVES {
        let mut there = z.clone();
        there[k] = (z[k] + part * size).max(low).min(high);
        if there[k] == z[k] {
            continue;
        }
        let Ok(at) = problem.evaluate(&there) else { continue };
        if !asleep(problem, &at, &there).contains(&k) {
            found.push((there, at.residuals.norm()));
        }
    }
    found
}
