//! Starts by angles alone: the bodies are placed by their joints, at the angles that were given.
//!
//! Positions that are not declared are zero. If the mechanism stands elsewhere, the shortest steps close such gaps by turning bodies too:
//! by whole revolutions, or onto another image of a loop. With the bodies in their places the gaps are those of the angles. An angle that
//! was not given does not count: it is zero by default, and its body may belong anywhere.

use super::Absolute;
use super::assemble::{Pose, newton};
use super::damped::Measure;
use super::search;
use crate::scalar::Real;
use crate::start::{Start, values};
use crate::vector::Vector;

/// A pose is doubted if a body has turned by more than this, rad: where constraints leave freedoms, and where they leave none.
const DOUBTED: [f64; 2] = [core::f64::consts::FRAC_PI_2, 0.4];
/// Positions are declared where none moves by more than this part of the mechanism's length.
const IN_PLACE: f64 = 0.25;
/// Another pose is taken if the sum of the squares of its rotations is less than this part.
const NEARER: f64 = 0.5;
/// Damped steps to the places, and the part of the violation that each takes away.
pub(super) const PLACING: (u32, f64) = (60, 1e-9);
/// Damped steps to a closed pose, likewise.
const CLOSING: (u32, f64) = (60, 1e-3);

/// Rounding error of half a revolution, in revolutions.
const ROUNDING: f64 = 1e-6;

/// A start that steps begin with.
pub(super) struct Begin<'a, S, const NQ: usize> {
    /// The start values.
    pub(super) start: &'a [S; NQ],
    /// 0 where a coordinate is locked, else 1.
    pub(super) free: &'a [S; NQ],
    /// The angles that the declaration gives, or whose value is no longer the zero of those that it does not give.
    pub(super) given: [bool; NQ],
}

impl<'a, S: Real, const NQ: usize> Begin<'a, S, NQ> {
    pub(super) fn new<M: Absolute<S, NQ, NC>, const NC: usize>(
        m: &M,
        start: &'a [S; NQ],
        free: &'a [S; NQ],
    ) -> Self {
        let given = |k: usize| m.layout().given_angles.get(k / 3) == Some(&true) || start.at(k) != S::ZERO;
        Self { start, free, given: core::array::from_fn(|k| k % 3 == 2 && given(k)) }
    }

    /// How far each angle that was given has moved.
    fn turned(&self, q: &[S; NQ]) -> impl Iterator<Item = S> {
        let angles = self.given.iter().zip(q).zip(self.start).filter(|((given, _), _)| **given);
        angles.map(|((_, q), start)| *q - *start)
    }

    /// The sum of their squares.
    pub(super) fn distance(&self, q: &[S; NQ]) -> S {
        self.turned(q).fold(S::ZERO, |sum, by| by.mul_add(by, sum))
    }

    /// Removes whole revolutions: beyond half a revolution from an angle that was given, beyond a whole one from another.
    fn unwind<M: Absolute<S, NQ, NC>, const NC: usize>(&self, m: &M, t: S, pose: &mut Pose<S, NQ, NC>) {
        let whole = |k: usize, turns: S| {
            let beyond = if self.given.get(k) == Some(&true) { 0.5 - ROUNDING } else { 0.0 };
            let count = (turns.abs() + S::lit(beyond)).floor();
            if turns < S::ZERO { -count } else { count }
        };
        search::unwind(m, t, pose, (self.start, self.free), &whole);
    }
}

/// Removes whole revolutions relative to the start from a pose.
#[inline(never)]
pub(super) fn unwind<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
) {
    Begin::new(m, &values(start), free).unwind(m, t, pose);
}

/// Replaces a closed pose by one that turns the bodies less from the given angles, if there is one. It searches only if the pose turns them
/// far and moves them from their places.
#[inline(never)]
pub(super) fn bring_nearer<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[S; NQ], &[S; NQ]),
) {
    let begin = &Begin::new(m, start, free);
    let layout = m.layout();
    let locked = begin.free.iter().filter(|free| **free == S::ZERO).count();
    let limit = S::lit(DOUBTED[usize::from(layout.coordinates.len() == layout.rows.len() + locked)]);
    let is_doubted = |q: &[S; NQ]| begin.turned(q).any(|by| by.abs() > limit);
    begin.unwind(m, t, pose);
    let (place, moved) = (S::lit(IN_PLACE) * m.length(), |k: usize| (pose.q.at(k) - start.at(k)).abs());
    if is_doubted(&pose.q) && (0..NQ).any(|k| k % 3 != 2 && moved(k) > place) {
        from_places(m, t, pose, begin, &is_doubted);
    }
}

/// Looks for a pose that steps reach from where joints put the bodies at the angles that were given.
#[cold]
#[inline(never)]
fn from_places<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    begin: &Begin<S, NQ>,
    is_doubted: &impl Fn(&[S; NQ]) -> bool,
) {
    let Begin { start, free, given } = begin;
    let mut q = **start;
    // At all angles as they are, then at those that were given.
    for all in [true, false] {
        let held = |k: usize| k % 3 == 2 && (all || given.get(k) == Some(&true));
        let free = Vector::from_fn(|k| if held(k) { S::ZERO } else { free.at(k) });
        if all || (2..m.layout().coordinates.len()).step_by(3).any(|k| !held(k)) {
            Measure::new(m, &free).descend(m, t, &mut q, PLACING);
        }
    }
    for damped in [false, true] {
        if damped {
            Measure::new(m, free).descend(m, t, &mut q, CLOSING);
        }
        let mut other = newton(m, t, &q, free);
        begin.unwind(m, t, &mut other);
        let (found, iterations) = (pose.found, pose.iterations + other.iterations);
        if other.is_closed(m) && begin.distance(&other.q) < S::lit(NEARER) * begin.distance(&pose.q) {
            *pose = other;
        }
        (pose.found, pose.iterations) = (found, iterations);
        if !is_doubted(&pose.q) {
            break;
        }
    }
}
