//! Typed dimensions: numbers of a pin by the keyboard, which are written as they were typed.

use plm_compiler::units::unit;

use crate::names::PortName;
use crate::number::{Change, Literal};
use crate::picture::Picture;
use crate::refusal::Refusal;
use crate::rules::{Bar, Drag, drag};
use crate::sheet::{Axes, Place, Sheet};

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
            let stands = handle.axes == Axes::Absolute || handle.axes == Axes::Drawing(placed.angle);
            (to, token.filter(|_| stands).map(|token| (numbers[axis].clone(), token)))
        }
        Dimension::Length | Dimension::Angle => {
            let bar = Bar::of(sheet, &handles, handle).ok_or_else(|| Refusal::NoBar(of.port.clone()))?;
            let end = picture.port(&bar.other).ok_or_else(|| Refusal::NotShown(bar.other.clone()))?;
            let along = [placed.at[0] - end.at[0], placed.at[1] - end.at[1]];
            let (length, angle) = (along[0].hypot(along[1]), along[1].atan2(along[0]));
            let (length, angle, typed) = if of.dimension == Dimension::Length {
                let (token, value) = read(&of.text, &bar.own)?;
                (value * bar.own.factor(), angle, bar.length_token(token.as_deref()))
            } else {
                let literal = bar.angle.clone().ok_or_else(|| Refusal::NoBar(of.port.clone()))?;
                let (token, value) = read(&of.text, &literal)?;
                let value = value * literal.factor();
                (length, value + bar.ahead(), token.map(|token| (literal, token)))
            };
            if length <= 0.0 {
                return Err(Refusal::NoLength);
            }
            ([end.at[0] + length * angle.cos(), end.at[1] + length * angle.sin()], typed)
        }
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
