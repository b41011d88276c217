//! The free rule: the poses stay, and a port goes to `R(-angle) (to - at)` in the axes of its body.

use std::f64::consts::TAU;

use super::{Changes, FINE};
use crate::number::Literal;
use crate::picture::{Placed, Point, between, turned};
use crate::refusal::Refusal;
use crate::sheet::{Axes, Polar};

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

/// The length and the angle of a point that stands at another one.
pub(super) fn put_polar(
    (polar, axes): (&Polar, Axes),
    placed: &Placed,
    to: Point,
    grid: f64,
    changes: &mut Changes,
) -> Result<(), Refusal> {
    let by = turned(between(placed.at, to), -turn(axes, placed.angle));
    let at = polar.at();
    let [x, y] = between(polar.base, [at[0] + by[0], at[1] + by[1]]);
    let length = x.hypot(y);
    // It would be written as 0, and a negative one is written no more.
    if length < FINE * grid || polar.length.si() <= 0.0 {
        return Err(Refusal::NoLength);
    }
    changes.put(&polar.length, length, FINE * grid);
    let (angle, before) = (y.atan2(x), polar.angle.si());
    changes.put(&polar.angle, angle + ((before - angle) / TAU).round() * TAU, FINE * grid / length);
    Ok(())
}

/// From the axes in which a port is written to the absolute ones.
pub(crate) fn turn(axes: Axes, angle: f64) -> f64 {
    match axes {
        Axes::Own => angle,
        Axes::Drawing(drawn) => angle - drawn,
        Axes::Absolute => 0.0,
    }
}
