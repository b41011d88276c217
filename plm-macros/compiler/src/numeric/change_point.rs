//! Starts at change points: poses at which constraints depend on each other that are independent beside, so that two motions leave.

use super::assembly::Start;
use super::constraints::{Closed, Constraints, are_closed};
use super::rank::Rank;

/// Constraints are independent beside the pose where they are by this share. Lengths that repeat each other are closed by halves of the way
/// alone, so that their poses are known to the root of what counts as closed.
const REGULAR: f64 = 1e-3;
/// Steps along the velocities, as a part of the size of the scene.
const STEP: f64 = 1e-3;
/// A step that is led back by more than this part of it is no motion.
const LED_BACK: f64 = 0.1;

/// A start at a change point.
pub(crate) struct ChangePoint {
    /// The rows that depend on others there, each with all rows of that dependence.
    pub(crate) dependent: Vec<(usize, Vec<usize>)>,
    /// Is there a motion with the velocities of the start? Without velocities there is no saying.
    pub(crate) moves: Option<bool>,
}

/// The change point that a closed pose is, if it is one, with the rank of constraints and locks beside it.
pub(super) fn change_point(
    constraints: &Constraints,
    start: &Start,
    limits: &dyn Fn(&[f64]) -> Vec<f64>,
    (q, v): (&[f64], &[f64]),
) -> Option<(ChangePoint, Rank)> {
    let free = vec![false; q.len()];
    let here = constraints.rank(q, &free);
    if here.dependent.is_empty() {
        return None;
    }
    let close = |q: Vec<f64>| {
        let closed = constraints.close(q, &free, limits);
        are_closed(&closed.phi, &limits(&closed.q)).then_some(closed)
    };
    let beside = close(beside(q, constraints.scene.length))?;
    if constraints.rank_within(&beside.q, &free, REGULAR).value() <= here.value() {
        return None;
    }
    let moves = moves(constraints.scene.length, close, (q, v));
    let rank = constraints.rank(&beside.q, &start.locked);
    Some((ChangePoint { dependent: here.dependent, moves }, rank))
}

/// Is a step along the velocities closed by what is small of second order?
fn moves(length: f64, close: impl Fn(Vec<f64>) -> Option<Closed>, (q, v): (&[f64], &[f64])) -> Option<bool> {
    let unit = |k: usize| if k % 3 == 2 { 1.0 } else { length };
    let speed = v.iter().enumerate().fold(0.0_f64, |most, (k, v)| most.max(v.abs() / unit(k)));
    if speed == 0.0 {
        return None;
    }
    let ahead: Vec<f64> = q.iter().zip(v).map(|(q, v)| q + STEP / speed * v).collect();
    let Some(closed) = close(ahead.clone()) else { return Some(false) };
    let off = closed.q.iter().zip(&ahead).enumerate().map(|(k, (a, b))| (a - b).abs() / unit(k));
    Some(off.fold(0.0_f64, f64::max) <= LED_BACK * STEP)
}

/// A pose beside another that no symmetry singles out, as the runtime's `absolute::beside`.
fn beside(q: &[f64], length: f64) -> Vec<f64> {
    let (mut fraction, reach) = (0.0, 0.2 * length.min(1.0));
    let moved = q.iter().map(|q| {
        fraction += 0.618_033_988_749_894_9;
        if fraction >= 1.0 {
            fraction -= 1.0;
        }
        q + reach * (fraction - 0.5)
    });
    moved.collect()
}
