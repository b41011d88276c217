//! The mirror images of loops that a declaration asks for.
//!
//! A loop can mostly be closed in two ways. Newton's iteration finds the one that is nearer to the start; from there the other
//! one is mirrored: both bodies of the joint at the line through their far ends, which is the other solution of a dyad, or one
//! of them alone, where the other one is locked. Newton's iteration closes what that has opened.

use super::Absolute;
use super::assemble::{Pose, newton};
use super::placed::unwind;
use super::search::search;
use crate::fault::{Cause, Fault};
use crate::scalar::Real;
use crate::start::Start;
use crate::vector::Vector;

/// A sine below this is that of a flat loop, where both images meet.
const FLAT: f64 = 1e-9;
/// Ways to look for another image.
const WAYS: [Way; 3] = [Way::Mirrored, Way::Second, Way::First];

/// A revolute that asks for one of the mirror images of its loop: the side to which its second body turns from the first.
#[derive(Clone, Copy, Debug)]
pub struct Branch<S> {
    /// Name of the joint.
    pub part: &'static str,
    /// The bodies.
    pub bodies: [usize; 2],
    /// Their names.
    pub names: [&'static str; 2],
    /// Of each body, from where it is seen to where, from G in its axes, m: far end and pivot of the first, pivot and far end
    /// of the second.
    pub ends: [[[S; 2]; 2]; 2],
    /// The second is to turn left, so that the angle is positive.
    pub left: bool,
}

/// Motion that leads to the other image.
#[derive(Clone, Copy)]
enum Way {
    Mirrored,
    Second,
    First,
}

/// Goes over to the images that are asked for, one joint after the other; what is locked stays.
pub(super) fn find<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    mut pose: Pose<S, NQ, NC>,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
) -> Result<Pose<S, NQ, NC>, Fault> {
    while let Some(wrong) = all(m).find(|branch| !branch.is_met(&pose.q)) {
        let before = missed(m, &pose.q);
        let found = WAYS.into_iter().find_map(|way| {
            let mut q = wrong.other(&pose.q, way);
            for (i, start) in start.iter().enumerate() {
                if free.at(i) == S::ZERO {
                    q.set(i, start.value);
                }
            }
            let found = Pose { found: pose.found, ..newton(m, t, &q, free) };
            (found.is_closed(m) && missed(m, &found.q) < before).then_some(found)
        });
        let found = found.or_else(|| {
            let found = search(m, t, (start, free), |q| missed(m, q)).ok()?;
            (missed(m, &found.q) < before).then_some(found)
        });
        let [first, second] = wrong.names;
        let cause = Cause::OtherBranch { first, second, left: !wrong.left };
        pose = found.ok_or(Fault::of_part(t.to_f64(), wrong.part, cause))?;
        // Mirrored bodies may have turned further than half a turn.
        unwind(m, t, &mut pose, (start, free));
    }
    Ok(pose)
}

fn all<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
) -> impl Iterator<Item = Branch<S>> {
    (0..).map_while(|index| m.branch(index))
}

/// How many joints are on another image than they ask for.
pub(super) fn missed<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    q: &[S; NQ],
) -> usize {
    all(m).filter(|branch| !branch.is_met(q)).count()
}

impl<S: Real> Branch<S> {
    /// Far end of the first body, pivot, far end of the second.
    fn corners<const NQ: usize>(&self, q: &[S; NQ]) -> [[S; 2]; 3] {
        let ([[from, middle], [_, to]], [first, second]) = (self.ends, self.bodies);
        [position(q, first, from), position(q, first, middle), position(q, second, to)]
    }

    /// The angle by which the second body is turned from the first, rad.
    fn turned<const NQ: usize>(&self, q: &[S; NQ]) -> S {
        let [from, middle, to] = self.corners(q);
        angle(middle, to) - angle(from, middle)
    }

    fn is_met<const NQ: usize>(&self, q: &[S; NQ]) -> bool {
        let (sine, _) = self.turned(q).sin_cos();
        let sine = if self.left { sine } else { -sine };
        sine >= -S::lit(FLAT).max(S::lit(64.0) * S::EPSILON)
    }

    /// A pose near another image.
    fn other<const NQ: usize>(&self, q: &[S; NQ], way: Way) -> [S; NQ] {
        let ([from, middle, to], [first, second]) = (self.corners(q), self.bodies);
        let (mut other, two) = (*q, S::lit(2.0));
        match way {
            Way::Mirrored => {
                let line = angle(from, to);
                rotate(&mut other, first, from, two * (line - angle(from, middle)));
                rotate(&mut other, second, to, two * (line - angle(middle, to)));
            }
            Way::Second => rotate(&mut other, second, middle, -two * self.turned(q)),
            Way::First => rotate(&mut other, first, middle, two * self.turned(q)),
        }
        other
    }
}

/// A point of a body in absolute axes.
fn position<S: Real, const NQ: usize>(q: &[S; NQ], body: usize, [x, y]: [S; 2]) -> [S; 2] {
    let (sin, cos) = q.at(3 * body + 2).sin_cos();
    [q.at(3 * body) + cos * x - sin * y, q.at(3 * body + 1) + sin * x + cos * y]
}

/// The direction from one point to another, rad.
fn angle<S: Real>(from: [S; 2], to: [S; 2]) -> S {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// Rotates a body about a point.
fn rotate<S: Real, const NQ: usize>(q: &mut [S; NQ], body: usize, about: [S; 2], by: S) {
    let (sin, cos) = by.sin_cos();
    let [x, y] = [q.at(3 * body) - about[0], q.at(3 * body + 1) - about[1]];
    q.set(3 * body, about[0] + cos * x - sin * y);
    q.set(3 * body + 1, about[1] + sin * x + cos * y);
    q.set(3 * body + 2, q.at(3 * body + 2) + by);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two bars of 1.1 m and 0.7 m, whose pivots and far ends lie beside the lines through their centres.
    const BARS: Branch<f64> = Branch {
        part: "knee",
        bodies: [1, 0],
        names: ["thigh", "shin"],
        ends: [[[-0.5, 0.1], [0.6, 0.1]], [[-0.3, -0.2], [0.4, -0.2]]],
        left: true,
    };

    /// Thigh and shin at these angles, with the knee closed at (0.3, 0.2) m.
    fn knee(thigh: f64, shin: f64) -> [f64; 6] {
        let mut q = [0.0, 0.0, shin, 0.0, 0.0, thigh];
        for (body, pivot) in [(1, BARS.ends[0][1]), (0, BARS.ends[1][0])] {
            let at = position(&q, body, pivot);
            q[3 * body] += 0.3 - at[0];
            q[3 * body + 1] += 0.2 - at[1];
        }
        q
    }

    /// Far end and pivot of the thigh, pivot and far end of the shin.
    fn points(q: &[f64; 6]) -> [[f64; 2]; 4] {
        let [thigh, shin] = BARS.ends;
        [position(q, 1, thigh[0]), position(q, 1, thigh[1]), position(q, 0, shin[0]), position(q, 0, shin[1])]
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        (a[0] - b[0]).hypot(a[1] - b[1])
    }

    #[test]
    fn a_left_turn_is_met_by_the_angle_between_the_bodies() {
        for (thigh, shin, left) in
            [(0.4, 1.0, true), (0.4, -1.0, false), (2.9, -2.9, true), (-2.9, 2.9, false)]
        {
            let q = knee(thigh, shin);
            let turned: f64 = BARS.turned(&q) - (shin - thigh);
            assert!(turned.sin().abs() < 1e-15 && turned.cos() > 0.9, "{thigh} {shin}");
            assert_eq!(BARS.is_met(&q), left, "{thigh} {shin}");
            assert_eq!(Branch { left: false, ..BARS }.is_met(&q), !left, "{thigh} {shin}");
        }
        // A flat one is on both images, to rounding.
        for beside in [1e-12, -1e-12] {
            let q = knee(0.4, 0.4 + beside);
            assert!(BARS.is_met(&q) && Branch { left: false, ..BARS }.is_met(&q));
        }
    }

    #[test]
    fn the_mirror_image_keeps_the_far_ends_and_closes_the_knee() {
        let q = knee(0.4, 1.3);
        let ([hip, before, _, ankle], mirrored) = (points(&q), BARS.other(&q, Way::Mirrored));
        let [new_hip, knee_of_thigh, knee_of_shin, new_ankle] = points(&mirrored);
        for (what, gap) in [
            ("hip", distance(hip, new_hip)),
            ("ankle", distance(ankle, new_ankle)),
            ("knee", distance(knee_of_thigh, knee_of_shin)),
            ("thigh", distance(hip, before) - distance(hip, knee_of_thigh)),
            ("shin", distance(ankle, before) - distance(ankle, knee_of_shin)),
            ("angle", BARS.turned(&mirrored).sin() + BARS.turned(&q).sin()),
        ] {
            assert!(gap.abs() < 1e-14, "{what}: {gap:e}");
        }
        assert!(distance(before, knee_of_thigh) > 0.1);
    }

    #[test]
    fn one_body_alone_turns_about_the_knee() {
        let q = knee(0.4, 1.3);
        for (way, moved, kept) in [(Way::Second, 0, 1), (Way::First, 1, 0)] {
            let other = BARS.other(&q, way);
            assert_eq!(other[3 * kept..3 * kept + 3], q[3 * kept..3 * kept + 3]);
            let [_, knee_of_thigh, knee_of_shin, _] = points(&other);
            assert!(distance(knee_of_thigh, knee_of_shin) < 1e-15);
            // 0.9 rad to the left become as much to the right.
            assert!(
                (BARS.turned(&other) + 0.9).abs() < 1e-15
                    && (other[3 * moved + 2] - q[3 * moved + 2]).abs() > 1.0
            );
        }
    }
}
