//! From panels to SVG, through plotters.
//!
//! Lengths are in pixels of the finished picture. plotters places everything on whole units, which shows as
//! steps in a smooth curve, so a unit here is 1/[`FINE`] pixel.

use std::io;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::Axis;
use super::thin::{pieces, thin};
use super::{Chart, Curve, Panel};

/// Units a pixel.
const FINE: f64 = 8.0;

const WIDTH: f64 = 960.0;
const MARGIN: f64 = 16.0;
const TITLE: f64 = 44.0;
/// Left of a frame: the axis' label and its numbers.
const NUMBERS: f64 = 112.0;
/// Under the last frame: numbers and label of the horizontal axis.
const FOOT: f64 = 56.0;
const GAP: f64 = 20.0;
const FRAME_HEIGHT: f64 = 190.0;
const LEGEND_ROW: f64 = 20.0;
/// The line and the blanks beside a name in a legend.
const LEGEND_LINE: f64 = 44.0;
/// A character's width over its height, on the safe side for sans-serif fonts.
const CHARACTER: f64 = 0.58;

/// plotters writes a font-size of this share of what it is given.
const FONT_SIZE: f64 = 1.24;
const TEXT: f64 = 13.0;
const TITLE_TEXT: f64 = 18.0;
const CURVE_WIDTH: f64 = 1.6;

const INK: RGBColor = RGBColor(40, 44, 52);
const FRAME: RGBColor = RGBColor(130, 136, 146);
const GRID: RGBColor = RGBColor(226, 229, 234);
const ZERO: RGBColor = RGBColor(176, 181, 190);

/// Distinct for colour-blind readers too: M. Okabe, K. Ito, "Color universal design", 2008. The yellow is left
/// out (too faint on white).
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

type Canvas<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// Where a frame stands, in units.
#[derive(Clone, Copy)]
struct Frame {
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

/// The whole picture.
pub(super) fn svg(chart: &Chart) -> io::Result<String> {
    let head = if chart.title.is_empty() { MARGIN } else { TITLE };
    let heights: Vec<f64> = chart.panels.iter().map(frame_height).collect();
    let gaps = GAP * heights.len().saturating_sub(1) as f64;
    let height = head + heights.iter().sum::<f64>() + gaps + FOOT;

    let mut text = String::new();
    {
        let size = (units(WIDTH) as u32, units(height) as u32);
        let canvas = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(chart, head, &heights, &canvas).map_err(io::Error::other)?;
        canvas.present().map_err(io::Error::other)?;
    }
    Ok(in_pixels(&text, height))
}

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

fn draw(chart: &Chart, head: f64, heights: &[f64], canvas: &Canvas) -> Outcome {
    canvas.fill(&WHITE)?;
    if !chart.title.is_empty() {
        let style = text(TITLE_TEXT, HPos::Left, VPos::Center);
        canvas.draw_text(&chart.title, &style, (units(MARGIN), units(head / 2.0)))?;
    }
    let mut top = head;
    for (index, (panel, &height)) in chart.panels.iter().zip(heights).enumerate() {
        let frame = Frame {
            left: units(NUMBERS),
            right: units(WIDTH - MARGIN - legend_width(chart)),
            top: units(top),
            bottom: units(top + height),
        };
        draw_panel(panel, &chart.x, frame, canvas)?;
        if index + 1 == heights.len() {
            draw_foot(&chart.x, frame, canvas)?;
        }
        top += height + GAP;
    }
    Ok(())
}

fn draw_panel(panel: &Panel, x: &Axis, frame: Frame, canvas: &Canvas) -> Outcome {
    for tick in x.ticks() {
        let column = x.place(tick.value, frame.left, frame.right);
        line(canvas, &[(column, frame.top), (column, frame.bottom)], GRID, 1.0)?;
    }
    let number = text(TEXT, HPos::Right, VPos::Center);
    for tick in panel.y.ticks() {
        let row = panel.y.place(tick.value, frame.bottom, frame.top);
        let colour = if tick.value == 0.0 { ZERO } else { GRID };
        line(canvas, &[(frame.left, row), (frame.right, row)], colour, 1.0)?;
        canvas.draw_text(&tick.label, &number, (frame.left - units(8.0), row))?;
    }
    let label = text(TEXT, HPos::Center, VPos::Center).transform(FontTransform::Rotate270);
    canvas.draw_text(&panel.y.label, &label, (units(MARGIN), i32::midpoint(frame.top, frame.bottom)))?;

    for (index, curve) in panel.curves.iter().enumerate() {
        draw_curve(curve, index, x, &panel.y, frame, canvas)?;
        draw_legend(curve, index, frame, canvas)?;
    }
    // As a path: plotters drops the width of a rectangle's stroke.
    let Frame { left, right, top, bottom } = frame;
    line(canvas, &[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], FRAME, 1.0)
}

fn draw_curve(curve: &Curve, index: usize, x: &Axis, y: &Axis, frame: Frame, canvas: &Canvas) -> Outcome {
    let column = |abscissa: f64| x.place(abscissa, frame.left, frame.right);
    for piece in pieces(&curve.points) {
        let seen = thin(piece, |abscissa| column(abscissa) / FINE as i32);
        let path: Vec<(i32, i32)> = seen
            .into_iter()
            .map(|point| (column(point.0), y.place(point.1, frame.bottom, frame.top)))
            .collect();
        draw_path(&path, index, canvas)?;
    }
    Ok(())
}

fn draw_legend(curve: &Curve, index: usize, frame: Frame, canvas: &Canvas) -> Outcome {
    let row = frame.top + units(LEGEND_ROW * (index as f64 + 0.5));
    let (from, to) = (frame.right + units(12.0), frame.right + units(LEGEND_LINE - 8.0));
    draw_path(&[(from, row), (to, row)], index, canvas)?;
    let style = text(TEXT, HPos::Left, VPos::Center);
    canvas.draw_text(&curve.name, &style, (frame.right + units(LEGEND_LINE), row))?;
    Ok(())
}

/// A line in the look of curve number `index`; dashed from the second round through the palette on.
fn draw_path(path: &[(i32, i32)], index: usize, canvas: &Canvas) -> Outcome {
    let style = stroke(PALETTE[index % PALETTE.len()], CURVE_WIDTH);
    if let [point] = path {
        canvas.draw(&Circle::new(*point, units(CURVE_WIDTH), style.filled()))?;
    } else if index < PALETTE.len() {
        canvas.draw(&PathElement::new(path, style))?;
    } else {
        let dashes = DashedLineSeries::new(path.iter().copied(), units(6.0) as u32, units(4.0) as u32, style);
        for dash in dashes {
            canvas.draw(&dash)?;
        }
    }
    Ok(())
}

fn draw_foot(x: &Axis, frame: Frame, canvas: &Canvas) -> Outcome {
    let style = text(TEXT, HPos::Center, VPos::Top);
    for tick in x.ticks() {
        let column = x.place(tick.value, frame.left, frame.right);
        canvas.draw_text(&tick.label, &style, (column, frame.bottom + units(8.0)))?;
    }
    let middle = i32::midpoint(frame.left, frame.right);
    canvas.draw_text(&x.label, &style, (middle, frame.bottom + units(30.0)))?;
    Ok(())
}

fn line(canvas: &Canvas, path: &[(i32, i32)], colour: RGBColor, width: f64) -> Outcome {
    canvas.draw(&PathElement::new(path, stroke(colour, width)))?;
    Ok(())
}

fn stroke(colour: RGBColor, width: f64) -> ShapeStyle {
    colour.stroke_width(units(width) as u32)
}

fn text<'a>(size: f64, horizontal: HPos, vertical: VPos) -> TextStyle<'a> {
    (FontFamily::SansSerif, size * FINE * FONT_SIZE)
        .into_font()
        .color(&INK)
        .pos(Pos::new(horizontal, vertical))
}

/// Room for the frame, and for the legend where that is longer.
fn frame_height(panel: &Panel) -> f64 {
    FRAME_HEIGHT.max(LEGEND_ROW * panel.curves.len() as f64)
}

/// Room for the longest name, within half of the picture.
fn legend_width(chart: &Chart) -> f64 {
    let names = chart.panels.iter().flat_map(|panel| &panel.curves).map(|curve| curve.name.chars().count());
    let longest = names.max().unwrap_or(0) as f64;
    (LEGEND_LINE + longest * CHARACTER * TEXT).min(WIDTH / 2.0)
}

fn units(pixels: f64) -> i32 {
    (pixels * FINE).round() as i32
}

/// The picture drawn in units, shown in pixels: width and height change, the view box stays.
fn in_pixels(svg: &str, height: f64) -> String {
    let drawn = format!("width=\"{}\" height=\"{}\" viewBox", units(WIDTH), units(height));
    let shown = format!("width=\"{WIDTH}\" height=\"{height}\" viewBox");
    svg.replacen(&drawn, &shown, 1)
}
