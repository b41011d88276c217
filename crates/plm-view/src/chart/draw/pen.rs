//! How curves, markers and texts are drawn. Lengths are in pixels.

use std::f64::consts::TAU;

use super::canvas::{Anchor, Canvas, Lettering, Point, Stroke};
use super::look::{BACKGROUND, CURVES, FAINT, INK, MUTED};
use crate::chart::series::Look;

/// Height of the letters of labels and legends.
pub(super) const TEXT: f64 = 13.0;
/// A character's width over its height, on the safe side for sans-serif fonts.
const CHARACTER: f64 = 0.58;

const CURVE_WIDTH: f64 = 1.5;
const MARKER_RADIUS: f64 = 3.6;

/// Lengths of line and blank; the first kind is a full line.
const DASHES: [(f64, f64); 4] = [(0.0, 0.0), (6.0, 4.0), (1.6, 3.0), (12.0, 4.0)];

/// Corners of the markers, on a circle of radius 1, y downwards; no corners are a disc.
const MARKERS: [&[Point]; 6] = [
    &[],
    &[(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)],
    &[(0.0, -1.2), (1.1, 0.85), (-1.1, 0.85)],
    &[(0.0, -1.3), (1.1, 0.0), (0.0, 1.3), (-1.1, 0.0)],
    &[(0.0, 1.2), (1.1, -0.85), (-1.1, -0.85)],
    &[(-1.35, -0.45), (1.35, -0.45), (1.35, 0.45), (-1.35, 0.45)],
];

/// How a curve and its markers are drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    colour: &'static str,
    dashes: (f64, f64),
    corners: &'static [Point],
    hollow: bool,
}

impl Pen {
    /// Of series number `index` of a panel.
    pub(super) fn of(look: Option<Look>, index: usize) -> Self {
        let by_order = Look::Family { family: index % CURVES.len(), variant: index / CURVES.len() };
        let (colour, marker, kind) = match look.unwrap_or(by_order) {
            Look::Family { family, variant } => (CURVES[family % CURVES.len()], family, variant),
            Look::Muted(number) => (MUTED, number + 1, number + 1),
        };
        Self {
            colour,
            dashes: DASHES[kind % DASHES.len()],
            corners: MARKERS[marker % MARKERS.len()],
            hollow: kind > 0,
        }
    }

    /// A curve; a lone point is a dot.
    pub(super) fn curve(&self, path: &[Point], canvas: &mut Canvas) {
        canvas.line(path, Stroke { colour: self.colour, width: CURVE_WIDTH, dashes: self.dashes });
    }

    /// A marker: filled, or its outline.
    pub(super) fn marker(&self, at: Point, canvas: &mut Canvas) {
        let fill = if self.hollow { BACKGROUND } else { self.colour };
        canvas.polygon(&self.outline(at), fill, Stroke::full(self.colour, 1.2));
    }

    fn outline(&self, at: Point) -> Vec<Point> {
        let disc: Vec<Point> = (0..16).map(|k| (TAU * f64::from(k) / 16.0).sin_cos()).collect();
        let corners = if self.corners.is_empty() { &disc } else { self.corners };
        corners.iter().map(|&(x, y)| (at.0 + MARKER_RADIUS * x, at.1 + MARKER_RADIUS * y)).collect()
    }
}

/// A line of reference.
pub(super) const RULE: Stroke = Stroke { colour: INK, width: 1.0, dashes: (5.0, 4.0) };

/// Titles, notes, legends.
pub(super) const fn lettering(size: f64, anchor: Anchor) -> Lettering {
    Lettering { size, colour: INK, anchor, turned: false }
}

/// Numbers and names of axes.
pub(super) const fn axis_lettering(anchor: Anchor) -> Lettering {
    Lettering { size: TEXT, colour: FAINT, anchor, turned: false }
}

/// Room that a text needs, in pixels, on the safe side.
pub fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * CHARACTER * size
}

/// The lines of a text that is to be `width` pixels wide at most; `\n` begins a new one.
pub fn wrap(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split(' ') {
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if !line.is_empty() && text_width(&longer, size) > width {
                lines.push(std::mem::replace(&mut line, word.to_owned()));
            } else {
                line = longer;
            }
        }
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_broken_between_words() {
        assert_eq!(wrap("one two three", 10.0, 10.0 * 7.0 * CHARACTER), ["one two", "three"]);
        assert_eq!(wrap("unbreakable\nb", 10.0, 1.0), ["unbreakable", "b"]);
        assert!(wrap("", 10.0, 100.0).is_empty());
    }

    #[test]
    fn families_and_variants_look_different() {
        let look = |family, variant| {
            let pen = Pen::of(Some(Look::Family { family, variant }), 0);
            format!("{pen:?}")
        };
        let mut looks: Vec<String> = (0..32).map(|k| look(k % 8, k / 8)).collect();
        looks.sort();
        looks.dedup();
        assert_eq!(looks.len(), 32);
    }
}
