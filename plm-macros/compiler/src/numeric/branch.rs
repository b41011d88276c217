//! The mirror images that loops are asked for, the compiler's twin of the runtime's search.

use crate::collect::{CollectVec, MapEach};
use plm_math::f64::{atan2, sin_cos};

use super::assembly::Start;
use super::constraints::Closed;
use super::scene::Scene;
use crate::evaluated::value;
use crate::model::Turn;

/// A sine below this is that of a flat loop, where both images meet.
const FLAT: f64 = 1e-9;

/// The branch that a revolute asks for.
pub(crate) struct Asked {
    /// Index of the revolute in the model's parts.
    pub(crate) part: usize,
    /// Indices of the bodies.
    pub(crate) bodies: [usize; 2],
    /// The values of [`crate::derive::Branch::ends`], m.
    ends: [[[f64; 2]; 2]; 2],
    turn: Turn,
}

/// Branches that the joints of a scene ask for, in their order.
pub(crate) fn asked(scene: &Scene) -> Vec<Asked> {
    let branches = scene.equations.branches.iter().filter_map(|branch| {
        let (turn, _) = scene.model.parts[branch.part].branch?;
        let number = |of| value(of, &scene.values);
        let ends = branch.ends.map_each(|ends| ends.map_each(|end| end.components().map_each(number)));
        Some(Asked { part: branch.part, bodies: branch.bodies, ends, turn })
    });
    branches.collect_vec()
}

/// How many joints are on another image than they ask for.
pub(super) fn missed(asked: &[Asked], q: &[f64]) -> usize {
    asked.iter().filter(|asked| !asked.is_met(q)).count()
}

/// Goes over to the images that are asked for, one joint after the other, each in one of three ways; `close` gives the
/// assembled pose next to one, if there is any, and `search` one that misses fewer than so many from anywhere.
pub(super) fn find(
    asked: &[Asked],
    mut pose: Closed,
    start: &Start,
    close: impl Fn(Vec<f64>) -> Option<Closed>,
    mut search: impl FnMut(usize) -> Option<Closed>,
) -> Closed {
    let missed = |q: &[f64]| missed(asked, q);
    while let Some(wrong) = asked.iter().find(|asked| !asked.is_met(&pose.q)) {
        let before = missed(&pose.q);
        let better = wrong.others(&pose.q).into_iter().find_map(|mut q| {
            for k in (0..q.len()).filter(|&k| start.locked[k]) {
                q[k] = start.values[k];
            }
            close(q).filter(|closed| missed(&closed.q) < before)
        });
        let Some(better) = better.or_else(|| search(before)) else { break };
        pose = better;
    }
    pose
}

impl Asked {
    /// The far end of the first body, the pivot, the far end of the second.
    fn corners(&self, q: &[f64]) -> [[f64; 2]; 3] {
        let [[from, middle], [_, to]] = self.ends;
        let [first, second] = self.bodies;
        [position(q, first, from), position(q, first, middle), position(q, second, to)]
    }

    /// How far the second body turns from the first, rad.
    fn turned(&self, q: &[f64]) -> f64 {
        let [from, middle, to] = self.corners(q);
        angle(middle, to) - angle(from, middle)
    }

    /// Is a pose of the image that is asked for?
    pub(crate) fn is_met(&self, q: &[f64]) -> bool {
        let (sine, _) = sin_cos(self.turned(q));
        if self.turn == Turn::Left { sine >= -FLAT } else { sine <= FLAT }
    }

    /// Poses near other images: both bodies mirrored at the line through their far ends, or one of them turned about the pivot.
    fn others(&self, q: &[f64]) -> [Vec<f64>; 3] {
        let ([from, middle, to], [first, second]) = (self.corners(q), self.bodies);
        let line = angle(from, to);
        let mut mirrored = q.to_vec();
        rotate(&mut mirrored, first, from, 2.0 * (line - angle(from, middle)));
        rotate(&mut mirrored, second, to, 2.0 * (line - angle(middle, to)));
        let one = |body: usize, by: f64| {
            let mut q = q.to_vec();
            rotate(&mut q, body, middle, by);
            q
        };
        let turned = self.turned(q);
        [mirrored, one(second, -2.0 * turned), one(first, 2.0 * turned)]
    }
}

/// A point of a body in absolute axes.
fn position(q: &[f64], body: usize, [x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = sin_cos(q[3 * body + 2]);
    [q[3 * body] + cos * x - sin * y, q[3 * body + 1] + sin * x + cos * y]
}

/// The direction from one point to another, rad.
fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    atan2(to[1] - from[1], to[0] - from[0])
}

/// Turns a body about a point.
fn rotate(q: &mut [f64], body: usize, about: [f64; 2], by: f64) {
    let (sin, cos) = sin_cos(by);
    let [x, y] = [q[3 * body] - about[0], q[3 * body + 1] - about[1]];
    q[3 * body] = about[0] + cos * x - sin * y;
    q[3 * body + 1] = about[1] + sin * x + cos * y;
    q[3 * body + 2] += by;
}
