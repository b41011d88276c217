//! Numbers whose operations become steps of a function: formulas of the runtime are recorded by computing with them.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use plm_compiler::lowered::{Operation, Register, Step};
use plm_runtime::Scalar;

/// A number of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Recorded {
    /// A constant.
    Number(f64),
    /// The result of a step.
    Result(Register),
}

/// The steps that are recorded on a thread, each of which writes a register of its own.
#[derive(Debug, Default)]
pub(crate) struct Record {
    pub(crate) steps: Vec<Step>,
    pub(crate) registers: Register,
    /// Registers of constants, by their bits.
    constants: BTreeMap<u64, Register>,
}

thread_local! {
    static RECORD: RefCell<Record> = RefCell::new(Record::default());
}

impl Record {
    fn push(&mut self, operation: Operation) -> Register {
        let to = self.register();
        self.steps.push(Step { to, operation });
        to
    }

    fn register(&mut self) -> Register {
        self.registers += 1;
        self.registers - 1
    }

    fn of(&mut self, number: Recorded) -> Register {
        match number {
            Recorded::Result(register) => register,
            Recorded::Number(number) => {
                if let Some(register) = self.constants.get(&number.to_bits()) {
                    return *register;
                }
                let register = self.push(Operation::Number(number));
                self.constants.insert(number.to_bits(), register);
                register
            }
        }
    }
}

/// Result of `work`, with the record of its operations. Nothing of the thread may be recorded already.
pub(crate) fn record<T>(work: impl FnOnce() -> T) -> (T, Record) {
    RECORD.with_borrow_mut(|record| *record = Record::default());
    let value = work();
    (value, RECORD.take())
}

/// The register of a number.
pub(crate) fn register(number: Recorded) -> Register {
    RECORD.with_borrow_mut(|record| record.of(number))
}

/// The result of an operation whose operands are registers of the record.
pub(crate) fn result(operation: Operation) -> Recorded {
    Recorded::Result(RECORD.with_borrow_mut(|record| record.push(operation)))
}

/// A register that no step has.
fn unused() -> Register {
    RECORD.with_borrow_mut(Record::register)
}

/// Records other steps: their arguments, by number, are these; what they have in their registers at the end comes back.
pub(crate) fn repeat(
    steps: &[Step],
    registers: usize,
    argument: impl Fn(usize) -> Recorded,
) -> Vec<Recorded> {
    let mut own = vec![Recorded::Number(0.0); registers];
    for Step { to, operation } in steps {
        let value = match *operation {
            Operation::Argument(k) => argument(k as usize),
            Operation::Number(number) => Recorded::Number(number),
            Operation::SinCos(angle, cosine) => {
                let (sin, cos) = own[angle as usize].sin_cos();
                own[cosine as usize] = cos;
                sin
            }
            operation => result(operation.with_operands(|operand| register(own[operand as usize]))),
        };
        own[*to as usize] = value;
    }
    own
}

/// An operation of one number.
fn of_one(a: Recorded, operation: impl FnOnce(Register) -> Operation) -> Recorded {
    result(operation(register(a)))
}

/// An operation of two numbers.
fn of_two([a, b]: [Recorded; 2], operation: impl FnOnce(Register, Register) -> Operation) -> Recorded {
    result(operation(register(a), register(b)))
}

impl Add for Recorded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        of_two([self, other], Operation::Add)
    }
}

impl Sub for Recorded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        of_two([self, other], Operation::Sub)
    }
}

impl Mul for Recorded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        of_two([self, other], Operation::Mul)
    }
}

impl Div for Recorded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        of_two([self, other], Operation::Div)
    }
}

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        of_one(self, Operation::Neg)
    }
}

/// The operations of explicit formulas. A value is not known before the steps are evaluated: nothing can be decided by it.
impl Scalar for Recorded {
    /// Two numbers that are compared: is the first one less?
    type Mask = [Self; 2];
    type Turns = i32;

    const ZERO: Self = Self::Number(0.0);
    const HEALTHY: f64 = f64::HEALTHY;
    const AGREEMENT: f64 = f64::AGREEMENT;
    const PRECISION: f64 = f64::PRECISION;

    fn lit(x: f64) -> Self {
        Self::Number(x)
    }
    fn of_turns(turns: i32) -> Self {
        Self::Number(f64::from(turns))
    }
    fn to_turns(self) -> i32 {
        0
    }
    fn to_f64(self) -> f64 {
        match self {
            Self::Number(number) => number,
            Self::Result(_) => f64::NAN,
        }
    }
    fn is_finite(self) -> bool {
        true
    }
    fn mul_add(self, a: Self, b: Self) -> Self {
        let [x, a, b] = [self, a, b].map(register);
        result(Operation::MulAdd(x, a, b))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (angle, cosine) = (register(self), unused());
        (result(Operation::SinCos(angle, cosine)), Self::Result(cosine))
    }
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sines, mut cosines) = (angles, angles);
        for (k, angle) in angles.into_iter().enumerate() {
            (sines[k], cosines[k]) = angle.sin_cos();
        }
        (sines, cosines)
    }
    fn sqrt(self) -> Self {
        of_one(self, Operation::Sqrt)
    }
    /// Not a number: steps have no tangent, and formulas need none.
    fn tan(self) -> Self {
        Self::Number(f64::NAN)
    }
    fn asin(self) -> Self {
        of_one(self, Operation::Asin)
    }
    fn acos(self) -> Self {
        of_one(self, Operation::Acos)
    }
    fn atan2(self, x: Self) -> Self {
        of_two([self, x], Operation::Atan2)
    }
    fn exp(self) -> Self {
        of_one(self, Operation::Exp)
    }
    fn ln(self) -> Self {
        of_one(self, Operation::Ln)
    }
    fn abs(self) -> Self {
        of_one(self, Operation::Abs)
    }
    fn floor(self) -> Self {
        of_one(self, Operation::Floor)
    }
    fn lt(self, other: Self) -> [Self; 2] {
        [self, other]
    }
    fn select([a, b]: [Self; 2], c: Self, d: Self) -> Self {
        let [a, b, c, d] = [a, b, c, d].map(register);
        result(Operation::Select(a, b, c, d))
    }
    fn any(_mask: [Self; 2]) -> bool {
        false
    }
    fn all(_mask: [Self; 2]) -> bool {
        false
    }
}
