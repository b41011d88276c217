//! Reasons why a gesture changes nothing.

use std::fmt;

use crate::names::PortName;

/// A gesture that has no edit.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The text has no mechanism.
    NoMechanism,
    /// The text has no such thing.
    Unknown(String),
    /// The picture has no such port.
    NotShown(PortName),
    /// A port stands where an expression says.
    Expression {
        /// The port.
        port: PortName,
        /// The expression.
        text: String,
    },
    /// A length would be zero.
    NoLength,
    /// Prescribed angles and locked dimensions leave the pin no way to go.
    Held(PortName),
    /// A lock holds it already.
    Locked(String),
    /// No lock holds it.
    NotLocked(String),
    /// Several places name the parameter, so that it is no dimension of one.
    Shared(String),
    /// Both stand on one body, or are one pin already.
    Same(PortName, PortName),
    /// No name can be this.
    NoName(String),
    /// Something has this name already.
    Taken(String),
    /// A motion of the body is prescribed already.
    Driven(String),
    /// Not two bars meet in the pin.
    NoDyad(PortName),
    /// The value of a parameter is no number.
    Formula(String),
    /// A repetition makes the body, so that what it gets all of its turns would get.
    Repeated(String),
    /// Typed text is no number in a unit that fits.
    NoNumber(String),
    /// The body is no bar between two ports, or its angle has no number.
    NoBar(PortName),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::NoMechanism => write!(f, "the text has no mechanism"),
            Refusal::Unknown(name) => write!(f, "the text has no `{name}`"),
            Refusal::NotShown(port) => write!(f, "the picture has no `{port}`"),
            Refusal::Expression { port, text } => {
                write!(f, "`{port}` stands at `{text}`, which is no pair of numbers: it is moved in the text")
            }
            Refusal::NoLength => write!(f, "the two points are one"),
            Refusal::Held(port) => {
                write!(f, "prescribed angles and locks hold the pin of `{port}`: open one")
            }
            Refusal::Locked(what) => write!(f, "{what} is locked already: its parameter has the value"),
            Refusal::NotLocked(what) => write!(f, "{what} is not locked"),
            Refusal::Shared(name) => {
                write!(f, "`{name}` is named in several places: it is taken apart in the text")
            }
            Refusal::Same(one, other) => write!(f, "`{one}` and `{other}` are of one body or of one pin"),
            Refusal::NoName(name) => write!(
                f,
                "`{name}` is no name: a name is a word of letters, digits and `_`, and none of the language"
            ),
            Refusal::Taken(name) => write!(f, "the text has a `{name}` already"),
            Refusal::Driven(body) => write!(f, "the motion of `{body}` is prescribed already"),
            Refusal::NoDyad(port) => {
                write!(f, "`{port}` is no pin of two bars alone, which could be mirrored")
            }
            Refusal::Formula(name) => {
                write!(f, "the value of `{name}` is a formula: it is changed in the text")
            }
            Refusal::Repeated(body) => write!(f, "a repetition makes `{body}`: it is changed in the text"),
            Refusal::NoNumber(text) => write!(f, "`{text}` is no number in a unit that fits here"),
            Refusal::NoBar(port) => {
                write!(f, "`{port}` is no end of a bar whose length and angle are numbers")
            }
        }
    }
}

impl std::error::Error for Refusal {}
