//! Starts by angles alone, the compiler's twin of the runtime's `absolute/placed.rs`: the bodies are placed by their joints, at the
//! angles that were given.

use crate::collect::CollectVec;

use super::assembly::Start;
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
pub(super) const PLACING: (usize, f64) = (60, 1e-9);
/// Damped steps to a closed pose, likewise.
const CLOSING: (usize, f64) = (60, 1e-3);

/// So much beyond half a turn, in turns, is rounding.
const ROUNDING: f64 = 1e-6;

/// A closed pose, or one that turns the bodies less from the angles that were given, where it turns them far and moves them from
/// their places.
pub(super) fn nearer(search: &Search, mut pose: Closed) -> Closed {
    let (constraints, start) = (search.constraints, search.start);
    let free = start.locked.iter().filter(|lock| !**lock).count();
    let limit = DOUBTED[usize::from(free == constraints.scene.model.rows.len())];
    let is_doubted = |q: &[f64]| turned(start, q).any(|by| by.abs() > limit);
    unwind(search, &mut pose);
    let (place, count) = (IN_PLACE * constraints.scene.length, start.values.len());
    let moved = |k: usize| (pose.q[k] - start.values[k]).abs();
    if !is_doubted(&pose.q) || (0..count).all(|k| k % 3 == 2 || moved(k) <= place) {
        return pose;
    }
    let mut q = start.values.clone();
    let mut place = |held: &dyn Fn(usize) -> bool| {
        let locked = (0..count).map(|k| start.locked[k] || held(k)).collect_vec();
        Measure::new(constraints, &locked).descend(&mut q, PLACING);
    };
    place(&|k| k % 3 == 2);
    if (0..count).any(|k| k % 3 == 2 && !start.given[k]) {
        place(&|k| start.given[k]);
    }
    for damped in [false, true] {
        if damped {
            Measure::new(constraints, &start.locked).descend(&mut q, CLOSING);
        }
        let mut other = search.close(q.clone());
        unwind(search, &mut other);
        let steps = pose.steps + other.steps;
        if search.is_closed(&other) && distance(start, &other.q) < NEARER * distance(start, &pose.q) {
            pose = other;
        }
        pose.steps = steps;
        if !is_doubted(&pose.q) {
            break;
        }
    }
    pose
}

/// Takes off whole turns: beyond half a turn from an angle that was given, beyond a whole one from another.
pub(super) fn unwind(search: &Search, pose: &mut Closed) {
    let whole = |k: usize, turns: f64| {
        let beyond = if search.start.given[k] { 0.5 - ROUNDING } else { 0.0 };
        (turns.abs() + beyond).floor().copysign(turns)
    };
    search.unwind(pose, &whole);
}

/// How far each angle that was given has moved.
fn turned(start: &Start, q: &[f64]) -> impl Iterator<Item = f64> {
    let angles = start.given.iter().zip(q).zip(&start.values).filter(|((given, _), _)| **given);
    angles.map(|((_, q), start)| q - start)
}

/// The sum of their squares.
pub(super) fn distance(start: &Start, q: &[f64]) -> f64 {
    turned(start, q).fold(0.0, |sum, by| sum + by * by)
}
