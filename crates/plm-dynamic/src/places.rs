//! Places of the numbers that functions read and write.

use plm_compiler::lowered::OfRows;
use plm_compiler::model::ContactMode;
use plm_compiler::{OfScalar, Source};
use plm_runtime::Scalar;

/// A list of numbers that functions read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum List {
    /// The time.
    Time,
    /// The parameters.
    Parameters,
    /// The inputs.
    Inputs,
    /// The sides of conditions.
    Switches,
    /// The multipliers of rows of contact.
    Multipliers,
    /// An array.
    Array(Array),
    /// Numbers that stand in no list.
    Gathered,
}

/// An array that functions read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Array {
    /// The state.
    X,
    /// The pose of all bodies.
    Q,
    /// Their velocities.
    V,
    /// Accelerations of all bodies.
    A,
    /// Multipliers.
    Lambda,
    /// Weights of coordinates.
    Weights,
    /// Residuals.
    Residuals,
    /// Rates of the state.
    Rates,
    /// Signs of the slips of rows of contact.
    Slip,
    /// Signs of reactions along a line.
    Line,
    /// Forces of rows of contact.
    Force,
    /// Accelerations of the coordinates.
    Second,
    /// Numbers that do not depend on forces of contact.
    Known,
    /// The length of a step alone.
    Step,
}

/// Source of an argument.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Argument {
    /// The time.
    Time,
    /// A parameter.
    Parameter(usize),
    /// An input.
    Input(usize),
    /// The side of a condition.
    Switch(usize),
    /// The revolutions of a count.
    Turns(usize),
    /// A number of the scalar.
    Scalar(OfScalar),
    /// A number of the continuation data of loops.
    Remembered(usize),
    /// An element of an array.
    Element(Array, usize),
    /// The multiplier of a row of contact.
    Multiplier(usize),
    /// 1 where a row of contact has this mode, else 0.
    Mode(usize, ContactMode),
    /// Nothing that a function of this crate has.
    None,
}

/// Destination of a result that is no element of an output.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place {
    /// To an entry of a matrix over the state.
    Entry(usize, usize),
    /// To a number of the continuation data of loops.
    Remembered(usize),
    /// To a number of the rows of contact.
    Rows(OfRows),
    /// To what a multiplier of one, of a row of contact, adds to a number of the rate.
    Response(usize, usize),
}

/// Numbers of the state: how many coordinates it has, and how many there is room for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room {
    pub(crate) coordinates: usize,
    pub(crate) capacity: usize,
}

impl Room {
    /// The place of a number of the state where coordinates and velocities have more room than they need.
    pub(crate) fn place(self, index: usize) -> usize {
        let Room { coordinates, capacity } = self;
        match index {
            _ if index < coordinates => index,
            _ if index < 2 * coordinates => capacity + index - coordinates,
            _ => 2 * capacity + index - 2 * coordinates,
        }
    }
}

impl Argument {
    pub(crate) fn of(source: &Source, room: Room) -> Argument {
        match *source {
            Source::Time => Argument::Time,
            Source::Parameter(k) => Argument::Parameter(k),
            Source::Input(k) => Argument::Input(k),
            Source::Switch(k) => Argument::Switch(k),
            Source::Turns(k) => Argument::Turns(k),
            Source::Scalar(number) => Argument::Scalar(number),
            Source::Remembered(k) => Argument::Remembered(k),
            Source::Element(name, k) => {
                array(name).map_or(Argument::None, |array| Argument::Element(array, in_state(name, k, room)))
            }
            Source::Multiplier(k) => Argument::Multiplier(k),
            Source::Mode(k, mode) => Argument::Mode(k, mode),
            Source::Number(_) => Argument::None,
        }
    }
}

/// The place of an element: `x` and `dx` have the room of the state.
pub(crate) fn in_state(name: &str, index: usize, room: Room) -> usize {
    if name == "x" || name == "dx" { room.place(index) } else { index }
}

/// A number of the scalar.
pub(crate) fn of_scalar<S: Scalar>(number: OfScalar) -> S {
    S::lit(match number {
        OfScalar::MostGrowth => S::MOST_GROWTH,
        OfScalar::Agreement => S::AGREEMENT,
        OfScalar::Precision => S::PRECISION,
    })
}

fn array(name: &str) -> Option<Array> {
    Some(match name {
        "x" => Array::X,
        "q" => Array::Q,
        "v" => Array::V,
        "a" => Array::A,
        "lambda" => Array::Lambda,
        "w" => Array::Weights,
        "r" => Array::Residuals,
        "dx" => Array::Rates,
        "slip" => Array::Slip,
        "line" => Array::Line,
        "force" => Array::Force,
        "second" => Array::Second,
        "known" => Array::Known,
        _ => return None,
    })
}
