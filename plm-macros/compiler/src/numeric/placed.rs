//! Starts by angles alone, the compiler's twin of the runtime's `absolute/placed.rs`: the bodies are placed by their joints, at the
//! declared angles.

use crate::collect::CollectVec;

use super::constraints::Closed;
use super::damped::Measure;
use super::search::Search;

/// A pose is doubted if a body has turned by more than this, rad: where constraints leave freedoms, and where they leave none.
const DOUBTED: [f64; 2] = [std::f64::consts::FRAC_PI_2, 0.4];
/// Positions are declared where none moves by more than this part of the scene's length.
const IN_PLACE: f64 = 0.25;
/// Another pose is taken if the squares of its turns are less than this part.
const NEARER: f64 = 0.5;
/// Damped steps to the places, and the part of the violation that each takes away.
const PLACING: (usize, f64) = (60, 1e-9);
/// Damped steps to a closed pose, likewise.
const CLOSING: (usize, f64) = (60, 1e-3);

/// A closed pose, or one that turns the bodies less from the start values, where it turns them far and moves them from their places.
pub(super) fn nearer(search: &Search, mut pose: Closed) -> Closed {
    let (constraints, start, locked) = (search.constraints, &search.start.values, &search.start.locked);
    let free = locked.iter().filter(|lock| !**lock).count();
    let limit = DOUBTED[usize::from(free == constraints.scene.model.rows.len())];
    let is_doubted = |q: &[f64]| moves(q, start).any(|(k, by)| k % 3 == 2 && by.abs() > limit);
    search.unwind(&mut pose);
    let place = IN_PLACE * constraints.scene.length;
    if !is_doubted(&pose.q) || moves(&pose.q, start).all(|(k, by)| k % 3 == 2 || by.abs() <= place) {
        return pose;
    }
    let turned_or_locked = locked.iter().enumerate().map(|(k, lock)| *lock || k % 3 == 2).collect_vec();
    let mut q = start.clone();
    Measure::new(constraints, &turned_or_locked).descend(&mut q, PLACING);
    for damped in [false, true] {
        if damped {
            Measure::new(constraints, locked).descend(&mut q, CLOSING);
        }
        let mut other = search.close(q.clone());
        search.unwind(&mut other);
        let steps = pose.steps + other.steps;
        if search.is_closed(&other) && turned(&other.q, start) < NEARER * turned(&pose.q, start) {
            pose = other;
        }
        pose.steps = steps;
        if !is_doubted(&pose.q) {
            break;
        }
    }
    pose
}

/// How far each coordinate has moved.
fn moves(q: &[f64], start: &[f64]) -> impl Iterator<Item = (usize, f64)> {
    q.iter().zip(start).map(|(q, start)| q - start).enumerate()
}

/// The sum of squares of the angles between two poses.
fn turned(q: &[f64], start: &[f64]) -> f64 {
    moves(q, start).filter(|(k, _)| k % 3 == 2).fold(0.0, |sum, (_, by)| sum + by * by)
}
