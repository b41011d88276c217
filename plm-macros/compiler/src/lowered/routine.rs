//! A straight-line function as data: its steps, where its arguments come from, and where its results go.
//!
//! The steps are those of the emitted function: the operations of its tape in their order, with products fused into sums where the
//! emitted text has `mul_add`. So `f64` and `f32` give the bits of compiled code; so do dual numbers, but where emitted text has loops or
//! roots of differences that are never negative, which fuse otherwise in rare places, and if a constant that stands first in a product or a
//! quotient is a factor, without derivatives.

use plm_cas::{Expr, Op, Ref, Tape};

use crate::collect::{CollectVec, PushAll};
use crate::emit::{MOST_TERMS, uses};
use crate::formulate::{Function, OfRows, Place};
use crate::sorted::SortedMap;
use crate::source::Source;

/// A straight-line function.
#[derive(Clone, Debug, Default)]
pub struct Routine {
    /// Its operations in order; operands come before their users.
    pub steps: Vec<Step>,
    /// Number of registers that the steps need.
    pub registers: usize,
    /// Sources of the arguments, by number.
    pub sources: Vec<Source>,
    /// Destinations of the results, each with the register of its value.
    pub results: Vec<(Target, u32)>,
}

/// A register; a step may write into one that it reads.
pub type Register = u32;

/// The place of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The value that the function returns.
    Value,
    /// An element of an array.
    Element(&'static str, usize),
    /// An entry of a matrix.
    Entry(&'static str, usize, usize),
    /// A number that is remembered of loops, in the order of storage.
    Remembered(usize),
    /// A number of the rows of contact.
    Rows(OfRows),
}

/// An operation, and the register of its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The register of the result; of sine and cosine, that of the sine.
    pub to: Register,
    /// The operation.
    pub operation: Operation,
}

/// An operation on registers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// A constant.
    Number(f64),
    /// An argument, by its number among the sources.
    Argument(u32),
    /// `a + b`.
    Add(Register, Register),
    /// `a - b`.
    Sub(Register, Register),
    /// `a * b`.
    Mul(Register, Register),
    /// `a / b`.
    Div(Register, Register),
    /// `-a`.
    Neg(Register),
    /// `a.mul_add(b, c)`: `a * b + c`.
    MulAdd(Register, Register, Register),
    /// `(-a).mul_add(b, c)`.
    NegMulAdd(Register, Register, Register),
    /// `a.mul_add(b, -c)`.
    MulSub(Register, Register, Register),
    /// Square root.
    Sqrt(Register),
    /// Sine and cosine of the angle `a`: the cosine goes to the second register.
    SinCos(Register, Register),
    /// Sine.
    Sin(Register),
    /// Cosine.
    Cos(Register),
    /// Arc sine.
    Asin(Register),
    /// Arc cosine.
    Acos(Register),
    /// `a.atan2(b)`.
    Atan2(Register, Register),
    /// Exponential.
    Exp(Register),
    /// Natural logarithm.
    Ln(Register),
    /// Absolute value.
    Abs(Register),
    /// -1, 0 or 1 by the sign.
    Sign(Register),
    /// The largest integer that is not above.
    Floor(Register),
    /// The smaller number.
    Min(Register, Register),
    /// The larger number.
    Max(Register, Register),
    /// `if a < b { c } else { d }`.
    Select(Register, Register, Register, Register),
}

impl Step {
    /// The registers that it writes: one, or two.
    pub fn results(&self) -> impl Iterator<Item = Register> + use<> {
        let cosine = match self.operation {
            Operation::SinCos(_, cosine) => Some(cosine),
            _ => None,
        };
        [self.to].into_iter().chain(cosine)
    }
}

impl Operation {
    /// The registers that it reads.
    pub fn operands_mut(&mut self) -> Vec<&mut Register> {
        use Operation as O;
        match self {
            O::Number(_) | O::Argument(_) => Vec::new(),
            O::SinCos(a, _)
            | O::Neg(a)
            | O::Sqrt(a)
            | O::Sin(a)
            | O::Cos(a)
            | O::Asin(a)
            | O::Acos(a)
            | O::Exp(a)
            | O::Ln(a)
            | O::Abs(a)
            | O::Sign(a)
            | O::Floor(a) => vec![a],
            O::Add(a, b)
            | O::Sub(a, b)
            | O::Mul(a, b)
            | O::Div(a, b)
            | O::Atan2(a, b)
            | O::Min(a, b)
            | O::Max(a, b) => vec![a, b],
            O::MulAdd(a, b, c) | O::NegMulAdd(a, b, c) | O::MulSub(a, b, c) => vec![a, b, c],
            O::Select(a, b, c, d) => vec![a, b, c, d],
        }
    }

    /// Operation with other registers that it reads.
    #[must_use]
    pub fn with_operands(mut self, name: impl Fn(Register) -> Register) -> Operation {
        self.operands_mut().into_iter().for_each(|operand| *operand = name(*operand));
        self
    }
}

/// The places of the symbols that a function may read.
pub(crate) type Places = SortedMap<Expr, Source>;

impl Routine {
    /// A function as data. `paths` are the places of what is remembered, in the order of storage.
    pub(crate) fn new(function: &Function, places: &Places, paths: &[String]) -> Routine {
        let tape = function.tape();
        let first_result = tape.outputs.len() - function.results.len();
        let results = tape.outputs[first_result..].iter().map(|result| result.index()).collect_vec();
        let mut lowering = Lowering::new(&tape, &results, places);
        for index in 0..tape.ops.len() {
            lowering.lower(index);
        }
        let targets = function.results.iter().map(|(place, _)| target(place, paths)).collect_vec();
        let values = results.iter().map(|&result| lowering.register[result]).collect_vec();
        let results = targets.into_iter().zip(values).collect_vec();
        let mut routine = Routine {
            steps: lowering.steps,
            registers: lowering.next as usize,
            sources: lowering.sources,
            results,
        };
        super::registers::share(&mut routine);
        routine
    }
}

fn target(place: &Place, paths: &[String]) -> Target {
    match place {
        Place::Value => Target::Value,
        Place::Element(array, index) => Target::Element(array, *index),
        Place::Entry(matrix, row, column) => Target::Entry(matrix, *row, *column),
        Place::Rows(place) => Target::Rows(*place),
        Place::Path(path) => {
            let own = |known: &String| path.strip_prefix("memory.") == Some(known);
            Target::Remembered(paths.iter().position(own).unwrap_or(usize::MAX))
        }
    }
}

struct Lowering<'a> {
    tape: &'a Tape,
    places: &'a Places,
    /// How often a result needs each instruction.
    uses: Vec<u32>,
    is_result: Vec<bool>,
    /// Leaves of the expression that stands where a value is used; 1 of a value with a name.
    terms: Vec<usize>,
    /// Has the value a name, so that no sum takes it apart?
    named: Vec<bool>,
    /// The register of each value; products within sums have none until they are asked for.
    register: Vec<Register>,
    next: Register,
    steps: Vec<Step>,
    sources: Vec<Source>,
}

const NONE: Register = Register::MAX;

impl<'a> Lowering<'a> {
    fn new(tape: &'a Tape, results: &[usize], places: &'a Places) -> Self {
        let count = tape.ops.len();
        let mut is_result = vec![false; count];
        for &result in results {
            is_result[result] = true;
        }
        let uses = uses(tape, results, &SortedMap::new());
        Lowering {
            tape,
            places,
            uses,
            is_result,
            terms: vec![1; count],
            named: vec![false; count],
            register: vec![NONE; count],
            next: 0,
            steps: Vec::new(),
            sources: Vec::new(),
        }
    }

    fn lower(&mut self, index: usize) {
        if self.uses[index] == 0 || self.register[index] != NONE {
            return;
        }
        let op = self.tape.ops[index].op;
        if let Op::Sin(angle) = op
            && self.is_pair(index)
        {
            let [angle, sine, cosine] = [self.value(angle), self.fresh(), self.fresh()];
            self.steps.push(Step { to: sine, operation: Operation::SinCos(angle, cosine) });
            (self.register[index], self.register[index + 1]) = (sine, cosine);
            (self.named[index], self.named[index + 1]) = (true, true);
            return;
        }
        let terms = op.operands().map(|operand| self.terms[operand.index()]).sum::<usize>().max(1);
        let is_leaf = matches!(op, Op::Number(_) | Op::Symbol(_));
        self.named[index] = !is_leaf && (self.uses[index] > 1 || terms > MOST_TERMS);
        self.terms[index] = if self.named[index] { 1 } else { terms };
        let stands_in_sum = matches!(op, Op::Mul(..)) && !self.named[index] && !self.is_result[index];
        // Conditions are compared where something is selected; products within sums where the sum is.
        if !stands_in_sum && !matches!(op, Op::Less(..)) {
            self.make(index);
        }
    }

    /// Computes a value.
    fn make(&mut self, index: usize) -> Register {
        let operation = self.operation(self.tape.ops[index].op);
        let to = self.fresh();
        self.steps.push(Step { to, operation });
        self.register[index] = to;
        to
    }

    /// The register of a value.
    fn value(&mut self, at: Ref) -> Register {
        match self.register[at.index()] {
            NONE => self.make(at.index()),
            register => register,
        }
    }

    fn fresh(&mut self) -> Register {
        self.next += 1;
        self.next - 1
    }

    fn is_pair(&self, index: usize) -> bool {
        crate::emit::is_pair(self.tape, &self.uses, index)
    }

    /// The factors of a product that stands where it is used.
    fn product(&self, at: Ref) -> Option<[Ref; 2]> {
        match self.tape.ops[at.index()].op {
            Op::Mul(x, y) if !self.named[at.index()] => Some([x, y]),
            _ => None,
        }
    }

    /// `-a` of a constant; nothing of other values.
    fn negative_number(&mut self, at: Ref) -> Option<Register> {
        let Op::Number(value) = self.tape.ops[at.index()].op else { return None };
        let to = self.fresh();
        self.steps.push(Step { to, operation: Operation::Number(-value) });
        Some(to)
    }

    fn sum(&mut self, a: Ref, b: Ref) -> Operation {
        let (product, other) = match (self.product(a), self.product(b)) {
            (_, Some(product)) => (product, a),
            (Some(product), None) => (product, b),
            (None, None) => return Operation::Add(self.value(a), self.value(b)),
        };
        let [x, y] = product.map(|factor| self.value(factor));
        Operation::MulAdd(x, y, self.value(other))
    }

    fn difference(&mut self, a: Ref, b: Ref) -> Operation {
        match (self.product(a), self.product(b)) {
            (_, Some([x, y])) => match self.negative_number(x) {
                Some(x) => Operation::MulAdd(x, self.value(y), self.value(a)),
                None => Operation::NegMulAdd(self.value(x), self.value(y), self.value(a)),
            },
            (Some(factors), None) => {
                let [x, y] = factors.map(|factor| self.value(factor));
                match self.negative_number(b) {
                    Some(b) => Operation::MulAdd(x, y, b),
                    None => Operation::MulSub(x, y, self.value(b)),
                }
            }
            (None, None) => Operation::Sub(self.value(a), self.value(b)),
        }
    }

    fn operation(&mut self, op: Op) -> Operation {
        match op {
            Op::Number(value) => Operation::Number(value),
            Op::Symbol(symbol) => self.argument(symbol),
            Op::Add(a, b) => self.sum(a, b),
            Op::Sub(a, b) => self.difference(a, b),
            Op::Mul(a, b) => Operation::Mul(self.value(a), self.value(b)),
            Op::Div(a, b) => Operation::Div(self.value(a), self.value(b)),
            Op::Neg(a) => match self.tape.ops[a.index()].op {
                Op::Number(value) => Operation::Number(-value),
                _ => Operation::Neg(self.value(a)),
            },
            Op::Sqrt(a) => Operation::Sqrt(self.value(a)),
            Op::Sin(a) => Operation::Sin(self.value(a)),
            Op::Cos(a) => Operation::Cos(self.value(a)),
            Op::Asin(a) => Operation::Asin(self.value(a)),
            Op::Acos(a) => Operation::Acos(self.value(a)),
            Op::Atan2(y, x) => Operation::Atan2(self.value(y), self.value(x)),
            Op::Exp(a) => Operation::Exp(self.value(a)),
            Op::Ln(a) => Operation::Ln(self.value(a)),
            Op::Abs(a) => Operation::Abs(self.value(a)),
            Op::Sign(a) => Operation::Sign(self.value(a)),
            Op::Floor(a) => Operation::Floor(self.value(a)),
            Op::Min(a, b) => Operation::Min(self.value(a), self.value(b)),
            Op::Max(a, b) => Operation::Max(self.value(a), self.value(b)),
            // Read as a number it is 1 or 0, as by the interpreter of the tape.
            Op::Less(a, b) => {
                let [one, zero] = [1.0, 0.0].map(|value| self.number(value));
                Operation::Select(self.value(a), self.value(b), one, zero)
            }
            Op::Select(condition, a, b) => {
                let [less, than] = match self.tape.ops[condition.index()].op {
                    Op::Less(less, than) => [self.value(less), self.value(than)],
                    _ => [self.number(0.0), self.value(condition)],
                };
                Operation::Select(less, than, self.value(a), self.value(b))
            }
        }
    }

    fn number(&mut self, value: f64) -> Register {
        let to = self.fresh();
        self.steps.push(Step { to, operation: Operation::Number(value) });
        to
    }

    fn argument(&mut self, symbol: Expr) -> Operation {
        let source = self.places.get(&symbol).copied().unwrap_or(Source::Number("unknown"));
        self.sources.push_all([source]);
        Operation::Argument(self.sources.len() as u32 - 1)
    }
}
