//! Outlines of DXF drawings (AutoCAD DXF Reference): lines, arcs, circles and polylines, as contour and holes of a body.

mod entities;
mod loops;

use std::rc::Rc;

use self::entities::Drawing;
use crate::Imported;
use crate::notice::{Notices, Place};
use crate::outline::area;

/// The contour of a body, and its holes, from the outlines of a DXF drawing: lines of a `body` block.
///
/// The largest closed outline is the contour; those within it are holes. Arcs become corners at every 5 degrees or less. `name` is the name
/// of the file in notices and in the text.
pub fn outline(name: &str, text: &str) -> Imported {
    let mut notices = Notices::default();
    let text = written(name, text, &mut notices).filter(|_| !notices.has_errors());
    Imported { text, notices: notices.0 }
}

fn written(name: &str, text: &str, notices: &mut Notices) -> Option<String> {
    let file: Rc<str> = Rc::from(name);
    let drawing = Drawing::read(&file, text, notices)?;
    let start = Place { file, line: 1, column: 1 };
    let (unit, scale) = unit(drawing.unit, &start, notices)?;
    let mut outlines = loops::closed(drawing.chains, notices)?;
    outlines.sort_by(|a, b| area(&b.points).abs().total_cmp(&area(&a.points).abs()));
    let Some(contour) = outlines.first() else {
        notices.error(&start, "there is no outline in it");
        return None;
    };
    for hole in &outlines[1..] {
        if !loops::is_within(hole.points[0], &contour.points) {
            notices
                .error(&hole.place, "this outline lies outside of the largest one: a body has one contour");
        }
    }
    let counter_clockwise = outlines.iter().map(|outline| {
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

/// The unit of the language for `$INSUNITS`, and the factor to it.
fn unit(code: Option<i64>, place: &Place, notices: &mut Notices) -> Option<(&'static str, f64)> {
    match code {
        Some(4) => Some(("mm", 1.0)),
        Some(5) => Some(("cm", 1.0)),
        Some(6) => Some(("m", 1.0)),
        Some(13) => Some(("um", 1.0)),
        // Inches and feet.
        Some(1) => Some(("mm", 25.4)),
        Some(2) => Some(("mm", 304.8)),
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
