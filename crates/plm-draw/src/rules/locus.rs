//! Loci: where prescribed angles and locked dimensions let a pin go.

use std::ops::Range;

use crate::number::Literal;
use crate::picture::{Point, between, on_ray, turned};

/// A point that is nearer to the middle of a circle, in parts of its radius, is in the middle.
const MIDDLE: f64 = 1e-9;

/// A line or a circle on which a pin stays, in absolute axes.
#[derive(Clone, Debug)]
pub(crate) enum Locus {
    /// A line through two points.
    Line(Point, Point),
    /// A circle around a point.
    Circle(Point, f64),
}

impl Locus {
    /// The point of it that is nearest to another one; nothing where it is no line, or all of it is as near.
    pub(crate) fn nearest(&self, to: Point) -> Option<Point> {
        match self {
            Locus::Line(from, through) => (from != through).then(|| on_ray(*from, *through, to)),
            Locus::Circle(centre, radius) => {
                let [x, y] = between(*centre, to);
                let away = x.hypot(y);
                let share = radius / away;
                (away > MIDDLE * radius).then(|| [centre[0] + share * x, centre[1] + share * y])
            }
        }
    }
}

/// The lines of a point at `at` whose locked numbers are those of axes that are turned by an angle, each with where its number stands.
pub(crate) fn of_numbers(numbers: &[Literal; 2], at: Point, turn: f64) -> Vec<(Range<usize>, Locus)> {
    let line = |axis: usize| {
        let mut along = [0.0; 2];
        along[1 - axis] = 1.0;
        let [x, y] = turned(along, turn);
        Locus::Line(at, [at[0] + x, at[1] + y])
    };
    let locked = (0..2).filter(|axis| numbers[*axis].is_locked);
    locked.map(|axis| (numbers[axis].range.clone(), line(axis))).collect()
}

/// The line and the circle of a point at `at` whose locked numbers are its length and its angle from `base`.
pub(crate) fn around(base: Point, at: Point, [length, angle]: [&Literal; 2]) -> Vec<(Range<usize>, Locus)> {
    let [x, y] = between(base, at);
    let circle = length.is_locked.then(|| (length.range.clone(), Locus::Circle(base, x.hypot(y))));
    let ray = angle.is_locked.then(|| (angle.range.clone(), Locus::Line(base, at)));
    circle.into_iter().chain(ray).collect()
}
