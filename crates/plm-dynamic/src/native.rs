//! Machine code in place of steps: who makes it need not be known here.

use std::fmt::Debug;

use plm_compiler::lowered::{Register, Step};

/// A straight-line function of lists of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Function<'a> {
    /// Its operations in order; operands come before their users.
    pub steps: &'a [Step],
    /// Number of registers that the steps need.
    pub registers: usize,
    /// The arguments, by the numbers that steps have for them.
    pub arguments: &'a [Input],
    /// Results that go to lists, and their registers.
    pub outputs: &'a [(Element, Register)],
    /// Results that go to one list beside the others, in its order: their registers.
    pub others: &'a [Register],
    /// The register of the value that the function returns.
    pub returned: Option<Register>,
}

/// An argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input {
    /// A constant.
    Number(f64),
    /// An element of a list that is read.
    Element(Element),
}

/// An element of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// The number of the list.
    pub list: usize,
    /// The place in it.
    pub index: usize,
}

/// When machine code takes the place of steps. The bits are the same in both, so that results do not depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tier {
    /// The evaluation that asks for it waits until it is made.
    #[default]
    AtOnce,
    /// It is made on a thread of its own, while evaluations go on by steps; where no thread is to be had, at once.
    InBackground,
}

/// A maker of machine code.
pub trait Translator: Debug + Send + Sync {
    /// Machine code with the bits of the steps; nothing where it makes none.
    fn translate(&self, function: &Function<'_>) -> Option<Box<dyn MachineCode>>;

    /// Number of evaluations by steps after which a function is worth its translation.
    fn evaluations_before(&self) -> u32 {
        0
    }

    /// When code takes the place of steps.
    fn tier(&self) -> Tier {
        Tier::AtOnce
    }
}

/// A function as machine code.
pub trait MachineCode: Debug + Send + Sync {
    /// Evaluates: results go to the lists `outputs` and to `others`, and what is returned comes back, or zero. Where lists are missing or
    /// too short, nothing is evaluated, and nothing comes back.
    fn run(&self, inputs: &[&[f64]], outputs: &mut [&mut [f64]], others: &mut [f64]) -> Option<f64>;
}
