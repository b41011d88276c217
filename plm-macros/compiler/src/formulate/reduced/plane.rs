//! Vectors of the plane as pairs of expressions.

use plm_cas::{Expr, Graph};

/// Components along x and y.
pub(crate) type Vec2 = [Expr; 2];

pub(crate) fn add(graph: &mut Graph, a: Vec2, b: Vec2) -> Vec2 {
    [graph.add(a[0], b[0]), graph.add(a[1], b[1])]
}

pub(crate) fn scale(graph: &mut Graph, factor: Expr, a: Vec2) -> Vec2 {
    [graph.mul(factor, a[0]), graph.mul(factor, a[1])]
}

pub(crate) fn negated(graph: &mut Graph, a: Vec2) -> Vec2 {
    a.map(|component| graph.neg(component))
}

/// A quarter turn to the left.
pub(crate) fn left(graph: &mut Graph, a: Vec2) -> Vec2 {
    [graph.neg(a[1]), a[0]]
}

pub(crate) fn dot(graph: &mut Graph, a: Vec2, b: Vec2) -> Expr {
    let (x, y) = (graph.mul(a[0], b[0]), graph.mul(a[1], b[1]));
    graph.add(x, y)
}

pub(crate) fn cross(graph: &mut Graph, a: Vec2, b: Vec2) -> Expr {
    let (first, second) = (graph.mul(a[0], b[1]), graph.mul(a[1], b[0]));
    graph.sub(first, second)
}

/// `a` turned by the angle whose cosine and sine are `axis`.
pub(crate) fn turn(graph: &mut Graph, axis: Vec2, a: Vec2) -> Vec2 {
    let [c, s] = axis;
    [cross(graph, [c, s], [a[1], a[0]]), dot(graph, [s, c], a)]
}

pub(crate) fn is_zero(graph: &Graph, a: Vec2) -> bool {
    a.iter().all(|&component| graph.is_zero(component))
}

/// `a` turned back by the angle whose cosine and sine are `axis`.
pub(crate) fn turned_back(graph: &mut Graph, a: Vec2, axis: Vec2) -> Vec2 {
    [dot(graph, axis, a), cross(graph, axis, a)]
}
