//! Vectors of the plane as pairs of expressions.

use plm_cas::Expr;

/// Components along x and y.
pub(crate) type Vec2 = [Expr; 2];

pub(crate) fn add(a: Vec2, b: Vec2) -> Vec2 {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn scale(factor: Expr, a: Vec2) -> Vec2 {
    [factor * a[0], factor * a[1]]
}

pub(crate) fn negated(a: Vec2) -> Vec2 {
    a.map(|component| -component)
}

/// A quarter turn to the left.
pub(crate) fn left(a: Vec2) -> Vec2 {
    [-a[1], a[0]]
}

pub(crate) fn dot(a: Vec2, b: Vec2) -> Expr {
    let (x, y) = (a[0] * b[0], a[1] * b[1]);
    x + y
}

pub(crate) fn cross(a: Vec2, b: Vec2) -> Expr {
    let (first, second) = (a[0] * b[1], a[1] * b[0]);
    first - second
}

/// `a` turned by the angle whose cosine and sine are `axis`.
pub(crate) fn turn(axis: Vec2, a: Vec2) -> Vec2 {
    let [c, s] = axis;
    [cross([c, s], [a[1], a[0]]), dot([s, c], a)]
}

pub(crate) fn is_zero(a: Vec2) -> bool {
    a.iter().all(|&component| component.is_zero())
}

/// `a` turned back by the angle whose cosine and sine are `axis`.
pub(crate) fn turned_back(a: Vec2, axis: Vec2) -> Vec2 {
    [dot(axis, a), cross(axis, a)]
}
