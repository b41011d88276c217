//! The free rule: the poses stay, and a port goes to `R(-angle) (to - at)` in the axes of its body.

use super::{Changes, FINE};
use crate::number::Literal;
use crate::picture::{Placed, Point, between, turned};
use crate::sheet::Axes;

/// The numbers of a port.
pub(super) fn put(
    (numbers, axes): (&[Literal; 2], Axes),
    placed: &Placed,
    to: Point,
    grid: f64,
    changes: &mut Changes,
) {
    let by = turned(between(placed.at, to), -turn(axes, placed.angle));
    for (literal, by) in numbers.iter().zip(by) {
        changes.put(literal, literal.si() + by, FINE * grid);
    }
}

/// From the axes in which a port is written to the absolute ones.
pub(crate) fn turn(axes: Axes, angle: f64) -> f64 {
    match axes {
        Axes::Own => angle,
        Axes::Drawing(drawn) => angle - drawn,
        Axes::Absolute => 0.0,
    }
}
