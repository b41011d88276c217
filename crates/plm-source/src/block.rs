//! Straight-line functions as values, each of which is computed once: routines are put one after another, and what no result needs
//! falls out.

use std::collections::BTreeMap;

use plm_compiler::lowered::{Operation, Routine, Target};
use plm_compiler::model::ContactMode;
use plm_compiler::{OfScalar, Source};
use plm_runtime::Scalar;

/// A value of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Value(u32);

impl Value {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A number that a function reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Argument {
    /// The time.
    Time,
    /// A parameter.
    Parameter(usize),
    /// An input.
    Input(usize),
    /// The side of a condition.
    Side(usize),
    /// The whole revolutions of a count.
    Turns(usize),
    /// 1 where a row of contact is open, or else where it sticks.
    Mode(usize, bool),
    /// A number of the continuation data of loops.
    Remembered(usize),
    /// An element of an array.
    Element(&'static str, usize),
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum OfOne {
    Neg,
    Sqrt,
    Asin,
    Acos,
    Exp,
    Ln,
    Abs,
    Sign,
    Floor,
}

/// A function of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum OfTwo {
    Add,
    Sub,
    Mul,
    Div,
    Atan2,
    Min,
    Max,
}

/// A value, by what it is computed of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Node {
    /// A constant, by its bits in `f64`.
    Number(u64),
    Argument(Argument),
    One(OfOne, Value),
    Two(OfTwo, Value, Value),
    /// `if a < b { c } else { d }`.
    Select([Value; 4]),
    /// Sine and cosine of an angle.
    Pair(Value),
    Sine(Value),
    Cosine(Value),
}

impl Node {
    fn operands(&self) -> Vec<Value> {
        match *self {
            Node::Number(_) | Node::Argument(_) => Vec::new(),
            Node::One(_, a) | Node::Pair(a) | Node::Sine(a) | Node::Cosine(a) => vec![a],
            Node::Two(_, a, b) => vec![a, b],
            Node::Select(all) => all.to_vec(),
        }
    }
}

/// The numbers that a scalar has.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OfPrecision {
    most_growth: f64,
    agreement: f64,
    precision: f64,
}

impl OfPrecision {
    pub(crate) fn of<S: Scalar>() -> OfPrecision {
        OfPrecision { most_growth: S::MOST_GROWTH, agreement: S::AGREEMENT, precision: S::PRECISION }
    }
}

/// Values, operands before their users.
#[derive(Debug)]
pub(crate) struct Block {
    nodes: Vec<Node>,
    known: BTreeMap<Node, Value>,
    scalar: OfPrecision,
}

impl Block {
    pub(crate) fn new(scalar: OfPrecision) -> Block {
        Block { nodes: Vec::new(), known: BTreeMap::new(), scalar }
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The value of a node, which is made where there is none.
    pub(crate) fn value(&mut self, node: Node) -> Value {
        if let Some(value) = self.known.get(&node) {
            return *value;
        }
        let value = Value(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        self.nodes.push(node);
        self.known.insert(node, value);
        value
    }

    pub(crate) fn number(&mut self, number: f64) -> Value {
        self.value(Node::Number(number.to_bits()))
    }

    pub(crate) fn argument(&mut self, argument: Argument) -> Value {
        self.value(Node::Argument(argument))
    }

    fn two(&mut self, of: OfTwo, a: Value, b: Value) -> Value {
        self.value(Node::Two(of, a, b))
    }

    /// Sine and cosine.
    fn sin_cos(&mut self, angle: Value) -> [Value; 2] {
        let pair = self.value(Node::Pair(angle));
        [self.value(Node::Sine(pair)), self.value(Node::Cosine(pair))]
    }

    /// The results of a routine whose arguments are `read`.
    pub(crate) fn routine(
        &mut self,
        routine: &Routine,
        mut read: impl FnMut(&mut Block, Source) -> Value,
    ) -> Vec<(Target, Value)> {
        let mut registers = vec![Value(0); routine.registers];
        for step in &routine.steps {
            let of = |register: &u32| registers.get(*register as usize).copied().unwrap_or(Value(0));
            let mut cosine = None;
            let value = match &step.operation {
                Operation::Number(number) => self.number(*number),
                Operation::Argument(k) => match routine.sources.get(*k as usize) {
                    Some(source) => read(self, *source),
                    None => self.number(0.0),
                },
                Operation::Add(a, b) => self.two(OfTwo::Add, of(a), of(b)),
                Operation::Sub(a, b) => self.two(OfTwo::Sub, of(a), of(b)),
                Operation::Mul(a, b) => self.two(OfTwo::Mul, of(a), of(b)),
                Operation::Div(a, b) => self.two(OfTwo::Div, of(a), of(b)),
                Operation::Atan2(a, b) => self.two(OfTwo::Atan2, of(a), of(b)),
                Operation::Min(a, b) => self.two(OfTwo::Min, of(a), of(b)),
                Operation::Max(a, b) => self.two(OfTwo::Max, of(a), of(b)),
                Operation::MulAdd(a, b, c) => {
                    let product = self.two(OfTwo::Mul, of(a), of(b));
                    self.two(OfTwo::Add, product, of(c))
                }
                Operation::NegMulAdd(a, b, c) => {
                    // A sum with a negative is a difference, to the bit (IEEE 754, 5.4.1).
                    let product = self.two(OfTwo::Mul, of(a), of(b));
                    self.two(OfTwo::Sub, of(c), product)
                }
                Operation::MulSub(a, b, c) => {
                    let product = self.two(OfTwo::Mul, of(a), of(b));
                    self.two(OfTwo::Sub, product, of(c))
                }
                Operation::SinCos(a, second) => {
                    let [sine, other] = self.sin_cos(of(a));
                    cosine = Some((*second, other));
                    sine
                }
                Operation::Sin(a) => self.sin_cos(of(a))[0],
                Operation::Cos(a) => self.sin_cos(of(a))[1],
                Operation::Neg(a) => self.value(Node::One(OfOne::Neg, of(a))),
                Operation::Sqrt(a) => self.value(Node::One(OfOne::Sqrt, of(a))),
                Operation::Asin(a) => self.value(Node::One(OfOne::Asin, of(a))),
                Operation::Acos(a) => self.value(Node::One(OfOne::Acos, of(a))),
                Operation::Exp(a) => self.value(Node::One(OfOne::Exp, of(a))),
                Operation::Ln(a) => self.value(Node::One(OfOne::Ln, of(a))),
                Operation::Abs(a) => self.value(Node::One(OfOne::Abs, of(a))),
                Operation::Sign(a) => self.value(Node::One(OfOne::Sign, of(a))),
                Operation::Floor(a) => self.value(Node::One(OfOne::Floor, of(a))),
                Operation::Select(a, b, c, d) => self.value(Node::Select([of(a), of(b), of(c), of(d)])),
            };
            let results = cosine.into_iter().chain([(step.to, value)]);
            for (to, value) in results {
                if let Some(register) = registers.get_mut(to as usize) {
                    *register = value;
                }
            }
        }
        let result = |register: &u32| registers.get(*register as usize).copied().unwrap_or(Value(0));
        routine.results.iter().map(|(target, register)| (*target, result(register))).collect()
    }

    /// A source as a value: a number of the scalar, or an argument; the multipliers of contact are the array `force`.
    pub(crate) fn source(&mut self, source: Source) -> Value {
        let argument = match source {
            Source::Time => Argument::Time,
            Source::Parameter(k) => Argument::Parameter(k),
            Source::Input(k) => Argument::Input(k),
            Source::Switch(k) => Argument::Side(k),
            Source::Turns(k) => Argument::Turns(k),
            Source::Remembered(k) => Argument::Remembered(k),
            Source::Element(array, k) => Argument::Element(array, k),
            Source::Scalar(of) => {
                let OfPrecision { most_growth, agreement, precision } = self.scalar;
                return self.number(match of {
                    OfScalar::MostGrowth => most_growth,
                    OfScalar::Agreement => agreement,
                    OfScalar::Precision => precision,
                });
            }
            Source::Multiplier(k) => Argument::Element("force", k),
            Source::Mode(k, mode) => Argument::Mode(k, mode == ContactMode::Open),
            Source::Number(_) => return self.number(0.0),
        };
        self.argument(argument)
    }

    /// Which values results need.
    pub(crate) fn needed(&self, results: impl IntoIterator<Item = Value>) -> Vec<bool> {
        let mut is_needed = vec![false; self.nodes.len()];
        for result in results {
            is_needed[result.index()] = true;
        }
        for (k, node) in self.nodes.iter().enumerate().rev() {
            if is_needed[k] {
                node.operands().into_iter().for_each(|operand| is_needed[operand.index()] = true);
            }
        }
        is_needed
    }

    /// All values in numbers of a type.
    pub(crate) fn evaluate<S: Scalar>(&self, argument: impl Fn(Argument) -> S) -> Vec<S> {
        let mut all: Vec<S> = Vec::with_capacity(self.nodes.len());
        // The cosine of each pair, whose own value is the sine.
        let mut cosines = BTreeMap::new();
        for (k, node) in self.nodes.iter().enumerate() {
            let of = |value: Value| all.get(value.index()).copied().unwrap_or(S::ZERO);
            let value = match *node {
                Node::Number(bits) => S::lit(f64::from_bits(bits)),
                Node::Argument(of) => argument(of),
                Node::One(one, a) => of_one(one, of(a)),
                Node::Two(two, a, b) => of_two(two, of(a), of(b)),
                Node::Select([a, b, c, d]) => S::select(of(a).lt(of(b)), of(c), of(d)),
                Node::Pair(angle) => {
                    let (sine, cosine) = of(angle).sin_cos();
                    cosines.insert(k, cosine);
                    sine
                }
                Node::Sine(pair) => of(pair),
                Node::Cosine(pair) => cosines.get(&pair.index()).copied().unwrap_or(S::ZERO),
            };
            all.push(value);
        }
        all
    }
}

fn of_one<S: Scalar>(one: OfOne, a: S) -> S {
    match one {
        OfOne::Neg => -a,
        OfOne::Sqrt => a.sqrt(),
        OfOne::Asin => a.asin(),
        OfOne::Acos => a.acos(),
        OfOne::Exp => a.exp(),
        OfOne::Ln => a.ln(),
        OfOne::Abs => a.abs(),
        OfOne::Sign => a.signum0(),
        OfOne::Floor => a.floor(),
    }
}

fn of_two<S: Scalar>(two: OfTwo, a: S, b: S) -> S {
    match two {
        OfTwo::Add => a + b,
        OfTwo::Sub => a - b,
        OfTwo::Mul => a * b,
        OfTwo::Div => a / b,
        OfTwo::Atan2 => a.atan2(b),
        OfTwo::Min => a.min(b),
        OfTwo::Max => a.max(b),
    }
}
