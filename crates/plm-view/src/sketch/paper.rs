//! Strokes of a picture. What was drawn is remembered as dots, so that texts can keep clear of it.

use super::mark::{Form, Mark};

/// A place on the paper, in pixels, y downwards.
pub(super) type Point = [f64; 2];

/// Distance of the dots that stand for a line, in pixels.
const GRAIN: f64 = 4.0;
/// From so many corners of a shape on, dots are farther apart: they would count more than texts.
const MOST_CORNERS: usize = 40;
/// Length and half the width of the head of an arrow, in pixels.
const HEAD: (f64, f64) = (9.0, 3.6);

/// Marks in the order in which they were made, and where they are.
#[derive(Debug, Default)]
pub(super) struct Paper {
    pub(super) marks: Vec<Mark>,
    pub(super) dots: Vec<Point>,
}

impl Paper {
    /// A line through points.
    pub(super) fn line(&mut self, class: &str, points: &[Point]) {
        self.path(class, points, false);
    }

    /// A closed line through points.
    pub(super) fn polygon(&mut self, class: &str, points: &[Point]) {
        self.path(class, points, true);
        if let [first, .., last] = points {
            self.remember(*last, *first);
            // The inside is covered too.
            let middle = [0, 1].map(|k| points.iter().map(|at| at[k]).sum::<f64>() / points.len() as f64);
            for corner in
                points.iter().step_by(if points.len() < MOST_CORNERS { 1 } else { points.len() / 8 })
            {
                self.remember(*corner, middle);
            }
            if class.starts_with("edge") {
                self.widen(points);
            }
        }
    }

    /// A closed line with holes, which are closed lines within it.
    pub(super) fn rings(&mut self, class: &str, rings: &[Vec<Point>]) {
        let [whole, holes @ ..] = rings else { return };
        if holes.is_empty() {
            return self.polygon(class, whole);
        }
        self.mark(class, Form::Rings(rings.to_vec()));
        rings.iter().flat_map(|ring| ring.windows(2)).for_each(|ends| self.remember(ends[0], ends[1]));
    }

    /// Remembers how wide a link is.
    fn widen(&mut self, corners: &[Point]) {
        for aside in [[5.0, 0.0], [-5.0, 0.0], [0.0, 5.0], [0.0, -5.0]] {
            let moved: Vec<Point> = corners.iter().map(|at| [at[0] + aside[0], at[1] + aside[1]]).collect();
            moved.windows(2).for_each(|ends| self.remember(ends[0], ends[1]));
        }
    }

    fn mark(&mut self, class: &str, form: Form) {
        self.marks.push(Mark { class: class.to_owned(), form });
    }

    fn path(&mut self, class: &str, points: &[Point], is_closed: bool) {
        self.mark(class, Form::Path { points: points.to_vec(), is_closed });
        let corners: Vec<Point> =
            points.iter().step_by(points.len().div_ceil(MOST_CORNERS).max(1)).copied().collect();
        corners.windows(2).for_each(|ends| self.remember(ends[0], ends[1]));
    }

    pub(super) fn circle(&mut self, class: &str, at: Point, radius: f64) {
        self.mark(class, Form::Circle { at, radius });
        for k in 0..12 {
            self.dots.push(beside(at, f64::from(k) * std::f64::consts::TAU / 12.0, radius));
        }
        self.dots.push(at);
    }

    /// A line with a head at its end; `class` is that of both.
    pub(super) fn arrow(&mut self, class: &str, from: Point, to: Point) {
        let along = (from[1] - to[1]).atan2(to[0] - from[0]);
        self.line(class, &[from, beside(to, along, -0.7 * HEAD.0)]);
        self.head(class, to, along);
    }

    /// An arc from one angle to another (rad, counter-clockwise is positive) with a head at its end.
    pub(super) fn turn(&mut self, class: &str, centre: Point, radius: f64, angles: [f64; 2]) {
        let [from, to] = angles;
        let sense = (to - from).signum();
        let short = to - sense * 0.7 * HEAD.0 / radius;
        let steps = 24;
        let at = |k: i32| beside(centre, from + (short - from) * f64::from(k) / f64::from(steps), radius);
        self.mark(class, Form::Arc { centre, radius, from, to: short });
        (0..=steps).for_each(|k| self.dots.push(at(k)));
        // The chord of the head lies within the circle.
        let along = to + sense * (std::f64::consts::FRAC_PI_2 - 0.5 * HEAD.0 / radius);
        self.head(class, beside(centre, to, radius), along);
    }

    fn head(&mut self, class: &str, tip: Point, along: f64) {
        let foot = beside(tip, along, -HEAD.0);
        let side = |sense: f64| beside(foot, along + std::f64::consts::FRAC_PI_2, sense * HEAD.1);
        self.polygon(&format!("{class} head"), &[tip, side(1.0), side(-1.0)]);
    }

    /// Text with its middle at a place.
    pub(super) fn text(&mut self, class: &str, at: Point, text: &str) {
        self.mark(class, Form::Text { at, text: text.to_owned() });
        self.dots.extend([[at[0], at[1] - 8.0], [at[0], at[1] + 8.0]]);
    }

    fn remember(&mut self, from: Point, to: Point) {
        let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / GRAIN).ceil().max(1.0);
        let part = |k: f64, axis: usize| from[axis] + (to[axis] - from[axis]) * k / steps;
        self.dots.extend((0..=steps as u32).map(|k| [part(f64::from(k), 0), part(f64::from(k), 1)]));
    }
}

/// The place that lies so far from another, at an angle that is positive counter-clockwise (rad).
pub(super) fn beside(at: Point, angle: f64, distance: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [at[0] + distance * cos, at[1] - distance * sin]
}
