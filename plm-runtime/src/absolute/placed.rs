//! Starts by angles alone: the bodies are placed by their joints, at the declared angles.
//!
//! Positions that are not declared are zero. Where the mechanism stands elsewhere, the shortest steps close such gaps by turning
//! bodies too: by whole turns, or onto another image of a loop. With the bodies in their places the gaps are those of the angles.

use super::Absolute;
use super::assemble::{Pose, newton};
use super::damped::Measure;
use super::search::unwind;
use crate::scalar::Real;
use crate::vector::Vector;

/// A pose is doubted if a body has turned by more than this, rad: where constraints leave freedoms, and where they leave none.
const DOUBTED: [f64; 2] = [core::f64::consts::FRAC_PI_2, 0.4];
/// Positions are declared where none moves by more than this part of the mechanism's length.
const IN_PLACE: f64 = 0.25;
/// Another pose is taken if the squares of its turns are less than this part.
const NEARER: f64 = 0.5;
/// Damped steps to the places, and the part of the violation that each takes away.
const PLACING: (u32, f64) = (60, 1e-9);
/// Damped steps to a closed pose, likewise.
const CLOSING: (u32, f64) = (60, 1e-3);

/// A closed pose, or one that turns the bodies less from the start values, where it turns them far and moves them from their places.
pub(super) fn nearer<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    mut pose: Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
) -> Pose<S, NQ, NC> {
    let locked = free.iter().filter(|free| **free == S::ZERO).count();
    let limit = S::lit(DOUBTED[usize::from(NQ == NC + locked)]);
    let is_doubted = |q: &[S; NQ]| moves(q, start).any(|(k, by)| k % 3 == 2 && by.abs() > limit);
    unwind(m, t, &mut pose, (start, free));
    let place = S::lit(IN_PLACE) * m.length();
    if !is_doubted(&pose.q) || moves(&pose.q, start).all(|(k, by)| k % 3 == 2 || by.abs() <= place) {
        return pose;
    }
    from_places(m, t, pose, (start, free), &is_doubted)
}

/// The pose, or one that steps reach from where joints put the bodies at the declared angles.
#[cold]
#[inline(never)]
fn from_places<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    mut pose: Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
    is_doubted: &impl Fn(&[S; NQ]) -> bool,
) -> Pose<S, NQ, NC> {
    let mut measure = Measure::new(m, &Vector::from_fn(|k| if k % 3 == 2 { S::ZERO } else { free.at(k) }));
    let mut q = *start;
    measure.descend(m, t, &mut q, PLACING);
    for damped in [false, true] {
        if damped {
            Measure::new(m, free).descend(m, t, &mut q, CLOSING);
        }
        let mut other = newton(m, t, &q, free);
        unwind(m, t, &mut other, (start, free));
        let iterations = pose.iterations + other.iterations;
        if other.is_closed(m) && turned(&other.q, start) < S::lit(NEARER) * turned(&pose.q, start) {
            pose = other;
        }
        pose.iterations = iterations;
        if !is_doubted(&pose.q) {
            break;
        }
    }
    pose
}

/// How far each coordinate has moved.
fn moves<S: Real, const NQ: usize>(q: &[S; NQ], start: &[S; NQ]) -> impl Iterator<Item = (usize, S)> {
    q.iter().zip(start).map(|(q, start)| *q - *start).enumerate()
}

/// The sum of squares of the angles between two poses.
fn turned<S: Real, const NQ: usize>(q: &[S; NQ], start: &[S; NQ]) -> S {
    let angles = moves(q, start).filter(|(k, _)| k % 3 == 2);
    angles.fold(S::ZERO, |sum, (_, by)| by.mul_add(by, sum))
}
