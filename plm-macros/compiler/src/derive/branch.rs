//! Which of the mirror images of a loop a pose is.

use crate::collect::CollectVec;
use plm_cas::{Expr, Rotation, Vec2};

use crate::model::{FrameRef, Model, Pair, Part};

/// At a revolute between two bodies: how far the second turns from the first.
///
/// The first body is seen from its other joint (or its G) to the pivot, the second from the pivot to its other joint
/// (or its G), where that is not the pivot itself. The two mirror images of a loop differ in the sign.
#[derive(Clone)]
pub(crate) struct Branch {
    /// Index of the revolute in the model's parts.
    pub(crate) part: usize,
    /// Indices of the bodies.
    pub(crate) bodies: [usize; 2],
    /// Of each body, from where it is seen to where, from G in its axes, m: the far joint and the pivot of the first, the
    /// pivot and the far joint of the second.
    pub(crate) ends: [[Vec2; 2]; 2],
    /// The turn in (-pi, pi], rad; positive to the left.
    pub(crate) turn: Expr,
}

/// The branches of a model, in the order of its joints.
pub(crate) fn branches(model: &Model) -> Vec<Branch> {
    let mut joints: Joints = vec![Vec::new(); model.bodies.len()];
    for (index, part) in model.parts.iter().enumerate().filter(|(_, part)| part.pair.is_some()) {
        for frame in &part.frames {
            if let Some(body) = frame.body {
                joints[body].push((index, *frame));
            }
        }
    }
    let parts = model.parts.iter().enumerate();
    parts.filter_map(|(index, part)| branch(model, &joints, index, part)).collect_vec()
}

/// The joints of each body, as (part, the body's frame).
type Joints = Vec<Vec<(usize, FrameRef)>>;

fn branch(model: &Model, joints: &Joints, index: usize, part: &Part) -> Option<Branch> {
    let &[a, b] = part.frames.as_slice() else { return None };
    let bodies = [a.body?, b.body?];
    if part.pair != Some(Pair::Revolute) {
        return None;
    }
    let ends @ [[before, pivot], [_, after]] = [
        [far_point(model, joints, index, a)?, port(model, a)?],
        [port(model, b)?, far_point(model, joints, index, b)?],
    ];
    let [first, second] = bodies;
    let from = place(model, first, before);
    let middle = place(model, first, pivot);
    let to = place(model, second, after);
    let along = middle - from;
    let onward = to - middle;
    let turn = along.cross(onward).atan2(along.dot(onward));
    Some(Branch { part: index, bodies, ends, turn })
}

/// The port of another joint on the body, or its G, from G in the axes of the body; nothing if all are where the joint is, as
/// on a slider that is a point.
fn far_point(model: &Model, joints: &Joints, joint: usize, own: FrameRef) -> Option<Vec2> {
    let pivot = port(model, own)?;
    let others = joints[own.body?].iter().filter(|(index, _)| *index != joint);
    let mut others = others.filter_map(|(_, frame)| port(model, *frame));
    let centre = Vec2::ZERO;
    others.find(|at| *at != pivot).or_else(|| (pivot != centre).then_some(centre))
}

/// A port of a body from G in its axes.
fn port(model: &Model, frame: FrameRef) -> Option<Vec2> {
    Some(model.bodies[frame.body?].ports.get(frame.port)?.at)
}

/// A point of a body in absolute axes, `r + R(theta) s` (manual, section 4.3.1), from `s` in the axes of the body.
fn place(model: &Model, body: usize, s: Vec2) -> Vec2 {
    let [x, y, theta] = model.bodies[body].q;
    Vec2::new(x, y) + Rotation::by(theta) * s
}
