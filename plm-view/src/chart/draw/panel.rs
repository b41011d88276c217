//! One panel: grid, ticks, lines of reference, curves, frame.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::pen::{Canvas, FINE, FRAME, GRID, Outcome, Pen, TEXT, ZERO, line, text, units};
use super::{Frame, MARGIN, rule};
use crate::chart::Panel;
use crate::chart::axis::Ruler;
use crate::chart::series::{At, Series};
use crate::chart::thin::{pieces, thin};

/// Length of the ticks between the labelled ones of a logarithmic axis.
const SMALL_TICK: f64 = 4.0;

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

    pub(super) fn column(&self, x: f64) -> i32 {
        self.x.place(x, self.frame.left, self.frame.right)
    }

    pub(super) fn row(&self, y: f64) -> i32 {
        self.y.place(y, self.frame.bottom, self.frame.top)
    }

    /// Whether a line of reference has a place in the frame.
    pub(super) fn shows(&self, at: At) -> bool {
        match at {
            At::X(x) => self.x.holds(x),
            At::Y(y) => self.y.holds(y),
        }
    }

    /// The visible lines of a series, in units of the picture.
    pub(super) fn lines(&self, series: &Series) -> Vec<Vec<(i32, i32)>> {
        let seen = |piece| thin(piece, |x| self.column(x) / FINE as i32);
        let placed = |piece| seen(piece).into_iter().map(|(x, y)| (self.column(x), self.row(y))).collect();
        pieces(&series.points, |(x, y)| self.x.holds(x) && self.y.holds(y)).map(placed).collect()
    }

    pub(super) fn draw(&self, canvas: &Canvas) -> Outcome {
        self.draw_grid(canvas)?;
        self.draw_rows(canvas)?;
        let Frame { left, right, top, bottom } = self.frame;
        // As a path: plotters drops the width of a rectangle's stroke.
        line(canvas, &[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], FRAME)?;
        rule::draw(self, canvas)?;
        for (index, series) in self.panel.series.iter().enumerate() {
            let pen = Pen::of(series.look, index);
            for path in self.lines(series) {
                pen.curve(&path, canvas)?;
                if series.marked {
                    path.iter().try_for_each(|&point| pen.marker(point, canvas))?;
                }
            }
        }
        Ok(())
    }

    /// Lines at the labelled ticks, short ones at the edges for the others.
    fn draw_grid(&self, canvas: &Canvas) -> Outcome {
        let (Frame { left, right, top, bottom }, small) = (self.frame, units(SMALL_TICK));
        for tick in self.x.ticks() {
            let column = self.column(tick.value);
            if tick.label.is_empty() {
                line(canvas, &[(column, bottom - small), (column, bottom)], FRAME)?;
            } else {
                line(canvas, &[(column, top), (column, bottom)], GRID)?;
            }
        }
        for tick in self.y.ticks() {
            let row = self.row(tick.value);
            if tick.label.is_empty() {
                line(canvas, &[(left, row), (left + small, row)], FRAME)?;
            } else {
                let zero = tick.value == 0.0 && self.y.has_zero_line();
                line(canvas, &[(left, row), (right, row)], if zero { ZERO } else { GRID })?;
            }
        }
        Ok(())
    }

    /// Numbers and label of the vertical axis.
    fn draw_rows(&self, canvas: &Canvas) -> Outcome {
        let number = text(TEXT, HPos::Right, VPos::Center);
        for tick in self.y.ticks() {
            canvas.draw_text(&tick.label, &number, (self.frame.left - units(8.0), self.row(tick.value)))?;
        }
        let label = text(TEXT, HPos::Center, VPos::Center).transform(FontTransform::Rotate270);
        let middle = i32::midpoint(self.frame.top, self.frame.bottom);
        canvas.draw_text(&self.panel.y.label, &label, (units(MARGIN), middle))?;
        Ok(())
    }

    /// Numbers and label of the horizontal axis.
    pub(super) fn draw_foot(&self, label: &str, canvas: &Canvas) -> Outcome {
        let (Frame { left, right, bottom, .. }, style) = (self.frame, text(TEXT, HPos::Center, VPos::Top));
        for tick in self.x.ticks() {
            canvas.draw_text(&tick.label, &style, (self.column(tick.value), bottom + units(8.0)))?;
        }
        canvas.draw_text(label, &style, (i32::midpoint(left, right), bottom + units(30.0)))?;
        Ok(())
    }
}
