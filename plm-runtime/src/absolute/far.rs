//! Starts that close only far away: a pose is far if it turns a body by more than the gaps at the start explain.
//!
//! Joints that are open by a share `g` of the mechanism's length are closed by rotations of the order of `g`, and next to a dead point,
//! where lengths change with the square of an angle, of `sqrt(g)`. A pose much farther away is another one than was drawn: the other image
//! of a loop, or one after a dead point that the lengths do not reach.

use core::fmt;

use super::Absolute;
use super::assemble::Pose;
use super::branch;
use super::damped::Measure;
use super::placed::{Begin, PLACING};
use super::search::search;
use crate::scalar::Real;
use crate::start::{Start, values};
use crate::vector::Vector;

/// Rotations of so many times the root of the missing share are explained by it, rad.
const EXPLAINED: f64 = 8.0;
/// Smallest rotation that is checked, rad.
const LOOKED_AT: f64 = 0.3;
/// Another pose is taken if the sum of the squares of its rotations is less than this part.
const NEARER: f64 = 0.9;

/// A start that closes only far away: how far a body was turned, and how far the joints were open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Far<S> {
    /// The given angle that was turned most, as `arm.angle`.
    pub coordinate: &'static str,
    /// By how much it was turned, rad.
    pub turned: S,
    /// Gap of the joints in the start as declared, m.
    pub missing: S,
}

impl<S: Real> fmt::Display for Far<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [turned, missing] = [self.turned.to_f64().to_degrees(), self.missing.to_f64()];
        let coordinate = self.coordinate;
        write!(
            f,
            "the start closes only far from where it is declared: {coordinate} is turned by {turned:.1} deg, though joints \
             miss each other by {missing:.2e} m alone"
        )
    }
}

/// Does a closed pose turn a body further from the given angles than what was missing there explains?
#[inline(never)]
pub(super) fn far<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
    q: &[S; NQ],
) -> Option<Far<S>> {
    let start = values(start);
    let begin = &Begin::new(m, &start, free);
    let turned = |k: usize| (q.at(k) - start.at(k)).abs();
    let given = (0..NQ).filter(|k| begin.given.get(*k) == Some(&true));
    let most = given.reduce(|most, k| if turned(k) > turned(most) { k } else { most })?;
    if turned(most) <= S::lit(LOOKED_AT) {
        return None;
    }
    let missing = missing(m, t, begin);
    let is_far = turned(most) > S::lit(EXPLAINED) * missing.sqrt();
    is_far.then(|| Far {
        coordinate: m.layout().coordinates.get(most).copied().unwrap_or_default(),
        turned: q.at(most) - start.at(most),
        missing: missing * m.length(),
    })
}

/// Puts in the place of a closed pose that is far from the start the nearest one that a search finds.
#[inline(never)]
pub(super) fn look_nearer<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    pose: &mut Pose<S, NQ, NC>,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
) {
    if far(m, t, (start, free), &pose.q).is_none() {
        return;
    }
    let Ok(other) = search(m, t, (start, free), |q| branch::missed(m, q)) else { return };
    let values = values(start);
    let begin = Begin::new(m, &values, free);
    if begin.distance(&other.q) < S::lit(NEARER) * begin.distance(&pose.q) {
        *pose = Pose { iterations: pose.iterations + other.iterations, ..other };
    }
}

/// The largest violation of the start as declared, as a share of the length or in rad. If constraints and locks leave no freedom, the
/// violation with the bodies moved to their places counts if it is smaller, since positions may be left out; with freedoms the shortest
/// steps to their places turn bodies too.
#[cold]
#[inline(never)]
fn missing<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    begin: &Begin<S, NQ>,
) -> S {
    let Begin { start, free, given } = begin;
    let mut q = **start;
    let declared = Measure::new(m, free).size(m, t, &q);
    let (layout, locked) = (m.layout(), free.iter().filter(|free| **free == S::ZERO).count());
    if layout.coordinates.len() > layout.rows.len() + locked {
        return declared;
    }
    for all in [true, false] {
        let held = |k: usize| k % 3 == 2 && (all || given.get(k) == Some(&true));
        let free = Vector::from_fn(|k| if held(k) { S::ZERO } else { free.at(k) });
        Measure::new(m, &free).descend(m, t, &mut q, PLACING);
    }
    let placed = Measure::new(m, free).size(m, t, &q);
    // NaN is not less.
    if placed < declared { placed } else { declared }
}
