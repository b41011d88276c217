//! One panel: grid, ticks, lines of reference, curves, frame.

use super::canvas::{Anchor, Canvas, Lettering, Point, Stroke};
use super::look::{FAINT, GRID};
use super::pen::{Pen, TEXT, axis_lettering};
use super::{Frame, MARGIN, rule};
use crate::chart::Panel;
use crate::chart::axis::Ruler;
use crate::chart::decimation::{decimate, segments};
use crate::chart::series::{At, Series};

/// Length of the ticks between the labelled ones of a logarithmic axis.
const SMALL_TICK: f64 = 4.0;

/// The line at a tick, at zero, at a tick without a label.
const TICK: Stroke = Stroke::full(GRID, 1.0);
const ZERO: Stroke = Stroke::full(FAINT, 1.2);
const SMALL: Stroke = Stroke::full(FAINT, 1.0);

/// A panel with its place and its rulers.
pub(super) struct Plot<'a> {
    pub(super) panel: &'a Panel,
    pub(super) frame: Frame,
    x: Ruler,
    y: Ruler,
}

impl<'a> Plot<'a> {
    pub(super) fn new(panel: &'a Panel, x: &Ruler, frame: Frame) -> Self {
        let points = panel.series.iter().flat_map(|series| series.points.iter().map(|point| point.1));
        let rules = panel.rules.iter().filter_map(|rule| rule.at.y());
        Self { panel, frame, x: *x, y: panel.y.ruler(points.chain(rules)) }
    }

    pub(super) fn column(&self, x: f64) -> f64 {
        self.x.place(x, self.frame.left, self.frame.right)
    }

    pub(super) fn row(&self, y: f64) -> f64 {
        self.y.place(y, self.frame.bottom, self.frame.top)
    }

    /// True if a line of reference has a place in the frame.
    pub(super) fn shows(&self, at: At) -> bool {
        match at {
            At::X(x) => self.x.holds(x),
            At::Y(y) => self.y.holds(y),
        }
    }

    /// The visible lines of a series.
    pub(super) fn lines(&self, series: &Series) -> Vec<Vec<Point>> {
        let seen = |segment| decimate(segment, |x| self.column(x) as i32);
        let placed =
            |segment| seen(segment).into_iter().map(|(x, y)| (self.column(x), self.row(y))).collect();
        segments(&series.points, |(x, y)| self.x.holds(x) && self.y.holds(y)).map(placed).collect()
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        self.draw_grid(canvas);
        self.draw_rows(canvas);
        let Frame { left, right, top, bottom } = self.frame;
        canvas.polygon(&[(left, top), (right, top), (right, bottom), (left, bottom)], "none", TICK);
        rule::draw(self, canvas);
        for (index, series) in self.panel.series.iter().enumerate() {
            let pen = Pen::of(series.look, index);
            for path in self.lines(series) {
                if series.style.has_line() {
                    pen.curve(&path, canvas);
                }
                if series.style.has_markers() {
                    for &point in &path {
                        pen.marker(point, canvas);
                    }
                }
            }
        }
    }

    /// Lines at the labelled ticks, short ones at the edges for the others.
    fn draw_grid(&self, canvas: &mut Canvas) {
        let Frame { left, right, top, bottom } = self.frame;
        for tick in self.x.ticks() {
            let column = self.column(tick.value);
            if tick.label.is_empty() {
                canvas.line(&[(column, bottom - SMALL_TICK), (column, bottom)], SMALL);
            } else {
                canvas.line(&[(column, top), (column, bottom)], TICK);
            }
        }
        for tick in self.y.ticks() {
            let row = self.row(tick.value);
            if tick.label.is_empty() {
                canvas.line(&[(left, row), (left + SMALL_TICK, row)], SMALL);
            } else {
                let zero = tick.value == 0.0 && self.y.has_zero_line();
                canvas.line(&[(left, row), (right, row)], if zero { ZERO } else { TICK });
            }
        }
    }

    /// Numbers and label of the vertical axis.
    fn draw_rows(&self, canvas: &mut Canvas) {
        let Frame { left, top, bottom, .. } = self.frame;
        for tick in self.y.ticks() {
            canvas.text(&tick.label, (left - 8.0, self.row(tick.value)), axis_lettering(Anchor::End));
        }
        let turned = Lettering { turned: true, ..axis_lettering(Anchor::Middle) };
        canvas.text(&self.panel.y.label, (MARGIN, f64::midpoint(top, bottom)), turned);
    }

    /// Numbers and label of the horizontal axis.
    pub(super) fn draw_foot(&self, label: &str, canvas: &mut Canvas) {
        let (Frame { left, right, bottom, .. }, lettering) = (self.frame, axis_lettering(Anchor::Middle));
        for tick in self.x.ticks() {
            canvas.text(&tick.label, (self.column(tick.value), bottom + 8.0 + 0.5 * TEXT), lettering);
        }
        canvas.text(label, (f64::midpoint(left, right), bottom + 30.0 + 0.5 * TEXT), lettering);
    }
}
