//! Counted operations.

use core::fmt;

use super::{Instr, Op};

/// How many operations of each kind a tape performs. Constants and inputs cost nothing.
#[derive(Copy, Clone, PartialEq, Eq, Debug, Default)]
pub struct Count {
    /// Additions and subtractions.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Divisions.
    pub div: usize,
    /// Sign changes.
    pub neg: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Sines, cosines and pairs of both of one angle, each counted as one.
    pub sin_cos: usize,
    /// Comparisons and choices: less, select, abs, sign, min, max.
    pub select: usize,
    /// The other functions: asin, acos, atan2, exp, ln.
    pub other: usize,
}

impl Count {
    /// Counts instructions, in the order of their tape.
    pub fn of<'t>(instructions: impl IntoIterator<Item = &'t Instr>) -> Self {
        let mut count = Self::default();
        let mut sine_of = None;
        for instr in instructions {
            match instr.op {
                Op::Number(_) | Op::Symbol(_) => {}
                Op::Add(..) | Op::Sub(..) => count.add += 1,
                Op::Mul(..) => count.mul += 1,
                Op::Div(..) => count.div += 1,
                Op::Neg(_) => count.neg += 1,
                Op::Sqrt(_) => count.sqrt += 1,
                Op::Cos(angle) if sine_of == Some(angle) => {} // the second half of a pair
                Op::Sin(_) | Op::Cos(_) => count.sin_cos += 1,
                Op::Less(..) | Op::Select(..) | Op::Abs(_) | Op::Sign(_) | Op::Min(..) | Op::Max(..) => {
                    count.select += 1;
                }
                Op::Asin(_) | Op::Acos(_) | Op::Atan2(..) | Op::Exp(_) | Op::Ln(_) => count.other += 1,
            }
            sine_of = match instr.op {
                Op::Sin(angle) => Some(angle),
                _ => None,
            };
        }
        count
    }

    /// All together.
    pub const fn total(&self) -> usize {
        self.add + self.mul + self.div + self.neg + self.sqrt + self.sin_cos + self.select + self.other
    }
}

/// "14 add, 12 mul, 6 sin_cos": the kinds that occur, or "none".
impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.add, "add"),
            (self.mul, "mul"),
            (self.div, "div"),
            (self.neg, "neg"),
            (self.sqrt, "sqrt"),
            (self.sin_cos, "sin_cos"),
            (self.select, "select"),
            (self.other, "other"),
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
            add: self.add + other.add,
            mul: self.mul + other.mul,
            div: self.div + other.div,
            neg: self.neg + other.neg,
            sqrt: self.sqrt + other.sqrt,
            sin_cos: self.sin_cos + other.sin_cos,
            select: self.select + other.select,
            other: self.other + other.other,
        }
    }
}
