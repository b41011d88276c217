//! Which of the mirror images of a loop a pose is.

use plm_cas::{Expr, Graph};

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
    /// The turn in (-pi, pi], rad; positive to the left.
    pub(crate) turn: Expr,
}

/// The branches of a model, in the order of its joints.
pub(crate) fn branches(model: &Model, graph: &mut Graph) -> Vec<Branch> {
    let mut joints: Joints = vec![Vec::new(); model.bodies.len()];
    for (index, part) in model.parts.iter().enumerate().filter(|(_, part)| part.pair.is_some()) {
        for frame in &part.frames {
            if let Some(body) = frame.body {
                joints[body].push((index, *frame));
            }
        }
    }
    let parts = model.parts.iter().enumerate();
    parts.filter_map(|(index, part)| branch(model, &joints, graph, index, part)).collect()
}

/// The joints of each body, as (part, the body's frame).
type Joints = Vec<Vec<(usize, FrameRef)>>;

fn branch(model: &Model, joints: &Joints, graph: &mut Graph, index: usize, part: &Part) -> Option<Branch> {
    let &[a, b] = part.frames.as_slice() else { return None };
    let bodies = [a.body?, b.body?];
    if part.pair != Some(Pair::Revolute) {
        return None;
    }
    let pivot = point(model, graph, a)?;
    let before = far_point(model, joints, graph, index, a)?;
    let after = far_point(model, joints, graph, index, b)?;
    let along = difference(graph, pivot, before);
    let onward = difference(graph, after, pivot);
    let cross = bilinear(graph, along, [onward[1], onward[0]], true);
    let dot = bilinear(graph, along, onward, false);
    Some(Branch { part: index, bodies, turn: graph.atan2(cross, dot) })
}

/// The port of another joint on the body, or its G; nothing if all are where the joint is, as on a slider that is a point.
fn far_point(
    model: &Model,
    joints: &Joints,
    graph: &mut Graph,
    joint: usize,
    own: FrameRef,
) -> Option<[Expr; 2]> {
    let of_body = &model.bodies[own.body?];
    let pivot = of_body.ports.get(own.port)?.at;
    let apart = |frame: &FrameRef| of_body.ports.get(frame.port).is_some_and(|port| port.at != pivot);
    let others = joints[own.body?].iter().filter(|(index, _)| *index != joint);
    if let Some((_, frame)) = others.into_iter().find(|(_, frame)| apart(frame)) {
        return point(model, graph, *frame);
    }
    let [x, y, _] = of_body.q;
    let centre = [graph.zero(); 2];
    (pivot != centre).then_some([x, y])
}

/// Absolute position of a port of a body.
fn point(model: &Model, graph: &mut Graph, frame: FrameRef) -> Option<[Expr; 2]> {
    let body = &model.bodies[frame.body?];
    let [px, py] = body.ports.get(frame.port)?.at;
    let [x, y, angle] = body.q;
    let (sin, cos) = (graph.sin(angle), graph.cos(angle));
    let dx = bilinear(graph, [cos, sin], [px, py], true);
    let dy = bilinear(graph, [sin, cos], [px, py], false);
    Some([graph.add(x, dx), graph.add(y, dy)])
}

fn difference(graph: &mut Graph, a: [Expr; 2], b: [Expr; 2]) -> [Expr; 2] {
    [graph.sub(a[0], b[0]), graph.sub(a[1], b[1])]
}

/// `a0 b0 + a1 b1`, or `a0 b0 - a1 b1`.
fn bilinear(graph: &mut Graph, a: [Expr; 2], b: [Expr; 2], minus: bool) -> Expr {
    let (first, second) = (graph.mul(a[0], b[0]), graph.mul(a[1], b[1]));
    if minus { graph.sub(first, second) } else { graph.add(first, second) }
}
