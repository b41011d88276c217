//! From panels to SVG: where title, notes, frames, legends and axes stand.

mod legend;
mod panel;
mod pen;
mod rule;

use std::io;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use self::panel::Plot;
use self::pen::{Canvas, Outcome, TEXT, text, units};
pub(crate) use self::pen::{INK, PALETTE, text_width, wrap};
use super::axis::Ruler;
use super::{Chart, Panel};

const WIDTH: f64 = 800.0;
const MARGIN: f64 = 14.0;
/// Left of a frame: the axis' label and its numbers.
const NUMBERS: f64 = 98.0;
/// Under the last frame: numbers and label of the horizontal axis.
const FOOT: f64 = 56.0;
const GAP: f64 = 20.0;

const TITLE_TEXT: f64 = 17.0;
const TITLE_LINE: f64 = 24.0;
const NOTE_LINE: f64 = 18.0;

/// Where a frame stands, in units.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
}

/// Title and notes, broken into lines.
struct Head {
    title: Vec<String>,
    note: Vec<String>,
}

/// The whole picture.
pub(super) fn svg(chart: &Chart) -> io::Result<String> {
    let head = Head::new(chart);
    let x = horizontal(chart);
    let right = WIDTH - MARGIN - legend::width(chart);
    let mut top = head.height();
    let mut plots = Vec::new();
    for panel in &chart.panels {
        let (left, right) = (units(NUMBERS), units(right));
        let labels = rule::rows(panel, &x, left, right);
        top += rule::height(&labels);
        let bottom = top + frame_height(panel);
        let frame = Frame { left, right, top: units(top), bottom: units(bottom) };
        plots.push((Plot::new(panel, &x, frame), labels));
        top = bottom + GAP;
    }
    let height = if plots.is_empty() { top + FOOT } else { top - GAP + FOOT };

    let mut text = String::new();
    {
        let size = (units(WIDTH) as u32, units(height) as u32);
        let canvas = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(chart, &head, &plots, &canvas).map_err(io::Error::other)?;
        canvas.present().map_err(io::Error::other)?;
    }
    Ok(in_pixels(&text, height))
}

fn draw(chart: &Chart, head: &Head, plots: &[(Plot, rule::Rows)], canvas: &Canvas) -> Outcome {
    canvas.fill(&WHITE)?;
    head.draw(canvas)?;
    for (plot, labels) in plots {
        plot.draw(canvas)?;
        rule::draw_labels(labels, plot, canvas)?;
        legend::draw(plot, canvas)?;
    }
    if let Some((last, _)) = plots.last() {
        last.draw_foot(&chart.x.label, canvas)?;
    }
    Ok(())
}

impl Head {
    fn new(chart: &Chart) -> Self {
        let width = WIDTH - 2.0 * MARGIN;
        Self { title: wrap(&chart.title, TITLE_TEXT, width), note: wrap(&chart.note, TEXT, width) }
    }

    fn height(&self) -> f64 {
        let title = if self.title.is_empty() { 0.0 } else { 8.0 + TITLE_LINE * self.title.len() as f64 };
        MARGIN + title + NOTE_LINE * self.note.len() as f64
    }

    fn draw(&self, canvas: &Canvas) -> Outcome {
        let mut top = MARGIN;
        for (lines, size, height) in [(&self.title, TITLE_TEXT, TITLE_LINE), (&self.note, TEXT, NOTE_LINE)] {
            let style = text(size, HPos::Left, VPos::Center);
            for line in lines {
                canvas.draw_text(line, &style, (units(MARGIN), units(top + 0.5 * height)))?;
                top += height;
            }
        }
        Ok(())
    }
}

/// The horizontal axis, for all that stands in the panels.
fn horizontal(chart: &Chart) -> Ruler {
    let series = chart.panels.iter().flat_map(|panel| &panel.series);
    let points = series.flat_map(|series| series.points.iter().map(|point| point.0));
    let rules = chart.panels.iter().flat_map(|panel| &panel.rules);
    chart.x.ruler(points.chain(rules.filter_map(|rule| rule.at.x())))
}

/// Room for the frame, and for the legend where that is longer.
fn frame_height(panel: &Panel) -> f64 {
    panel.height.max(legend::height(panel))
}

/// The picture drawn in units, shown in pixels: width and height change, the view box stays.
fn in_pixels(svg: &str, height: f64) -> String {
    let drawn = format!("width=\"{}\" height=\"{}\" viewBox", units(WIDTH), units(height));
    let shown = format!("width=\"{WIDTH}\" height=\"{height}\" viewBox");
    svg.replacen(&drawn, &shown, 1)
}
