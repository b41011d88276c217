//! An interval of a step: verdict on the guards, by their enclosures and by values.

use super::marks::Marks;
use super::quartic::{Curve, Near, VALUES, curve};
use super::rounding::ULPS;
use super::search::Search;
use crate::enclosure::{Enclosed, Interval};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Halvings after which guards that are still open are judged by their values.
const BY_VALUES: u32 = 3;
/// Largest second derivative of such a guard over the whole step, in sizes of its terms, so that nothing hides between values, ...
const SMOOTH: f64 = 16.0;
/// ... unless it has no enclosure, or so many pieces have been examined.
pub(super) const MANY: u32 = 256;

/// Verdict on an interval.
pub(super) enum Verdict<S> {
    Clean,
    /// This guard is undecided, and possibly others.
    Open(usize),
    Crossing(usize, S),
}

/// Circumstances in which an interval is judged.
#[derive(Clone, Copy)]
pub(super) struct Depth {
    /// Halvings of the step.
    pub(super) level: u32,
    /// Guards that stay on their edges there.
    pub(super) resting: Marks,
    /// True if so many pieces of the step have been examined that values decide.
    pub(super) is_long: bool,
}

/// Ends of an interval, and the guards there.
pub(super) struct Piece<S, G> {
    pub(super) from: S,
    pub(super) to: S,
    pub(super) left: G,
    pub(super) right: G,
    /// True if the interval was bisected so often that rounding is evaluated here.
    pub(super) is_local: bool,
    /// Rounding errors of the guards.
    pub(super) noise: G,
}

impl<M: System<S: Real>> Search<'_, M> {
    /// Judges if every guard stays on its side over an interval, or leaves it once. Guards that are `resting` stay as long as they are not
    /// violated at its end.
    pub(super) fn judge(&self, piece: &Piece<M::S, M::G>, depth: Depth) -> Verdict<M::S> {
        let (mut open, mut by_values, mut crossed) = (None, Marks::NONE, false);
        let ranges = self.ranges(piece, depth.level, |i, range, slope| {
            if !self.searches(i) || self.from.at(i) >= piece.to {
                return;
            }
            if self.from.at(i) > piece.from {
                open = open.or(Some(i));
                return;
            }
            // A value a little beyond zero may be rounding, or the edge of a violation that is shorter than the interval.
            let edge = self.edge(i);
            let violated = edge - piece.noise.at(i);
            let stay = if piece.is_local { violated } else { edge };
            let (left, right) = (piece.left.at(i), piece.right.at(i));
            if depth.resting.has(i) && right >= violated {
                return;
            }
            let monotone = slope.low >= M::S::ZERO || slope.high <= M::S::ZERO;
            if left.min(right) >= violated && (monotone || range.low >= stay) {
                return;
            }
            if right < violated && slope.high <= M::S::ZERO {
                crossed = true;
            } else if Self::is_told_by_values(piece, depth, (i, range, slope)) {
                by_values.put(i);
            } else {
                open = open.or(Some(i));
            }
        });
        if !ranges {
            return Verdict::Open(open.unwrap_or(0));
        }
        if let Some(open) = open {
            return Verdict::Open(open);
        }
        if !by_values.is_empty() {
            match self.by_values(piece, by_values, depth) {
                Ok(leaves) => crossed |= leaves,
                Err(open) => return Verdict::Open(open),
            }
        }
        let crossing = if crossed { self.earliest(piece) } else { None };
        crossing.map_or(Verdict::Clean, |(i, theta)| Verdict::Crossing(i, theta))
    }

    /// True if a few values determine a guard over an interval, in which it has this range and this slope. They do not if something may
    /// hide between them: a narrow feature has a larger second derivative than the terms of the guard. A guard without an enclosure is
    /// known by values alone.
    fn is_told_by_values(
        piece: &Piece<M::S, M::G>,
        depth: Depth,
        (i, range, slope): (usize, Interval<M::S>, Interval<M::S>),
    ) -> bool {
        if depth.level < BY_VALUES {
            return false;
        }
        let terms = piece.noise.at(i) / (M::S::lit(ULPS) * M::S::EPSILON);
        let bends = (slope.high - slope.low) / (piece.to - piece.from);
        let is_unknown = range.low == -M::S::INFINITY && slope.high == M::S::INFINITY;
        is_unknown || depth.is_long || bends <= M::S::lit(SMOOTH) * terms
    }

    /// Judges these guards over an interval: true if one of them leaves its side, an error with the first that is undecided.
    #[cold]
    #[inline(never)]
    fn by_values(&self, piece: &Piece<M::S, M::G>, of: Marks, depth: Depth) -> Result<bool, usize> {
        let part = M::S::lit(1.0 / (VALUES - 1) as f64) * (piece.to - piece.from);
        let all: [M::G; VALUES] = core::array::from_fn(|k| match k {
            0 => piece.left,
            _ if k + 1 == VALUES => piece.right,
            _ => self.values(M::S::lit(k as f64).mul_add(part, piece.from)),
        });
        let mut leaves = false;
        for i in (0..M::G::LEN).filter(|i| of.has(*i)) {
            let (edge, noise) = (self.edge(i), piece.noise.at(i));
            // As above: a dip below the edge by no more than the rounding over the whole step may be real.
            let near = if piece.is_local || depth.is_long { Near::Rounding } else { Near::Unknown };
            match curve(&core::array::from_fn(|k| all[k].at(i)), (edge, noise), near) {
                Curve::Stays => {}
                Curve::Leaves => leaves = true,
                Curve::Open => return Err(i),
            }
        }
        Ok(leaves)
    }

    /// Guards that stay on their edges over an interval: at its ends and in its middle they are there and do not move, within rounding. The
    /// guards of a motion are nearly polynomials: six such conditions in a quarter of a step exclude anything between.
    #[cold]
    #[inline(never)]
    pub(super) fn resting(&self, piece: &Piece<M::S, M::G>) -> Marks {
        let middle = M::S::lit(0.5) * (piece.from + piece.to);
        [piece.from, middle, piece.to].into_iter().fold(Marks::ALL, |resting, theta| {
            let mut here = Marks::NONE;
            let (time, x) = self.path.around(theta, M::S::ZERO);
            self.system.guards_within(time, &self.held, &x, &mut |i, guard: Enclosed<M::S>| {
                if i < M::G::LEN {
                    let (noise, away) = (piece.noise.at(i), guard.middle - self.edge(i));
                    if away.abs() <= noise && guard.slope.size() <= noise {
                        here.put(i);
                    }
                }
            });
            resting & here
        })
    }
}
