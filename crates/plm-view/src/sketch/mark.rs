//! Marks, of which a picture is made, and how SVG says them.

use std::f64::consts::PI;
use std::fmt::Write as _;

use super::paper::{Point, beside};
use crate::svg::escape;

/// A form on the paper, whose class says its lines and colours.
#[derive(Debug)]
pub(super) struct Mark {
    pub(super) class: String,
    pub(super) form: Form,
}

/// Places are in pixels, y downwards; angles in rad, counter-clockwise is positive.
#[derive(Debug)]
pub(super) enum Form {
    Path {
        points: Vec<Point>,
        is_closed: bool,
    },
    /// A closed line with closed lines within it, which are holes.
    Rings(Vec<Vec<Point>>),
    Circle {
        at: Point,
        radius: f64,
    },
    Arc {
        centre: Point,
        radius: f64,
        from: f64,
        to: f64,
    },
    /// The middle of its line is at a place.
    Text {
        at: Point,
        text: String,
    },
}

impl Mark {
    /// Adds the element of SVG, with a line of its own.
    pub(super) fn write_svg(&self, svg: &mut String) {
        let class = &self.class;
        let _ = match &self.form {
            Form::Path { points, is_closed } => {
                let end = if *is_closed { "Z" } else { "" };
                writeln!(svg, r#"<path class="{class}" d="M{}{end}"/>"#, corners(points))
            }
            Form::Rings(rings) => {
                let rings: String = rings.iter().map(|ring| ["M", &corners(ring), "Z"].concat()).collect();
                writeln!(svg, r#"<path class="{class}" fill-rule="evenodd" d="{rings}"/>"#)
            }
            Form::Circle { at, radius } => {
                let ([x, y], r) = (at.map(number), number(*radius));
                writeln!(svg, r#"<circle class="{class}" cx="{x}" cy="{y}" r="{r}"/>"#)
            }
            Form::Arc { centre, radius, from, to } => {
                let [start, end] = [from, to].map(|angle| pair(beside(*centre, *angle, *radius)));
                let (large, sweep, r) =
                    (u8::from((to - from).abs() > PI), u8::from(to < from), number(*radius));
                writeln!(svg, r#"<path class="{class}" d="M{start}A{r} {r} 0 {large} {sweep} {end}"/>"#)
            }
            Form::Text { at, text } => {
                let ([x, y], text) = (at.map(number), escape(text));
                writeln!(svg, r#"<text class="{class}" x="{x}" y="{y}">{text}</text>"#)
            }
        };
    }
}

fn corners(points: &[Point]) -> String {
    points.iter().map(|at| pair(*at)).collect::<Vec<_>>().join("L")
}

/// A distance or place to a tenth of a pixel.
pub(super) fn number(value: f64) -> String {
    let tenths = (10.0 * value).round() as i64;
    let (sign, whole, rest) = (if tenths < 0 { "-" } else { "" }, tenths.abs() / 10, tenths.abs() % 10);
    if rest == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{rest}") }
}

fn pair(at: Point) -> String {
    let [x, y] = at.map(number);
    format!("{x} {y}")
}
