//! Typed dimensions: numbers of a pin by the keyboard, which are written as they were typed.

use plm_compiler::units::unit;

use crate::names::PortName;
use crate::number::{Change, Literal};
use crate::picture::{Picture, Placed, Point, between};
use crate::refusal::Refusal;
use crate::rules::{Bar, Drag, drag};
use crate::sheet::{Axes, Handle, Place, Sheet, unit_named};

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
    (placed, numbers): (&Placed, &[Literal; 2]),
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
        let (_, value) = read(&of.text, &numbers[0])?;
        return around(end.at, value * numbers[0].factor(), along[1].atan2(along[0]));
    }
    let degrees = Literal { unit: unit_named("deg"), ..numbers[0].clone() };
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
    let numbers = match &handle.place {
        Place::Numbers { numbers, .. } => numbers,
        Place::Expression(text) => {
            return Err(Refusal::Expression { port: of.port.clone(), text: text.clone() });
        }
    };
    let (to, typed) = match of.dimension {
        Dimension::X | Dimension::Y => {
            let axis = usize::from(of.dimension == Dimension::Y);
            let (token, value) = read(&of.text, &numbers[axis])?;
            let mut to = placed.at;
            to[axis] = value * numbers[axis].factor();
            let stands = handle.axes == Axes::Absolute || is_as_drawn(handle.axes, placed, numbers);
            (to, token.filter(|_| stands).map(|token| (numbers[axis].clone(), token)))
        }
        Dimension::Length | Dimension::Angle => match Bar::of(sheet, &handles, handle) {
            Some(bar) => of_bar(&bar, picture, placed, of)?,
            None => (of_line(&handles, handle, picture, (placed, numbers), of)?, None),
        },
    };
    let drag_to = Drag { port: of.port.clone(), to, grid: of.grid, free: false };
    let mut changes = drag(sheet, picture, &drag_to)?.changes;
    if let Some((literal, token)) = typed {
        let written = Change::written(&literal, Some(token));
        match changes.iter_mut().find(|change| change.literal.range == literal.range) {
            Some(change) => *change = written,
            None => changes.push(written),
        }
    }
    Ok(changes)
}
