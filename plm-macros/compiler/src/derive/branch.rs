//! Which of the mirror images of a loop a pose is.

use plm_cas::Expr;

use crate::model::{FrameRef, Model, Pair, Part};

/// At a revolute between two bodies: how far the second turns from the first.
///
/// The first body is seen from its other joint (or its G) to the pivot, the second from the pivot to its other joint
/// (or its G), where that is not the pivot itself. The two mirror images of a loop differ in the sign.
#[derive(Clone, Debug)]
pub(crate) struct Branch {
    /// Index of the revolute in the model's parts.
    pub(crate) part: usize,
    /// Indices of the bodies.
    pub(crate) bodies: [usize; 2],
    /// Of each body, from where it is seen to where, from G in its axes, m: the far joint and the pivot of the first, the
    /// pivot and the far joint of the second.
    pub(crate) ends: [[[Expr; 2]; 2]; 2],
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
    parts.filter_map(|(index, part)| branch(model, &joints, index, part)).collect()
}

/// The joints of each body, as (part, the body's frame).
type Joints = Vec<Vec<(usize, FrameRef)>>;

fn branch(model: &Model, joints: &Joints, index: usize, part: &Part) -> Option<Branch> {
    let &[a, b] = part.frames.as_slice() else { return None };
    let bodies = [a.body?, b.body?];
    if part.pair != Some(Pair::Revolute) {
        return None;
    }
    let [pivot, on_second] = [port(model, a)?, port(model, b)?];
    let before = far_point(model, joints, index, a)?;
    let after = far_point(model, joints, index, b)?;
    let absolute = |body: usize, at: [Expr; 2]| point(model, body, at);
    let [first, second] = bodies;
    let (from, middle, to) = (absolute(first, before), absolute(first, pivot), absolute(second, after));
    let along = difference(middle, from);
    let onward = difference(to, middle);
    let cross = bilinear(along, [onward[1], onward[0]], true);
    let dot = bilinear(along, onward, false);
    let ends = [[before, pivot], [on_second, after]];
    Some(Branch { part: index, bodies, ends, turn: cross.atan2(dot) })
}

/// The port of another joint on the body, or its G, from G in the axes of the body; nothing if all are where the joint is, as
/// on a slider that is a point.
fn far_point(model: &Model, joints: &Joints, joint: usize, own: FrameRef) -> Option<[Expr; 2]> {
    let pivot = port(model, own)?;
    let others = joints[own.body?].iter().filter(|(index, _)| *index != joint);
    let mut others = others.filter_map(|(_, frame)| port(model, *frame));
    let centre = [Expr::ZERO; 2];
    others.find(|at| *at != pivot).or_else(|| (pivot != centre).then_some(centre))
}

/// A port of a body from G in its axes.
fn port(model: &Model, frame: FrameRef) -> Option<[Expr; 2]> {
    Some(model.bodies[frame.body?].ports.get(frame.port)?.at.components())
}

/// Absolute position of a point of a body.
fn point(model: &Model, body: usize, [px, py]: [Expr; 2]) -> [Expr; 2] {
    let [x, y, angle] = model.bodies[body].q;
    let (sin, cos) = (angle.sin(), angle.cos());
    let dx = bilinear([cos, sin], [px, py], true);
    let dy = bilinear([sin, cos], [px, py], false);
    [x + dx, y + dy]
}

fn difference(a: [Expr; 2], b: [Expr; 2]) -> [Expr; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// `a0 b0 + a1 b1`, or `a0 b0 - a1 b1`.
fn bilinear(a: [Expr; 2], b: [Expr; 2], minus: bool) -> Expr {
    let (first, second) = (a[0] * b[0], a[1] * b[1]);
    if minus { first - second } else { first + second }
}
