//! Lines of reference and their labels.

use super::Frame;
use super::canvas::{Anchor, Canvas, Point};
use super::panel::Plot;
use super::pen::{RULE, TEXT, lettering, text_width};
use crate::chart::Panel;
use crate::chart::axis::Ruler;
use crate::chart::series::At;

const ROW: f64 = 18.0;

/// The labels of upright lines, in rows above the frame: no two of a row touch.
pub(super) type Rows = Vec<Vec<Label>>;

/// A text and its middle.
pub(super) struct Label {
    text: String,
    middle: f64,
}

impl Label {
    fn half(&self) -> f64 {
        0.5 * text_width(&self.text, TEXT) + 4.0
    }
}

/// Each label goes to the lowest row that has room for it.
pub(super) fn rows(panel: &Panel, x: &Ruler, left: f64, right: f64) -> Rows {
    let mut rows = Rows::new();
    for rule in &panel.rules {
        let At::X(value) = rule.at else { continue };
        if !x.holds(value) {
            continue;
        }
        let mut label = Label { text: rule.label.clone(), middle: x.place(value, left, right) };
        let half = label.half();
        label.middle = label.middle.min(right - half).max(left + half);
        let is_free = |row: &Vec<Label>| {
            row.iter().all(|other| (other.middle - label.middle).abs() > other.half() + half)
        };
        match rows.iter().position(is_free) {
            Some(row) => rows[row].push(label),
            None => rows.push(vec![label]),
        }
    }
    rows
}

pub(super) fn height(rows: &Rows) -> f64 {
    ROW * rows.len() as f64
}

pub(super) fn draw_labels(rows: &Rows, plot: &Plot, canvas: &mut Canvas) {
    for (index, row) in rows.iter().enumerate() {
        let middle = plot.frame.top - ROW * (index as f64 + 0.5);
        for label in row {
            canvas.text(&label.text, (label.middle, middle), lettering(TEXT, Anchor::Middle));
        }
    }
}

/// The lines, and the labels of level ones.
pub(super) fn draw(plot: &Plot, canvas: &mut Canvas) {
    let Frame { left, right, top, bottom } = plot.frame;
    for rule in plot.panel.rules.iter().filter(|rule| plot.shows(rule.at)) {
        match rule.at {
            At::X(x) => {
                let column = plot.column(x);
                canvas.line(&[(column, top), (column, bottom)], RULE);
            }
            At::Y(y) => {
                let row = plot.row(y);
                canvas.line(&[(left, row), (right, row)], RULE);
                let (anchor, place) = quiet_place(plot, &rule.label, row);
                canvas.text(&rule.label, place, lettering(TEXT, anchor));
            }
        }
    }
}

/// Above or below the line, at its left or right end: where the fewest curves pass.
fn quiet_place(plot: &Plot, label: &str, row: f64) -> (Anchor, Point) {
    let Frame { left, right, top, bottom } = plot.frame;
    let (width, height, blank) = (text_width(label, TEXT), ROW, 6.0);
    let mut curves: Vec<_> = plot.panel.series.iter().flat_map(|series| plot.lines(series)).collect();
    let upright = plot.panel.rules.iter().filter_map(|rule| rule.at.x()).map(|x| plot.column(x));
    curves.extend(upright.map(|column| vec![(column, top), (column, row), (column, bottom)]));
    let mut best = (usize::MAX, (Anchor::Start, (left + blank, row - 0.5 * height)));
    for (from, to) in [(row - height, row), (row, row + height)] {
        let ends = [
            (Anchor::End, right - blank - width, right - blank),
            (Anchor::Start, left + blank, left + blank + width),
        ];
        for (anchor, start, end) in ends {
            if from < top || to > bottom {
                continue;
            }
            let space = Frame { left: start, right: end, top: from, bottom: to };
            let passing = curves.iter().flat_map(|path| path.windows(2)).filter(|ends| passes(ends, space));
            let crossed = passing.count();
            if crossed < best.0 {
                let place = if anchor == Anchor::End { end } else { start };
                best = (crossed, (anchor, (place, f64::midpoint(from, to))));
            }
        }
    }
    best.1
}

/// True if a straight segment of a curve intersects a rectangle, checked at points along it.
fn passes(ends: &[Point], space: Frame) -> bool {
    let [from, to] = ends else { return false };
    let along = |a: f64, b: f64, k: i32| a + (b - a) * f64::from(k) / 32.0;
    (0..=32).any(|k| {
        let (x, y) = (along(from.0, to.0, k), along(from.1, to.1, k));
        (space.left..=space.right).contains(&x) && (space.top..=space.bottom).contains(&y)
    })
}
