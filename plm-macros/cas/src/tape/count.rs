//! Counted operations.

use core::fmt;

use plm_math::Operations;

use super::{Instr, Op};

/// How many operations of each kind a tape performs. Constants and inputs cost nothing.
#[derive(Copy, Clone, PartialEq, Eq, Debug, Default)]
pub struct Count {
    /// By the kinds that generated code tells.
    pub operations: Operations,
    /// Sign changes, among the additions.
    pub neg: u32,
    /// Comparisons and choices, among the others: less, select, abs, sign, min, max.
    pub select: u32,
}

impl Count {
    /// Counts instructions, in the order of their tape.
    pub fn of<'t>(instructions: impl IntoIterator<Item = &'t Instr>) -> Self {
        let Self { operations: mut count, mut neg, mut select } = Self::default();
        let mut sine_of = None;
        for instr in instructions {
            match instr.op {
                Op::Number(_) | Op::Symbol(_) => {}
                Op::Add(..) | Op::Sub(..) => count.add += 1,
                Op::Mul(..) => count.mul += 1,
                Op::Div(..) => count.div += 1,
                Op::Neg(_) => neg += 1,
                Op::Sqrt(_) => count.sqrt += 1,
                Op::Cos(angle) if sine_of == Some(angle) => {} // the second half of a pair
                Op::Sin(_) | Op::Cos(_) => count.sin_cos += 1,
                Op::Less(..)
                | Op::Select(..)
                | Op::Abs(_)
                | Op::Sign(_)
                | Op::Floor(_)
                | Op::Min(..)
                | Op::Max(..) => select += 1,
                Op::Asin(_) | Op::Acos(_) | Op::Atan2(..) | Op::Exp(_) | Op::Ln(_) => count.other += 1,
            }
            sine_of = match instr.op {
                Op::Sin(angle) => Some(angle),
                _ => None,
            };
        }
        count.add += neg;
        count.other += select;
        Self { operations: count, neg, select }
    }

    /// All together.
    pub const fn total(&self) -> usize {
        self.operations.total() as usize
    }
}

/// "14 add, 12 mul, 6 sin_cos": the kinds that occur, or "none".
impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { operations: Operations { add, mul, div, sqrt, sin_cos, other }, neg, select } = *self;
        let kinds = [
            (add - neg, "add"),
            (mul, "mul"),
            (div, "div"),
            (neg, "neg"),
            (sqrt, "sqrt"),
            (sin_cos, "sin_cos"),
            (select, "select"),
            (other - select, "other"),
        ];
        let mut separator = "";
        for (count, kind) in kinds.into_iter().filter(|kind| kind.0 > 0) {
            write!(f, "{separator}{count} {kind}")?;
            separator = ", ";
        }
        if separator.is_empty() { f.write_str("none") } else { Ok(()) }
    }
}

impl core::ops::Add for Count {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            operations: self.operations + other.operations,
            neg: self.neg + other.neg,
            select: self.select + other.select,
        }
    }
}
