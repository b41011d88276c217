//! The legend stands right of its frame, so that it covers nothing.

use super::WIDTH;
use super::canvas::{Anchor, Canvas};
use super::panel::Plot;
use super::pen::{Pen, TEXT, lettering, text_width};
use crate::chart::{Chart, Panel};

const ROW: f64 = 20.0;
/// The line and the blanks beside a name.
const LINE: f64 = 48.0;

/// Room for the longest name, within half of the picture.
pub(super) fn width(chart: &Chart) -> f64 {
    let series = chart.panels.iter().flat_map(|panel| &panel.series);
    let longest = series.map(|series| text_width(&series.name, TEXT)).fold(0.0, f64::max);
    (LINE + longest).min(WIDTH / 2.0)
}

pub(super) fn height(panel: &Panel) -> f64 {
    ROW * panel.series.len() as f64
}

pub(super) fn draw(plot: &Plot, canvas: &mut Canvas) {
    let right = plot.frame.right;
    for (index, series) in plot.panel.series.iter().enumerate() {
        let pen = Pen::of(series.look, index);
        let row = plot.frame.top + ROW * (index as f64 + 0.5);
        let (from, to) = (right + 12.0, right + LINE - 8.0);
        if series.style.has_line() {
            pen.curve(&[(from, row), (to, row)], canvas);
        }
        if series.style.has_markers() {
            pen.marker((f64::midpoint(from, to), row), canvas);
        }
        canvas.text(&series.name, (right + LINE, row), lettering(TEXT, Anchor::Start));
    }
}
