//! Outlines of DXF drawings (AutoCAD DXF Reference) as contour and holes of a body.

mod curves;
mod drawing;
mod entities;
mod groups;
mod loops;
mod place;

use std::rc::Rc;

pub use self::groups::drawing_text;

use self::drawing::Drawing;
use self::entities::Chain;
use crate::Imported;
use crate::notice::{Notices, Place};
use crate::number::length;
use crate::outline::area;

/// Selection of parts of a drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// Layers by their names; all where there is none.
    pub layers: Vec<String>,
    /// Of several bodies side by side the one with this number, from 1, the largest first.
    pub part: Option<usize>,
    /// Ends that are apart by no more than this meet, in the unit of the drawing.
    pub gap: f64,
}

/// The contour of a body, and its holes, from the outlines of a DXF drawing: lines of a `body` block.
///
/// The largest closed outline is the contour; those within it are holes. Curves become corners at every 5 degrees or less. `name` is the
/// name of the file in notices and in the text; [`drawing_text`] gives the text of a file's bytes.
pub fn outline(name: &str, text: &str, selection: &Selection) -> Imported {
    let mut notices = Notices::default();
    let text = written(name, text, selection, &mut notices).filter(|_| !notices.has_errors());
    Imported { text, notices: notices.0 }
}

fn written(name: &str, text: &str, selection: &Selection, notices: &mut Notices) -> Option<String> {
    let file: Rc<str> = Rc::from(name);
    let drawing = Drawing::read(&file, text, &selection.layers, notices)?;
    let start = Place { file, line: 1, column: 1 };
    let (unit, scale) = unit(drawing.unit, &start, notices)?;
    let known: Vec<&str> = drawing.layers.iter().map(String::as_str).collect();
    let has = |name: &String| known.iter().any(|own| own.eq_ignore_ascii_case(name));
    if let Some(missing) = selection.layers.iter().find(|name| !has(name)) {
        notices
            .error(&start, format!("there is nothing on a layer `{missing}`; layers: {}", known.join(", ")));
        return None;
    }
    let several = if known.len() > 1 { known.join(", ") } else { String::new() };
    let Some(outlines) = loops::closed(drawing.chains, selection.gap, notices) else {
        if selection.layers.is_empty() && !several.is_empty() {
            notices.warn(&start, format!("`--layer NAME` takes one of these layers alone: {several}"));
        }
        return None;
    };
    let parts = parts(outlines);
    let part = chosen(&parts, selection, (&start, &several), notices)?;
    let counter_clockwise = part.iter().map(|outline| {
        let mut points: Vec<[f64; 2]> =
            outline.points.iter().map(|point| point.map(|part| scale * part)).collect();
        if area(&points) < 0.0 {
            points.reverse();
        }
        points
    });
    let outlines: Vec<_> = counter_clockwise.collect();
    Some(crate::write::drawing(crate::file_name(name), &outlines, unit))
}

/// Bodies, the largest first: each a contour, and the holes in it. What stands within a hole is a body again.
fn parts(mut outlines: Vec<Chain>) -> Vec<Vec<Chain>> {
    outlines.sort_by(|a, b| area(&b.points).abs().total_cmp(&area(&a.points).abs()));
    let mut parts: Vec<Vec<Chain>> = Vec::new();
    let mut places: Vec<Option<usize>> = Vec::new();
    for (k, outline) in outlines.iter().enumerate() {
        // The smallest that it lies within; a contour may hold holes.
        let around = (0..k).rev().find(|&other| loops::is_within(outline.points[0], &outlines[other].points));
        let part = around.and_then(|around| places[around]);
        if let Some(part) = part {
            parts[part].push(outline.clone());
            places.push(None);
        } else {
            places.push(Some(parts.len()));
            parts.push(vec![outline.clone()]);
        }
    }
    parts
}

/// The selected body, or the only one; reports the others.
fn chosen<'a>(
    parts: &'a [Vec<Chain>],
    selection: &Selection,
    (start, layers): (&Place, &str),
    notices: &mut Notices,
) -> Option<&'a [Chain]> {
    let of_layers =
        if layers.is_empty() { String::new() } else { format!("; `--layer NAME` takes one of: {layers}") };
    match (parts, selection.part) {
        ([], _) => {
            notices.error(start, format!("there is no outline in it{of_layers}"));
            None
        }
        ([only], None) => Some(only),
        (_, Some(number)) => {
            let part = number.checked_sub(1).and_then(|at| parts.get(at));
            if part.is_none() {
                notices.error(start, format!("there is no part {number}: there are {}", parts.len()));
            }
            part.map(Vec::as_slice)
        }
        (several, None) => {
            for (k, part) in several.iter().enumerate().take(MOST_TOLD) {
                notices.warn(&part[0].place, format!("part {}: {}", k + 1, shown(part)));
            }
            let count = several.len();
            notices.error(
                start,
                format!("there are {count} parts side by side: `--part NUMBER` takes one of them{of_layers}"),
            );
            None
        }
    }
}

/// Largest number of parts that are reported one by one.
const MOST_TOLD: usize = 20;

/// Size and place of a part, in the unit of the drawing.
fn shown(part: &[Chain]) -> String {
    let range = |k: usize| {
        let parts = || part[0].points.iter().map(move |point| point[k]);
        let low = parts().fold(f64::INFINITY, f64::min);
        (low, parts().fold(f64::NEG_INFINITY, f64::max) - low)
    };
    let ((x, width), (y, height)) = (range(0), range(1));
    let [x, y, width, height] = [x, y, width, height].map(|value| length((value * 1e6).round() / 1e6));
    format!("{width} x {height} from ({x}, {y}), {} holes", part.len() - 1)
}

/// The unit of the language for `$INSUNITS`, and the factor to it.
fn unit(code: Option<i64>, place: &Place, notices: &mut Notices) -> Option<(&'static str, f64)> {
    match code {
        Some(4) => Some(("mm", 1.0)),
        Some(5) => Some(("cm", 1.0)),
        Some(6) => Some(("m", 1.0)),
        Some(13) => Some(("um", 1.0)),
        Some(14) => Some(("cm", 10.0)),
        // Inches and feet, yards, mils.
        Some(1) => Some(("mm", 25.4)),
        Some(2) => Some(("mm", 304.8)),
        Some(9) => Some(("mm", 0.0254)),
        Some(10) => Some(("mm", 914.4)),
        None | Some(0) => {
            notices.warn(place, "the drawing has no unit: it is taken in mm");
            Some(("mm", 1.0))
        }
        Some(other) => {
            notices.error(place, format!("the drawing has the unit {other} ($INSUNITS), which is not taken"));
            None
        }
    }
}
