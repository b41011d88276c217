//! From panels to SVG: where title, notes, frames, legends and axes stand.

mod canvas;
mod legend;
mod look;
mod panel;
mod pen;
mod rule;

use self::canvas::{Anchor, Canvas};
pub use self::look::{CURVES, FONT, INK, dark_style};
use self::panel::Plot;
use self::pen::{TEXT, lettering};
pub use self::pen::{text_width, wrap};
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

/// Position of a frame.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// Title and notes, broken into lines.
struct Head {
    title: Vec<String>,
    note: Vec<String>,
}

/// The whole picture.
pub(super) fn svg(chart: &Chart) -> String {
    let head = Head::new(chart);
    let x = horizontal(chart);
    let (left, right) = (NUMBERS, WIDTH - MARGIN - legend::width(chart));
    let mut top = head.height();
    let mut plots = Vec::new();
    for panel in &chart.panels {
        let labels = rule::rows(panel, &x, left, right);
        top += rule::height(&labels);
        let bottom = top + frame_height(panel);
        plots.push((Plot::new(panel, &x, Frame { left, right, top, bottom }), labels));
        top = bottom + GAP;
    }
    let height = if plots.is_empty() { top + FOOT } else { top - GAP + FOOT };
    let mut canvas = Canvas::new(WIDTH, height);
    head.draw(&mut canvas);
    for (plot, labels) in &plots {
        plot.draw(&mut canvas);
        rule::draw_labels(labels, plot, &mut canvas);
        legend::draw(plot, &mut canvas);
    }
    if let Some((last, _)) = plots.last() {
        last.draw_foot(&chart.x.label, &mut canvas);
    }
    canvas.finish()
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

    fn draw(&self, canvas: &mut Canvas) {
        let mut top = MARGIN;
        for (lines, size, height) in [(&self.title, TITLE_TEXT, TITLE_LINE), (&self.note, TEXT, NOTE_LINE)] {
            for line in lines {
                canvas.text(line, (MARGIN, top + 0.5 * height), lettering(size, Anchor::Start));
                top += height;
            }
        }
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
