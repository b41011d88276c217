//! Locks: a dimension becomes a parameter, which is set by its slider or typed, and which a drag keeps.
//!
//! A number of a place is one already. The length and the angle of a bar between two points of a drawing are none: the point is written
//! as one at a length and an angle from the other, `p1 + turn((bar1_length, 0 mm), 56.31 deg)`.

use crate::draw::handle_of;
use crate::edit::Edit;
use crate::gesture::Drawn;
use crate::insert::{LEVEL, Words, indentation, opening};
use crate::lift::{declaration, replaced};
use crate::names::PortName;
use crate::number::{Literal, rounded};
use crate::picture::{Point, between};
use crate::refusal::Refusal;
use crate::rules::Bar;
use crate::sheet::{Axes, Handle, Place, Polar, Sheet, mentions};
use crate::typed::Dimension;

/// Lengths are written to a micrometre, angles to a ten-thousandth of a degree: a bar of a metre keeps its place to 2 um.
const LENGTH_STEP: f64 = 1e-3;
const ANGLE_STEP: f64 = 1e-4;

impl Sheet<'_> {
    /// Ports with locked dimensions, and which they are.
    pub fn locks(&self) -> Vec<(PortName, Vec<Dimension>)> {
        let handles = self.handles();
        let of = |handle: &Handle<'_>| {
            let is_locked = |dimension: &Dimension| {
                number_of(self, &handles, handle, *dimension)
                    .is_ok_and(|number| number.is_some_and(|of| of.is_locked))
            };
            let locks: Vec<Dimension> = Dimension::ALL.into_iter().filter(is_locked).collect();
            (!locks.is_empty()).then(|| (handle.name.clone(), locks))
        };
        handles.iter().filter_map(of).collect()
    }
}

/// A dimension of a port becomes a parameter of the mechanism.
///
/// # Errors
/// The text has no such port, it stands where an expression says, it has no such dimension, or the dimension is locked already.
pub(crate) fn locked(sheet: &Sheet<'_>, port: &PortName, dimension: Dimension) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let handle = handle_of(&handles, port)?;
    if let Some(literal) = number_of(sheet, &handles, handle, dimension)? {
        if literal.is_locked {
            return Err(Refusal::Locked(format!("{} of {port}", dimension.word())));
        }
        let name = fresh(sheet, handle, dimension);
        let named = [(&literal, name.as_str())];
        let edits = replaced(sheet, &named).into_values().map(|(range, new)| Edit::new(range, new)).collect();
        return with_parameter(sheet, name.clone(), &declaration(sheet, &named[0]), edits);
    }
    let (point, from) = ends(sheet, &handles, handle)?;
    let [x, y] = between(from.at, point.at);
    let (length, angle) =
        (rounded(1e3 * x.hypot(y), LENGTH_STEP), rounded(y.atan2(x).to_degrees(), ANGLE_STEP));
    let name = fresh(sheet, handle, dimension);
    let (place, declared) = if dimension == Dimension::Length {
        (
            format!("{} + turn(({name}, 0 mm), {angle} deg)", from.name),
            format!("param {name}: mm = {length} mm;"),
        )
    } else {
        (
            format!("{} + turn(({length}, 0) mm, {name})", from.name),
            format!("param {name}: deg = {angle} deg;"),
        )
    };
    with_parameter(sheet, name, &declared, vec![Edit::new(point.value, place)])
}

/// A dimension of a port is a number of its place again.
///
/// # Errors
/// The text has no such port, or the dimension is not locked; the parameter is one that other things name too.
pub(crate) fn unlocked(sheet: &Sheet<'_>, port: &PortName, dimension: Dimension) -> Result<Drawn, Refusal> {
    let handles = sheet.handles();
    let handle = handle_of(&handles, port)?;
    let free = || Refusal::NotLocked(format!("{} of {port}", dimension.word()));
    let literal =
        number_of(sheet, &handles, handle, dimension)?.filter(|of| of.is_locked).ok_or_else(free)?;
    let name = sheet.name_of_value(&literal).ok_or_else(free)?;
    let mut places = Vec::new();
    for item in sheet.items() {
        mentions(item, &mut |mention| {
            if mention.name.text == name {
                places.push(sheet.range(mention.name.span));
            }
        });
    }
    let [place] = &places[..] else { return Err(Refusal::Shared(name.to_owned())) };
    let is_of_bar = matches!(dimension, Dimension::Length | Dimension::Angle);
    let polar =
        polar_of(&handles, handle).filter(|(polar, _)| is_of_bar && !other(polar, dimension).is_locked);
    let mut edits = match polar {
        // Where neither is locked any more the point is a pair of numbers again.
        Some((polar, _)) => {
            let [x, y] = polar.at().map(|of| rounded(1e3 * of, LENGTH_STEP));
            vec![Edit::new(polar.range.clone(), format!("({x}, {y}) mm"))]
        }
        None => vec![Edit::new(place.clone(), sheet.text[literal.whole.clone()].to_owned())],
    };
    // Nothing names it any more, so that it goes alone.
    edits.extend(thing_alone(sheet, name)?);
    Ok(Drawn { edits, ..Drawn::default() })
}

/// The edits that take a parameter away whose mentions have gone.
fn thing_alone(sheet: &Sheet<'_>, name: &str) -> Result<Vec<Edit>, Refusal> {
    let own =
        sheet.items().iter().find(|item| crate::remove::declared(item).is_some_and(|of| of.text == name));
    let item = own.ok_or_else(|| Refusal::Unknown(name.to_owned()))?;
    Ok(vec![Edit::new(crate::remove::whole_line(sheet, item), "")])
}

fn other(polar: &Polar, dimension: Dimension) -> &Literal {
    if dimension == Dimension::Length { &polar.angle } else { &polar.length }
}

/// The number that says a dimension, if one does; nothing where a pair of numbers says it.
pub(crate) fn number_of(
    sheet: &Sheet<'_>,
    handles: &[Handle<'_>],
    handle: &Handle<'_>,
    dimension: Dimension,
) -> Result<Option<Literal>, Refusal> {
    let axis = match dimension {
        Dimension::X => Some(0),
        Dimension::Y => Some(1),
        Dimension::Length | Dimension::Angle => None,
    };
    let no_bar = || Refusal::NoBar(handle.name.clone());
    match (&handle.place, axis) {
        (Place::Expression(text), _) => {
            Err(Refusal::Expression { port: handle.name.clone(), text: text.clone() })
        }
        (Place::Numbers { numbers, .. }, Some(axis)) => Ok(Some(numbers[axis].clone())),
        (Place::Polar { .. }, Some(_)) => Err(Refusal::Locked(format!("a dimension of {}", handle.name))),
        (_, None) if matches!(handle.axes, Axes::Drawing(_)) => {
            let number = |(polar, _): (&Polar, bool)| match dimension {
                Dimension::Length => polar.length.clone(),
                _ => polar.angle.clone(),
            };
            Ok(polar_of(handles, handle).map(number))
        }
        (Place::Polar { .. }, None) => Err(no_bar()),
        (Place::Numbers { .. }, None) => {
            let bar = Bar::of(sheet, handles, handle).ok_or_else(no_bar)?;
            let number = if dimension == Dimension::Length { bar.length() } else { bar.angle.clone() };
            number.map(Some).ok_or_else(no_bar)
        }
    }
}

/// The length and the angle of a bar of a drawing where one of its ends stands at the other one, and whether it is this end.
pub(crate) fn polar_of<'a>(handles: &'a [Handle<'_>], handle: &'a Handle<'_>) -> Option<(&'a Polar, bool)> {
    let polar = |of: &'a Handle<'_>| match &of.place {
        Place::Polar { polar, .. } => Some(&**polar),
        _ => None,
    };
    let mut others = handles.iter().filter(|of| of.name.owner == handle.name.owner && of.name != handle.name);
    let own =
        polar(handle).filter(|own| others.clone().any(|of| drawn(of).is_some_and(|of| of.name == own.from)));
    let name = drawn(handle)?.name;
    let mut other = || others.find_map(|of| polar(of).filter(|of| of.from == name));
    own.map(|own| (own, true)).or_else(|| other().map(|of| (of, false)))
}

/// An end of a bar of a drawing: its name, its place and where the value of the name stands.
struct DrawnPoint<'s> {
    name: &'s str,
    at: Point,
    value: std::ops::Range<usize>,
}

fn drawn<'s>(handle: &Handle<'s>) -> Option<DrawnPoint<'s>> {
    match &handle.place {
        Place::Numbers { numbers, pair, through, .. } => {
            let at = numbers.each_ref().map(Literal::si);
            Some(DrawnPoint { name: (*through)?, at, value: pair.clone() })
        }
        Place::Polar { polar, value, through } => {
            Some(DrawnPoint { name: through, at: polar.at(), value: value.clone() })
        }
        Place::Expression(_) => None,
    }
}

/// The point of a bar that is written at the other one from then on, and that one. Either may be it, but not one that a lock holds
/// already, or that the other one stands at.
fn ends<'s>(
    sheet: &Sheet<'_>,
    handles: &[Handle<'s>],
    handle: &Handle<'s>,
) -> Result<(DrawnPoint<'s>, DrawnPoint<'s>), Refusal> {
    let no_bar = || Refusal::NoBar(handle.name.clone());
    let own = drawn(handle).ok_or_else(no_bar)?;
    let of_body = handles.iter().filter(|of| of.name.owner == handle.name.owner);
    let mut others: Vec<&Handle> = Vec::new();
    for of in of_body {
        let point = drawn(of).ok_or_else(no_bar)?;
        let is_known = |known: &&Handle| drawn(known).is_some_and(|known| known.name == point.name);
        if point.name != own.name && !others.iter().any(is_known) {
            others.push(of);
        }
    }
    let [other] = others[..] else { return Err(no_bar()) };
    let far = drawn(other).ok_or_else(no_bar)?;
    let is_free = |handle: &Handle<'_>| match &handle.place {
        Place::Numbers { numbers, .. } => numbers.iter().all(|number| !number.is_locked),
        _ => false,
    };
    if is_free(handle) && !sheet.stands_at(far.name, own.name) {
        return Ok((own, far));
    }
    if is_free(other) && !sheet.stands_at(own.name, far.name) {
        return Ok((far, own));
    }
    Err(Refusal::Locked(format!("a dimension of {}", handle.name)))
}

/// A name for a dimension that becomes a parameter.
fn fresh(sheet: &Sheet<'_>, handle: &Handle<'_>, dimension: Dimension) -> String {
    let is_place = matches!(dimension, Dimension::X | Dimension::Y);
    let stem = match &handle.place {
        Place::Numbers { through: Some(point), .. } if is_place => (*point).to_owned(),
        _ if is_place => format!("{}_{}", handle.name.owner, handle.name.port),
        _ => handle.name.owner.clone(),
    };
    let stem: String = stem.chars().filter(|letter| letter.is_alphanumeric() || *letter == '_').collect();
    let mut words = Words::of(sheet.text);
    let name = format!("{stem}_{}", dimension.word());
    if words.has(&name) { words.fresh(&format!("{name}_")) } else { name }
}

fn with_parameter(
    sheet: &Sheet<'_>,
    name: String,
    declared: &str,
    mut edits: Vec<Edit>,
) -> Result<Drawn, Refusal> {
    let open = opening(sheet)?;
    let indent = indentation(sheet.text, open) + LEVEL;
    edits.push(Edit::insertion(open, format!("\n{:indent$}{declared}", "")));
    Ok(Drawn { edits, made: vec![name], ..Drawn::default() })
}
