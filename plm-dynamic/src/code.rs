//! Straight-line functions that are evaluated step by step, on any scalar.

use plm_compiler::lowered::{OfRows, Operation, Routine, Step, Target};
use plm_compiler::model::ContactMode;
use plm_compiler::{OfScalar, Source};
use plm_runtime::Scalar;

/// A function: its steps, its arguments, and the places of its results.
#[derive(Clone, Debug)]
pub(crate) struct Code {
    steps: &'static [Step],
    registers: usize,
    arguments: Vec<Argument>,
    results: Vec<(Place, u32)>,
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
}

/// Where an argument comes from.
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
    /// The turns of a count.
    Turns(usize),
    /// A number of the scalar.
    Scalar(OfScalar),
    /// A number that is remembered of loops.
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

/// Where a result goes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place {
    /// To the value that the function returns.
    Value,
    /// To an element of the output with this number.
    Element(usize, usize),
    /// To an entry of a matrix over the state.
    Entry(usize, usize),
    /// To a number that is remembered of loops.
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

impl Code {
    /// A function whose outputs have these names, in order. The arrays `x` and `dx` have the room of the state.
    pub(crate) fn new(routine: &'static Routine, outputs: &[&str], room: Room) -> Code {
        let in_state =
            |name: &str, index: usize| if name == "x" || name == "dx" { room.place(index) } else { index };
        let argument = |source: &Source| match *source {
            Source::Time => Argument::Time,
            Source::Parameter(k) => Argument::Parameter(k),
            Source::Input(k) => Argument::Input(k),
            Source::Switch(k) => Argument::Switch(k),
            Source::Turns(k) => Argument::Turns(k),
            Source::Scalar(number) => Argument::Scalar(number),
            Source::Remembered(k) => Argument::Remembered(k),
            Source::Element(name, k) => {
                array(name).map_or(Argument::None, |array| Argument::Element(array, in_state(name, k)))
            }
            Source::Multiplier(k) => Argument::Multiplier(k),
            Source::Mode(k, mode) => Argument::Mode(k, mode),
            Source::Number(_) => Argument::None,
        };
        let place = |target: &Target| match *target {
            Target::Value => Place::Value,
            Target::Rows(place) => Place::Rows(place),
            Target::Entry("response", row, column) => Place::Response(row, room.place(column)),
            Target::Entry(_, row, column) => Place::Entry(room.place(row), room.place(column)),
            Target::Remembered(k) => Place::Remembered(k),
            Target::Element(name, k) => {
                let output = outputs.iter().position(|known| *known == name).unwrap_or(usize::MAX);
                Place::Element(output, in_state(name, k))
            }
        };
        Code {
            steps: &routine.steps,
            registers: routine.registers,
            arguments: routine.sources.iter().map(argument).collect(),
            results: routine.results.iter().map(|(target, register)| (place(target), *register)).collect(),
        }
    }

    /// Evaluates: `argument` gives what is read, `result` takes what comes out.
    pub(crate) fn run<S: Scalar>(&self, argument: impl Fn(Argument) -> S, mut result: impl FnMut(Place, S)) {
        const FEW: usize = 48;
        let (mut few, mut many) = ([S::ZERO; FEW], Vec::new());
        let registers = if self.registers <= FEW {
            &mut few[..]
        } else {
            many.resize(self.registers, S::ZERO);
            &mut many[..]
        };
        for step in self.steps {
            evaluate(step, registers, |k| self.arguments.get(k).map_or(S::ZERO, |place| argument(*place)));
        }
        for (place, register) in &self.results {
            result(*place, registers[*register as usize]);
        }
    }
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

/// One step.
fn evaluate<S: Scalar>(step: &Step, registers: &mut [S], argument: impl Fn(usize) -> S) {
    use Operation as O;
    let at = |register: u32| registers[register as usize];
    let value = match step.operation {
        O::Number(value) => S::lit(value),
        O::Argument(k) => argument(k as usize),
        O::Add(a, b) => at(a) + at(b),
        O::Sub(a, b) => at(a) - at(b),
        O::Mul(a, b) => at(a) * at(b),
        O::Div(a, b) => at(a) / at(b),
        O::Neg(a) => -at(a),
        O::MulAdd(a, b, c) => at(a).mul_add(at(b), at(c)),
        O::NegMulAdd(a, b, c) => (-at(a)).mul_add(at(b), at(c)),
        O::MulSub(a, b, c) => at(a).mul_add(at(b), -at(c)),
        O::Sqrt(a) => at(a).sqrt(),
        O::SinCos(a, cosine) => {
            let (sin, cos) = at(a).sin_cos();
            registers[cosine as usize] = cos;
            sin
        }
        O::Sin(a) => at(a).sin(),
        O::Cos(a) => at(a).cos(),
        O::Asin(a) => at(a).asin(),
        O::Acos(a) => at(a).acos(),
        O::Atan2(y, x) => at(y).atan2(at(x)),
        O::Exp(a) => at(a).exp(),
        O::Ln(a) => at(a).ln(),
        O::Abs(a) => at(a).abs(),
        O::Sign(a) => at(a).signum0(),
        O::Floor(a) => at(a).floor(),
        O::Min(a, b) => at(a).min(at(b)),
        O::Max(a, b) => at(a).max(at(b)),
        O::Select(a, b, c, d) => S::select(at(a).lt(at(b)), at(c), at(d)),
    };
    registers[step.to as usize] = value;
}
