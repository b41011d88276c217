//! Typed dimensions: numbers of a pin by the keyboard, which are written as they were typed.

use std::f64::consts::{PI, TAU};

use plm_compiler::units::unit;

use crate::lock;
use crate::names::PortName;
use crate::number::{Change, Literal};
use crate::picture::{Picture, Placed, Point, between};
use crate::refusal::Refusal;
use crate::rules::{Bar, FINE, Held, turn_of_axes};
use crate::sheet::{Axes, Handle, Place, Polar, Sheet, unit_named};

/// Poses that differ by less, m or rad, are one.
const ROUNDING: f64 = 1e-9;

/// A dimension that is typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    /// A port of the pin.
    pub port: PortName,
    /// Which dimension.
    pub dimension: Dimension,
    /// The text that was typed: a number in the unit that stands in the text, or one with a unit of its own.
    pub text: String,
    /// The step of the picture, m.
    pub grid: f64,
}

/// Dimensions of a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Its place along the x axis.
    X,
    /// Its place along the y axis.
    Y,
    /// The length of its bar.
    Length,
    /// The angle of its bar.
    Angle,
}

impl Dimension {
    /// All of them.
    pub const ALL: [Dimension; 4] = [Dimension::X, Dimension::Y, Dimension::Length, Dimension::Angle];

    /// Its word.
    pub fn word(self) -> &'static str {
        ["x", "y", "length", "angle"][self as usize]
    }
}

/// A typed text in the unit of a literal: the token to write where it is one, and the value.
fn read(text: &str, literal: &Literal) -> Result<(Option<String>, f64), Refusal> {
    let no_number = || Refusal::NoNumber(text.to_owned());
    let text = text.trim();
    let split =
        text.find(|letter: char| !letter.is_ascii_digit() && !"+-.eE".contains(letter)).unwrap_or(text.len());
    let (number, name) = (text[..split].trim(), text[split..].trim());
    let value: f64 = number.parse().map_err(|_| no_number())?;
    // Rust's words for what is not finite are no numbers.
    if !value.is_finite()
        || !number.ends_with(|letter: char| letter.is_ascii_digit())
        || number.starts_with('+')
    {
        return Err(no_number());
    }
    if name.is_empty() {
        return Ok((Some(number.to_owned()), value));
    }
    let unit = unit(name).filter(|unit| unit.dimension.same(literal.unit.dimension)).ok_or_else(no_number)?;
    let own = value * unit.factor().to_f64() / literal.factor();
    Ok((if name == literal.unit.text { Some(number.to_owned()) } else { None }, own))
}

/// A number that is written as it was typed, where there is one.
type Token = Option<(Literal, String)>;

/// A point at a length and an angle from another one.
fn around(end: Point, length: f64, angle: f64) -> Result<Point, Refusal> {
    if length <= 0.0 {
        return Err(Refusal::NoLength);
    }
    Ok([end[0] + length * angle.cos(), end[1] + length * angle.sin()])
}

/// The place of an end of a bar, and the number that says the dimension.
fn of_bar(bar: &Bar, picture: &Picture, placed: &Placed, of: &Typed) -> Result<(Point, Token), Refusal> {
    let end = picture.port(&bar.other).ok_or_else(|| Refusal::NotShown(bar.other.clone()))?;
    let along = between(end.at, placed.at);
    if of.dimension == Dimension::Length {
        let (token, value) = read(&of.text, &bar.own)?;
        let to = around(end.at, value * bar.own.factor(), along[1].atan2(along[0]))?;
        return Ok((to, bar.length_token(token.as_deref())));
    }
    let literal = bar.angle.clone().ok_or_else(|| Refusal::NoBar(of.port.clone()))?;
    let (token, value) = read(&of.text, &literal)?;
    let to = around(end.at, along[0].hypot(along[1]), value * literal.factor() + bar.ahead())?;
    Ok((to, token.map(|token| (literal, token))))
}

/// The place of an end of a body with two ports that stand in a drawing, where no number says the dimension: the length is in the unit
/// of the place, the angle in degrees from the x axis.
fn of_line(
    handles: &[Handle<'_>],
    handle: &Handle<'_>,
    picture: &Picture,
    (placed, unit): (&Placed, &Literal),
    of: &Typed,
) -> Result<Point, Refusal> {
    let others: Vec<_> = handles
        .iter()
        .filter(|other| other.name.owner == handle.name.owner && other.name != handle.name)
        .collect();
    let ([other], Axes::Drawing(_)) = (&others[..], handle.axes) else {
        return Err(Refusal::NoBar(of.port.clone()));
    };
    let end = picture.port(&other.name).ok_or_else(|| Refusal::NotShown(other.name.clone()))?;
    let along = between(end.at, placed.at);
    if of.dimension == Dimension::Length {
        let (_, value) = read(&of.text, unit)?;
        return around(end.at, value * unit.factor(), along[1].atan2(along[0]));
    }
    let degrees = Literal { unit: unit_named("deg"), ..unit.clone() };
    let (_, value) = read(&of.text, &degrees)?;
    around(end.at, along[0].hypot(along[1]), value * degrees.factor())
}

/// Does a port stand where its numbers say, in axes that are not turned? Assembly may move a drawing by its rounding.
fn is_as_drawn(axes: Axes, placed: &Placed, numbers: &[Literal; 2]) -> bool {
    let Axes::Drawing(angle) = axes else { return false };
    let away = between(placed.at, numbers.each_ref().map(Literal::si));
    (placed.angle - angle).abs() < ROUNDING && away[0].hypot(away[1]) < ROUNDING
}

/// The numbers that a typed dimension changes.
///
/// # Errors
/// The text is no number that fits, or the pin cannot go there.
pub(crate) fn changes(sheet: &Sheet<'_>, picture: &Picture, of: &Typed) -> Result<Vec<Change>, Refusal> {
    let handles = sheet.handles();
    let handle = handles.iter().find(|handle| handle.name == of.port);
    let handle = handle.ok_or_else(|| Refusal::Unknown(of.port.to_string()))?;
    let placed = picture.port(&of.port).ok_or_else(|| Refusal::NotShown(of.port.clone()))?;
    let is_of_bar = matches!(of.dimension, Dimension::Length | Dimension::Angle);
    if let Some((polar, is_own)) = lock::polar_of(&handles, handle).filter(|_| is_of_bar) {
        return Ok(vec![of_polar(polar, is_own, turn_of_axes(handle.axes, placed.angle), of)?]);
    }
    // A length that is two numbers is none, and typed all the same.
    let known = lock::number_of(sheet, &handles, handle, of.dimension).ok().flatten();
    if let Some(literal) = known.filter(|of| of.is_locked) {
        let (token, value) = read(&of.text, &literal)?;
        return Ok(vec![match token {
            Some(token) => Change::written(&literal, Some(token)),
            None => Change::new(&literal, value * literal.factor(), FINE * of.grid),
        }]);
    }
    let (to, typed) = wanted(sheet, picture, of, (&handles, handle, placed))?;
    let held = Held::take(sheet, picture, &of.port, false)?;
    let dragged = held.changes(to, of.grid)?;
    let away = between(dragged.to, to);
    if held.has_locks() && away[0].hypot(away[1]) > FINE * of.grid {
        return Err(Refusal::Held(of.port.clone()));
    }
    let mut changes = dragged.changes;
    if let Some((literal, token)) = typed {
        let written = Change::written(&literal, Some(token));
        match changes.iter_mut().find(|change| change.literal.range == literal.range) {
            Some(change) => *change = written,
            None => changes.push(written),
        }
    }
    Ok(changes)
}

/// The place to which a typed dimension asks the pin, and the number that says it as it was typed.
fn wanted(
    sheet: &Sheet<'_>,
    picture: &Picture,
    of: &Typed,
    (handles, handle, placed): (&[Handle<'_>], &Handle<'_>, &Placed),
) -> Result<(Point, Token), Refusal> {
    let (numbers, literal) = match &handle.place {
        Place::Numbers { numbers, .. } => (Some(&**numbers), numbers.each_ref()),
        Place::Polar { polar, .. } => (None, [&polar.length; 2]),
        Place::Expression(text) => {
            return Err(Refusal::Expression { port: of.port.clone(), text: text.clone() });
        }
    };
    Ok(match of.dimension {
        Dimension::X | Dimension::Y => {
            let axis = usize::from(of.dimension == Dimension::Y);
            let (token, value) = read(&of.text, literal[axis])?;
            let mut to = placed.at;
            to[axis] = value * literal[axis].factor();
            let stands = |numbers: &&[Literal; 2]| {
                handle.axes == Axes::Absolute || is_as_drawn(handle.axes, placed, numbers)
            };
            (to, numbers.filter(stands).and(token).map(|token| (literal[axis].clone(), token)))
        }
        Dimension::Length | Dimension::Angle => match Bar::of(sheet, handles, handle) {
            Some(bar) => of_bar(&bar, picture, placed, of)?,
            None => (of_line(handles, handle, picture, (placed, literal[0]), of)?, None),
        },
    })
}

/// The length or the angle of a bar one end of which stands at the other one.
fn of_polar(polar: &Polar, is_own: bool, turn: f64, of: &Typed) -> Result<Change, Refusal> {
    let is_angle = of.dimension == Dimension::Angle;
    let literal = if is_angle { &polar.angle } else { &polar.length };
    let (token, value) = read(&of.text, literal)?;
    let si = value * literal.factor();
    let near = |angle: f64| angle + ((literal.si() - angle) / TAU).round() * TAU;
    if !is_angle && si <= 0.0 {
        return Err(Refusal::NoLength);
    }
    // From the other end it looks back.
    let back = if is_own || !is_angle { 0.0 } else { PI };
    let away = if is_angle { turn + back } else { 0.0 };
    Ok(match token.filter(|_| away.abs() < ROUNDING) {
        Some(token) => Change::written(literal, Some(token)),
        None if is_angle => Change::new(literal, near(si - away), FINE * of.grid),
        None => Change::new(literal, si, FINE * of.grid),
    })
}
