//! Lines of reference and their labels.

use plotters::style::text_anchor::{HPos, VPos};

use super::Frame;
use super::panel::Plot;
use super::pen::{Canvas, Outcome, Pen, TEXT, text, text_width, units};
use crate::chart::Panel;
use crate::chart::axis::Ruler;
use crate::chart::series::At;

const ROW: f64 = 18.0;

/// The labels of upright lines, in rows above the frame: no two of a row touch.
pub(super) type Rows = Vec<Vec<Label>>;

/// A text and its middle, in units.
pub(super) struct Label {
    text: String,
    middle: i32,
}

impl Label {
    fn half(&self) -> i32 {
        units(0.5 * text_width(&self.text, TEXT)) + units(4.0)
    }
}

/// Each label goes to the lowest row that has room for it.
pub(super) fn rows(panel: &Panel, x: &Ruler, left: i32, right: i32) -> Rows {
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

pub(super) fn draw_labels(rows: &Rows, plot: &Plot, canvas: &Canvas) -> Outcome {
    let style = text(TEXT, HPos::Center, VPos::Center);
    for (index, row) in rows.iter().enumerate() {
        let middle = plot.frame.top - units(ROW * (index as f64 + 0.5));
        for label in row {
            canvas.draw_text(&label.text, &style, (label.middle, middle))?;
        }
    }
    Ok(())
}

/// The lines, and the labels of level ones.
pub(super) fn draw(plot: &Plot, canvas: &Canvas) -> Outcome {
    let (Frame { left, right, top, bottom }, pen) = (plot.frame, Pen::rule());
    for rule in plot.panel.rules.iter().filter(|rule| plot.shows(rule.at)) {
        match rule.at {
            At::X(x) => {
                let column = plot.column(x);
                pen.path(&[(column, top), (column, bottom)], 1.0, canvas)?;
            }
            At::Y(y) => {
                let row = plot.row(y);
                pen.path(&[(left, row), (right, row)], 1.0, canvas)?;
                let (horizontal, place) = quiet_place(plot, &rule.label, row);
                canvas.draw_text(&rule.label, &text(TEXT, horizontal, VPos::Center), place)?;
            }
        }
    }
    Ok(())
}

/// Above or below the line, at its left or right end: where the fewest curves pass.
fn quiet_place(plot: &Plot, label: &str, row: i32) -> (HPos, (i32, i32)) {
    let Frame { left, right, top, bottom } = plot.frame;
    let (width, height, blank) = (units(text_width(label, TEXT)), units(ROW), units(6.0));
    let mut curves: Vec<_> = plot.panel.series.iter().flat_map(|series| plot.lines(series)).collect();
    let upright = plot.panel.rules.iter().filter_map(|rule| rule.at.x()).map(|x| plot.column(x));
    curves.extend(upright.map(|column| vec![(column, top), (column, row), (column, bottom)]));
    let mut best = (usize::MAX, (HPos::Left, (left + blank, row - height / 2)));
    for (from, to) in [(row - height, row), (row, row + height)] {
        let ends = [
            (HPos::Right, right - blank - width, right - blank),
            (HPos::Left, left + blank, left + blank + width),
        ];
        for (horizontal, start, end) in ends {
            if from < top || to > bottom {
                continue;
            }
            let space = Frame { left: start, right: end, top: from, bottom: to };
            let passing = curves.iter().flat_map(|path| path.windows(2)).filter(|ends| passes(ends, space));
            let crossed = passing.count();
            if crossed < best.0 {
                let anchor = if matches!(horizontal, HPos::Right) { end } else { start };
                best = (crossed, (horizontal, (anchor, i32::midpoint(from, to))));
            }
        }
    }
    best.1
}

/// Whether a straight piece of a curve comes into a box, tried at points along it.
fn passes(ends: &[(i32, i32)], space: Frame) -> bool {
    let [from, to] = ends else { return false };
    let along = |a: i32, b: i32, k: i32| a + (b - a) * k / 32;
    (0..=32).any(|k| {
        let (x, y) = (along(from.0, to.0, k), along(from.1, to.1, k));
        (space.left..=space.right).contains(&x) && (space.top..=space.bottom).contains(&y)
    })
}
