//! Ports: a body gets another pin where a hand puts it, and a slot along its bar.

use crate::draw::{axis_along, handle_of, named_point, new_ground, place_of, point_at, point_of};
use crate::edit::Edit;
use crate::gesture::{Drawn, End};
use crate::insert::{Insertion, Section, Words};
use crate::names::PortName;
use crate::picture::{Picture, Point, between, turned};
use crate::refusal::Refusal;
use crate::remove::statement;
use crate::rules::{FINE, turn_of_axes};
use crate::sheet::{Axes, Handle, Sheet};

/// Names of ports, in their order.
const LETTERS: &str = "abcdefghijklmnopqrstuw";

/// The body of a gesture: its ports in the text.
fn ports_of<'a, 's>(handles: &'a [Handle<'s>], body: &str) -> Result<Vec<&'a Handle<'s>>, Refusal> {
    let own: Vec<&Handle> =
        handles.iter().filter(|of| of.name.owner == body && !of.name.is_of_ground()).collect();
    match own.first() {
        Some(first) if first.turns == 1 => Ok(own),
        Some(_) => Err(Refusal::Repeated(body.to_owned())),
        None => Err(Refusal::Unknown(body.to_owned())),
    }
}

/// A port behind the last one of a body, which is written there.
fn behind_ports(sheet: &Sheet<'_>, own: &[&Handle<'_>], text: &str) -> Result<Edit, Refusal> {
    let port = own.first().and_then(|first| first.body).and_then(|body| body.ports.last());
    let last = statement(sheet, port.ok_or(Refusal::NoMechanism)?);
    let line = sheet.text[..last.start].rfind('\n').map_or(0, |at| at + 1);
    let before = &sheet.text[line..last.start];
    // Ports that have lines of their own keep them.
    let between = if before.trim().is_empty() { format!("\n{before}") } else { " ".to_owned() };
    Ok(Edit::insertion(last.end, format!("{between}{text}")))
}

/// A name that no port of the body has.
fn fresh(own: &[&Handle<'_>], begins: &str) -> String {
    let is_free = |name: &String| !own.iter().any(|of| of.name.port == *name);
    let letters = begins.chars().chain(LETTERS.chars()).map(String::from);
    let numbered = (1..).map(|number| format!("{begins}{number}"));
    letters.chain(numbered).find(is_free).unwrap_or_default()
}

/// A port of a body at a place; at a port of another one it is pinned to that, at the ground to the ground.
///
/// # Errors
/// The text has no such body, or a repetition makes it; a port of it stands there already, or none of its places has numbers.
pub(crate) fn put(
    sheet: &Sheet<'_>,
    picture: &Picture,
    body: &str,
    end: &End,
    grid: f64,
) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let own = ports_of(&handles, body)?;
    let at = match end {
        End::Point(at) | End::Ground(at) => *at,
        End::Port(port) => place_of(picture, port)?,
    };
    for port in &own {
        let [dx, dy] = between(place_of(picture, &port.name)?, at);
        if dx.hypot(dy) < FINE * grid {
            return Err(Refusal::NoLength);
        }
    }
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let name = PortName::new(body, fresh(&own, "c"));
    let known = match end {
        End::Port(port) => point_of(handle_of(&handles, port)?),
        _ => None,
    };
    let is_drawn = own.iter().all(|port| port.axes == Axes::Drawing(0.0));
    let place = match known.filter(|_| is_drawn) {
        Some(point) => point.to_owned(),
        None if is_drawn => named_point(at, grid, &mut words, &mut insertion),
        None => own_place(picture, &own, at, grid)?,
    };
    let edit = behind_ports(sheet, &own, &format!("port {}: {place};", name.port))?;
    let mut made = vec![name.to_string()];
    let other = match end {
        End::Point(_) => None,
        End::Ground(at) => {
            let point = if is_drawn { place } else { point_at(*at, grid) };
            Some(new_ground(&point, &mut words, &mut insertion, "").0)
        }
        End::Port(port) => Some(port.to_string()),
    };
    if let Some(other) = other {
        let pin = words.fresh("pin");
        insertion.put(Section::Joints, format!("revolute {pin}({other}, {name});"));
        made.push(pin);
    }
    let mut edits = insertion.edits(sheet)?;
    edits.push(edit);
    Ok(Drawn { edits, made, ..Drawn::default() })
}

/// A place in the axes of a body, from a port of it that has numbers.
fn own_place(picture: &Picture, own: &[&Handle<'_>], at: Point, grid: f64) -> Result<String, Refusal> {
    for handle in own {
        let Some([x, y]) = handle.place.at() else { continue };
        let placed = picture.port(&handle.name).ok_or_else(|| Refusal::NotShown(handle.name.clone()))?;
        let by = turned(between(placed.at, at), -turn_of_axes(handle.axes, placed.angle));
        return Ok(point_at([x + by[0], y + by[1]], grid));
    }
    Err(Refusal::NoBar(own[0].name.clone()))
}

/// A slot along a bar, from its first port to the next, in which a port of another body slides.
///
/// # Errors
/// The text has no such body or port, or they are of one pin; the body has no two ports that are apart.
pub(crate) fn groove(
    sheet: &Sheet<'_>,
    picture: &Picture,
    port: &PortName,
    body: &str,
    grid: f64,
) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let (own, _) = (ports_of(&handles, body)?, handle_of(&handles, port)?);
    if let Some(shared) = sheet.pin(port).into_iter().find(|of| of.owner == body) {
        return Err(Refusal::Same(port.clone(), shared));
    }
    let from = own[0];
    let at = picture.port(&from.name).ok_or_else(|| Refusal::NotShown(from.name.clone()))?;
    let mut along = None;
    for other in &own[1..] {
        let [dx, dy] = between(at.at, place_of(picture, &other.name)?);
        if dx.hypot(dy) >= FINE * grid {
            along = Some((*other, [dx, dy]));
            break;
        }
    }
    let (to, along) = along.ok_or_else(|| Refusal::NoBar(from.name.clone()))?;
    let axis = if let Some((from, to)) = point_of(from).zip(point_of(to)) {
        format!(", axis: {to} - {from}")
    } else {
        axis_along(turned(along, -turn_of_axes(from.axes, at.angle)))
    };
    let written = from.body.and_then(|of| of.ports.first()).ok_or(Refusal::NoMechanism)?;
    let place = sheet.text_of(written.at.span);
    let name = PortName::new(body, fresh(&own, "s"));
    let edit = behind_ports(sheet, &own, &format!("port {}: {place}{axis};", name.port))?;
    let (mut words, mut insertion) = (Words::of(sheet.text), Insertion::default());
    let slide = words.fresh("slide");
    insertion.put(Section::Joints, format!("pin_slot {slide}({name}, {port});"));
    let mut edits = insertion.edits(sheet)?;
    edits.push(edit);
    Ok(Drawn { edits, made: vec![name.to_string(), slide], ..Drawn::default() })
}
