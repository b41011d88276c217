//! The text of an SVG file, element by element. Lengths are in pixels.
//!
//! A drawing library would give strokes alone: ticks, legends and logarithmic scales have to be those of the page.
//! `crates/plm-view/page/tests/ticks.json` holds Rust and JavaScript to one table of ticks, units, colours and fonts.

use std::fmt::{Display, Write as _};

use super::look::{BACKGROUND, FONT, dark_style};
use crate::markup::escape;

/// A place in the picture.
pub(super) type Point = (f64, f64);

/// A picture while it is drawn.
pub(super) struct Canvas {
    text: String,
}

/// A line: its colour, its width, and the lengths of line and blank, both 0 for a full one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stroke {
    pub(super) colour: &'static str,
    pub(super) width: f64,
    pub(super) dashes: (f64, f64),
}

/// Which point of a text stands at its place; upright it is its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lettering {
    pub(super) size: f64,
    pub(super) colour: &'static str,
    pub(super) anchor: Anchor,
    /// Upwards, by a quarter turn.
    pub(super) turned: bool,
}

impl Canvas {
    /// An empty picture.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let (width, height) = (number(width), number(height));
        let font = escape(FONT);
        let mut canvas = Self { text: String::new() };
        canvas.put(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"{font}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">"
        ));
        canvas.put(dark_style());
        canvas.put(format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"{BACKGROUND}\"/>"));
        canvas
    }

    /// An element on a line of its own; writing into a text does not fail.
    fn put(&mut self, element: impl Display) {
        let _ = writeln!(self.text, "{element}");
    }

    /// A line through points; a lone point is a dot.
    pub(super) fn line(&mut self, path: &[Point], stroke: Stroke) {
        if let [(x, y)] = *path {
            let (x, y, radius) = (number(x), number(y), number(stroke.width));
            self.put(format_args!(
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{}\"/>",
                stroke.colour
            ));
            return;
        }
        let (points, stroke) = (points(path), stroke.attributes());
        self.put(format_args!("<polyline points=\"{points}\" fill=\"none\" {stroke}/>"));
    }

    /// A closed polygon.
    pub(super) fn polygon(&mut self, corners: &[Point], fill: &str, stroke: Stroke) {
        let (points, stroke) = (points(corners), stroke.attributes());
        self.put(format_args!("<polygon points=\"{points}\" fill=\"{fill}\" {stroke}/>"));
    }

    /// A text at its anchor.
    pub(super) fn text(&mut self, text: &str, (x, y): Point, lettering: Lettering) {
        let Lettering { size, colour, anchor, turned } = lettering;
        let (x, y, size) = (number(x), number(y), number(size));
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let turn = if turned { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
        let text = escape(text);
        self.put(format_args!(
            "<text x=\"{x}\" y=\"{y}\" dy=\"0.35em\" font-size=\"{size}\" text-anchor=\"{anchor}\" \
             fill=\"{colour}\"{turn}>{text}</text>"
        ));
    }

    /// The whole file.
    pub(super) fn finish(mut self) -> String {
        self.put("</svg>");
        self.text
    }
}

impl Stroke {
    /// A full line.
    pub(super) const fn full(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dashes: (0.0, 0.0) }
    }

    fn attributes(self) -> String {
        let Self { colour, width, dashes: (line, blank) } = self;
        let dashes =
            if blank > 0.0 { format!(" stroke-dasharray=\"{line} {blank}\"") } else { String::new() };
        format!("stroke=\"{colour}\" stroke-width=\"{width}\"{dashes}")
    }
}

fn points(path: &[Point]) -> String {
    path.iter().map(|&(x, y)| format!("{},{}", number(x), number(y))).collect::<Vec<_>>().join(" ")
}

/// To a tenth of a pixel; the sum takes the sign from a zero.
fn number(value: f64) -> f64 {
    (value * 10.0).round() / 10.0 + 0.0
}
