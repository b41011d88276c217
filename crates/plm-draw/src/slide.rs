//! Slides: a port is guided along a line of the ground, as the cross-head of a crank drive is.

use crate::draw::{axis_along, handle_of, place_of, point_at, point_of};
use crate::gesture::Drawn;
use crate::insert::{Insertion, Section, Words};
use crate::names::{GROUND, PortName};
use crate::picture::{Picture, Point, between};
use crate::refusal::Refusal;
use crate::rules::FINE;
use crate::sheet::Sheet;

/// A rail of the ground through a port, toward a point, and the slot that holds the port on it.
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
    let point = point_of(handle).map_or_else(|| point_at(at, grid), str::to_owned);
    let rail = words.fresh("g");
    insertion.put(Section::Things, format!("ground {{ port {rail}: {point}{axis}; }}"));
    let name = words.fresh("slide");
    insertion.put(Section::Joints, format!("pin_slot {name}({GROUND}.{rail}, {port});"));
    Ok(Drawn {
        edits: insertion.edits(sheet)?,
        made: vec![format!("{GROUND}.{rail}"), name],
        ..Drawn::default()
    })
}
