//! Mirror: the pin of two bars goes to the other side of the line between their other ends, as the other branch of the loop has it.

use crate::names::PortName;
use crate::picture::{Picture, Point, between, on_ray};
use crate::refusal::Refusal;
use crate::rules::{Drag, FINE};
use crate::sheet::Sheet;

/// The drag of a pin to its mirror image.
///
/// # Errors
/// Not two bars meet in the pin, or their other ends are one point.
pub(crate) fn image(
    sheet: &Sheet<'_>,
    picture: &Picture,
    port: &PortName,
    grid: f64,
) -> Result<Drag, Refusal> {
    let handles = sheet.handles();
    let pin = sheet.pin(port);
    let place = |of: &PortName| -> Result<Point, Refusal> {
        Ok(picture.port(of).ok_or_else(|| Refusal::NotShown(of.clone()))?.at)
    };
    let mut ends = Vec::new();
    for of in &pin {
        let here = place(of)?;
        let mut others = Vec::new();
        for handle in handles.iter().filter(|handle| handle.name.owner == of.owner) {
            // A slot of the bar stands where an end does.
            let at = place(&handle.name)?;
            if !others.iter().chain([&here]).any(|known| is_same(*known, at, grid)) {
                others.push(at);
            }
        }
        match others[..] {
            [other] if !of.is_of_ground() => ends.push(other),
            _ => return Err(Refusal::NoDyad(port.clone())),
        }
    }
    let [from, through] = ends[..] else { return Err(Refusal::NoDyad(port.clone())) };
    if is_same(from, through, grid) {
        return Err(Refusal::NoLength);
    }
    let at = place(port)?;
    let [dx, dy] = between(at, on_ray(from, through, at));
    Ok(Drag { port: port.clone(), to: [at[0] + 2.0 * dx, at[1] + 2.0 * dy], grid, free: false })
}

fn is_same(one: Point, other: Point, grid: f64) -> bool {
    let [dx, dy] = between(one, other);
    dx.hypot(dy) < FINE * grid
}
