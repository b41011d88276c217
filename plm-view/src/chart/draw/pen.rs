//! Strokes, texts and markers, through plotters.
//!
//! Lengths are in pixels of the finished picture. plotters places everything on whole units, which shows as
//! steps in a smooth curve, so a unit here is 1/[`FINE`] pixel.

use std::f64::consts::TAU;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::chart::series::Look;

/// Units a pixel.
pub(super) const FINE: f64 = 8.0;
/// Height of the letters of labels and legends.
pub(super) const TEXT: f64 = 13.0;
/// plotters writes a font-size of this share of what it is given.
const FONT_SIZE: f64 = 1.24;
/// A character's width over its height, on the safe side for sans-serif fonts.
const CHARACTER: f64 = 0.58;

const CURVE_WIDTH: f64 = 1.6;
const MARKER_RADIUS: f64 = 3.6;

pub(crate) const INK: RGBColor = RGBColor(40, 44, 52);
pub(super) const FRAME: RGBColor = RGBColor(130, 136, 146);
pub(super) const GRID: RGBColor = RGBColor(226, 229, 234);
pub(super) const ZERO: RGBColor = RGBColor(176, 181, 190);
pub(super) const RULE: RGBColor = RGBColor(70, 75, 84);
const MUTED: RGBColor = RGBColor(128, 128, 128);

/// Distinct for colour-blind readers too: M. Okabe, K. Ito, "Color universal design", 2008. The yellow is left
/// out (too faint on white).
pub(crate) const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

/// Lengths of line and blank; the first kind is a full line.
const DASHES: [(f64, f64); 4] = [(0.0, 0.0), (6.0, 4.0), (1.6, 3.0), (12.0, 4.0)];

/// Corners of the markers, on a circle of radius 1, y downwards; no corners are a disc.
const MARKERS: [&[(f64, f64)]; 6] = [
    &[],
    &[(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)],
    &[(0.0, -1.2), (1.1, 0.85), (-1.1, 0.85)],
    &[(0.0, -1.3), (1.1, 0.0), (0.0, 1.3), (-1.1, 0.0)],
    &[(0.0, 1.2), (1.1, -0.85), (-1.1, -0.85)],
    &[(-1.35, -0.45), (1.35, -0.45), (1.35, 0.45), (-1.35, 0.45)],
];

pub(super) type Canvas<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
pub(super) type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// How a curve and its markers are drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    colour: RGBColor,
    dashes: (f64, f64),
    corners: &'static [(f64, f64)],
    hollow: bool,
}

impl Pen {
    /// Of series number `index` of a panel.
    pub(super) fn of(look: Option<Look>, index: usize) -> Self {
        let by_order = Look::Family { family: index % PALETTE.len(), variant: index / PALETTE.len() };
        let (colour, marker, kind) = match look.unwrap_or(by_order) {
            Look::Family { family, variant } => (PALETTE[family % PALETTE.len()], family, variant),
            Look::Muted(number) => (MUTED, number + 1, number + 1),
        };
        Self {
            colour,
            dashes: DASHES[kind % DASHES.len()],
            corners: MARKERS[marker % MARKERS.len()],
            hollow: kind > 0,
        }
    }

    /// A line of reference.
    pub(super) fn rule() -> Self {
        Self { colour: RULE, dashes: (5.0, 4.0), corners: &[], hollow: false }
    }

    /// A line through points; a lone point is a dot.
    pub(super) fn path(&self, path: &[(i32, i32)], width: f64, canvas: &Canvas) -> Outcome {
        let style = stroke(self.colour, width);
        if let [point] = path {
            canvas.draw(&Circle::new(*point, units(width), style.filled()))?;
        } else if self.dashes.0 == 0.0 {
            canvas.draw(&PathElement::new(path, style))?;
        } else {
            let (line, blank) = (units(self.dashes.0) as u32, units(self.dashes.1) as u32);
            for dash in DashedLineSeries::new(path.iter().copied(), line, blank, style) {
                canvas.draw(&dash)?;
            }
        }
        Ok(())
    }

    /// A line of the width of curves.
    pub(super) fn curve(&self, path: &[(i32, i32)], canvas: &Canvas) -> Outcome {
        self.path(path, CURVE_WIDTH, canvas)
    }

    /// A marker: filled, or its outline on white.
    pub(super) fn marker(&self, at: (i32, i32), canvas: &Canvas) -> Outcome {
        let fill = if self.hollow { WHITE } else { self.colour };
        let outline = self.outline(at);
        canvas.draw(&Polygon::new(outline.clone(), fill.filled()))?;
        let closed: Vec<_> = outline.iter().chain(outline.first()).copied().collect();
        canvas.draw(&PathElement::new(closed, stroke(self.colour, 1.2)))?;
        Ok(())
    }

    fn outline(&self, at: (i32, i32)) -> Vec<(i32, i32)> {
        let disc: Vec<(f64, f64)> = (0..16).map(|k| (TAU * f64::from(k) / 16.0).sin_cos()).collect();
        let corners = if self.corners.is_empty() { &disc } else { self.corners };
        let place = |&(x, y): &(f64, f64)| (at.0 + units(MARKER_RADIUS * x), at.1 + units(MARKER_RADIUS * y));
        corners.iter().map(place).collect()
    }
}

pub(super) fn line(canvas: &Canvas, path: &[(i32, i32)], colour: RGBColor) -> Outcome {
    canvas.draw(&PathElement::new(path, stroke(colour, 1.0)))?;
    Ok(())
}

fn stroke(colour: RGBColor, width: f64) -> ShapeStyle {
    colour.stroke_width(units(width) as u32)
}

/// The look of a text of letters of `size` pixels, which stands at its anchor as told.
pub(super) fn text<'a>(size: f64, horizontal: HPos, vertical: VPos) -> TextStyle<'a> {
    (FontFamily::SansSerif, size * FINE * FONT_SIZE)
        .into_font()
        .color(&INK)
        .pos(Pos::new(horizontal, vertical))
}

/// Room that a text needs, in pixels, on the safe side.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * CHARACTER * size
}

/// The lines of a text that is to be `width` pixels wide at most; `\n` begins a new one.
pub(crate) fn wrap(text: &str, size: f64, width: f64) -> Vec<String> {
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

pub(super) fn units(pixels: f64) -> i32 {
    (pixels * FINE).round() as i32
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
        let mut looks: Vec<String> = (0..28).map(|k| look(k % 7, k / 7)).collect();
        looks.sort();
        looks.dedup();
        assert_eq!(looks.len(), 28);
    }
}
