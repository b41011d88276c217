//! Slides: a port is guided along a line of the ground by a block, as the cross-head of a crank drive is.

use crate::draw::{axis_along, density, handle_of, named_point, place_of, point_of};
use crate::gesture::Drawn;
use crate::insert::{Insertion, Section, Words};
use crate::names::{GROUND, PortName};
use crate::number::degrees;
use crate::picture::{Picture, Point, between};
use crate::refusal::Refusal;
use crate::rules::FINE;
use crate::sheet::Sheet;

/// Corners of a block around its pin, mm, with the rail along x.
const CORNERS: [[i32; 2]; 4] = [[-15, -10], [15, -10], [15, 10], [-15, 10]];

/// A rail of the ground through a port, toward a point, and a block on it to which the port is pinned.
///
/// # Errors
/// The text has no such port, or the ground holds it already; the point says no direction.
pub(crate) fn slide(
    sheet: &Sheet<'_>,
    picture: &Picture,
    port: &PortName,
    toward: Point,
    grid: f64,
) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let handle = handle_of(&handles, port)?;
    if let Some(held) = sheet.pin(port).iter().find(|of| of.is_of_ground()) {
        return Err(Refusal::Same(port.clone(), held.clone()));
    }
    let at = place_of(picture, port)?;
    let [dx, dy] = between(at, toward);
    if dx.hypot(dy) < FINE * grid {
        return Err(Refusal::NoLength);
    }
    // A line has two directions; the one to the right is written, or the one upwards.
    let (dx, dy) = if dx < 0.0 || (dx == 0.0 && dy < 0.0) { (-dx, -dy) } else { (dx, dy) };
    let axis = axis_along([dx, dy]);
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let density = density(sheet, &words, &mut insertion);
    let point = match point_of(handle) {
        Some(name) => name.to_owned(),
        None => named_point(at, grid, &mut words, &mut insertion),
    };
    let [rail, block, pin, slide] = ["g", "slider", "pin", "slide"].map(|stem| words.fresh(stem));
    insertion.put(Section::Things, format!("ground {{ port {rail}: {point}{axis}; }}"));
    insertion.put(
        Section::Things,
        format!(
            "body {block} {{ coordinates: absolute; thickness: 5 mm; density: {density}; contour: {}; port a: {point}{axis}; }}",
            corners(&point, [dx, dy])
        ),
    );
    insertion.put(Section::Joints, format!("revolute {pin}({port}, {block}.a);"));
    insertion.put(Section::Joints, format!("prismatic {slide}({GROUND}.{rail}, {block}.a);"));
    let made = vec![format!("{GROUND}.{rail}"), block, pin, slide];
    Ok(Drawn { edits: insertion.edits(sheet)?, made, ..Drawn::default() })
}

/// The corners of a block at a point, along a direction.
fn corners(point: &str, [x, y]: Point) -> String {
    let turn = degrees(y.atan2(x));
    let corner = |[x, y]: [i32; 2]| match turn.as_str() {
        "0" => format!("{point} + ({x}, {y}) mm"),
        _ => format!("{point} + turn(({x}, {y}) mm, {turn} deg)"),
    };
    CORNERS.map(corner).join(", ")
}
