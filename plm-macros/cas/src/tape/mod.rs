//! The low form: single operations in the order in which they are emitted and evaluated.

mod count;
mod listing;
mod lower;
mod machine;
mod plan;

pub use count::Count;
pub use machine::Machine;

use crate::graph::Graph;
use crate::node::Expr;

/// An instruction of a tape: its position.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Ref(pub(crate) u32);

impl Ref {
    /// The instruction at a position.
    pub const fn at(position: usize) -> Self {
        Self(position as u32)
    }

    /// Position in `tape.ops`.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation. Operands are earlier instructions; each rounds once, nothing is fused.
#[derive(Copy, Clone, PartialEq, Debug)]
pub enum Op {
    /// A constant, rounded to the nearest f64.
    Number(f64),
    /// The value that a symbol is bound to.
    Symbol(Expr),
    /// `a + b`.
    Add(Ref, Ref),
    /// `a - b`.
    Sub(Ref, Ref),
    /// `a * b`.
    Mul(Ref, Ref),
    /// `a / b`.
    Div(Ref, Ref),
    /// `-a`.
    Neg(Ref),
    /// Square root.
    Sqrt(Ref),
    /// Sine. If the cosine of the same operand is wanted too, its instruction is the next one.
    Sin(Ref),
    /// Cosine. If the sine of the same operand is wanted too, its instruction is the one before.
    Cos(Ref),
    /// Arc sine.
    Asin(Ref),
    /// Arc cosine.
    Acos(Ref),
    /// `atan2(y, x)`.
    Atan2(Ref, Ref),
    /// Exponential.
    Exp(Ref),
    /// Natural logarithm.
    Ln(Ref),
    /// Absolute value.
    Abs(Ref),
    /// See [`Function::Sign`](crate::Function::Sign).
    Sign(Ref),
    /// See [`Function::Min`](crate::Function::Min).
    Min(Ref, Ref),
    /// See [`Function::Max`](crate::Function::Max).
    Max(Ref, Ref),
    /// See [`Function::Floor`](crate::Function::Floor).
    Floor(Ref),
    /// The condition `a < b`; evaluated here as 1 or 0.
    Less(Ref, Ref),
    /// `Select(condition, a, b)`: `a` where the condition (a `Less`, or a constant 1 or 0) holds, else `b`.
    Select(Ref, Ref, Ref),
}

impl Op {
    /// A number for each kind of operation, from 0.
    pub fn kind(self) -> u8 {
        match self {
            Self::Number(_) => 0,
            Self::Symbol(_) => 1,
            Self::Add(..) => 2,
            Self::Sub(..) => 3,
            Self::Mul(..) => 4,
            Self::Div(..) => 5,
            Self::Neg(_) => 6,
            Self::Sqrt(_) => 7,
            Self::Sin(_) => 8,
            Self::Cos(_) => 9,
            Self::Asin(_) => 10,
            Self::Acos(_) => 11,
            Self::Atan2(..) => 12,
            Self::Exp(_) => 13,
            Self::Ln(_) => 14,
            Self::Abs(_) => 15,
            Self::Sign(_) => 16,
            Self::Min(..) => 17,
            Self::Max(..) => 18,
            Self::Less(..) => 19,
            Self::Select(..) => 20,
            Self::Floor(_) => 21,
        }
    }

    /// The operands, in order.
    pub fn operands(self) -> impl Iterator<Item = Ref> {
        let (operands, count) = self.operand_array();
        operands.into_iter().take(count)
    }

    /// This operation on other operands, which are asked for in order.
    #[must_use]
    pub fn with_operands(self, mut other: impl FnMut(Ref) -> Ref) -> Op {
        match self {
            Self::Number(_) | Self::Symbol(_) => self,
            Self::Neg(a) => Self::Neg(other(a)),
            Self::Sqrt(a) => Self::Sqrt(other(a)),
            Self::Sin(a) => Self::Sin(other(a)),
            Self::Cos(a) => Self::Cos(other(a)),
            Self::Asin(a) => Self::Asin(other(a)),
            Self::Acos(a) => Self::Acos(other(a)),
            Self::Exp(a) => Self::Exp(other(a)),
            Self::Ln(a) => Self::Ln(other(a)),
            Self::Abs(a) => Self::Abs(other(a)),
            Self::Sign(a) => Self::Sign(other(a)),
            Self::Floor(a) => Self::Floor(other(a)),
            Self::Add(a, b) => Self::Add(other(a), other(b)),
            Self::Sub(a, b) => Self::Sub(other(a), other(b)),
            Self::Mul(a, b) => Self::Mul(other(a), other(b)),
            Self::Div(a, b) => Self::Div(other(a), other(b)),
            Self::Atan2(a, b) => Self::Atan2(other(a), other(b)),
            Self::Min(a, b) => Self::Min(other(a), other(b)),
            Self::Max(a, b) => Self::Max(other(a), other(b)),
            Self::Less(a, b) => Self::Less(other(a), other(b)),
            Self::Select(c, a, b) => Self::Select(other(c), other(a), other(b)),
        }
    }

    pub(crate) fn operand_array(self) -> ([Ref; 3], usize) {
        const NONE: Ref = Ref(u32::MAX);
        match self {
            Self::Number(_) | Self::Symbol(_) => ([NONE; 3], 0),
            Self::Neg(a)
            | Self::Sqrt(a)
            | Self::Sin(a)
            | Self::Cos(a)
            | Self::Asin(a)
            | Self::Acos(a)
            | Self::Exp(a)
            | Self::Ln(a)
            | Self::Abs(a)
            | Self::Sign(a)
            | Self::Floor(a) => ([a, NONE, NONE], 1),
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Atan2(a, b)
            | Self::Min(a, b)
            | Self::Max(a, b)
            | Self::Less(a, b) => ([a, b, NONE], 2),
            Self::Select(c, a, b) => ([c, a, b], 3),
        }
    }
}

/// One line of a tape.
#[derive(Copy, Clone, PartialEq, Debug)]
pub struct Instr {
    /// The operation and its operands.
    pub op: Op,
    /// The expression whose value it is (for names: `graph.name(expr)`); `None` for a step on the way to one. If a
    /// defined atom and its value share the instruction, this is the atom.
    pub expr: Option<Expr>,
    /// How often the value is read: by later instructions, and once for each output that it is.
    pub uses: u32,
}

/// A list of operations that computes some expressions.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Tape {
    /// The instructions. Operands come before their users; what belongs to the first output comes first.
    pub ops: Vec<Instr>,
    /// Instructions whose values are those of the roots, in the order of the roots.
    pub outputs: Vec<Ref>,
}

impl Tape {
    /// Lowers expressions to operations.
    ///
    /// Sums run left to right with a positive term first, coefficients of magnitude 1 cost nothing, a fraction has
    /// one division, small powers are multiplied out, equal operations on equal operands stand once.
    pub fn new(graph: &Graph, roots: &[Expr]) -> Self {
        lower::lower(graph, roots)
    }

    /// The operations, counted.
    pub fn count(&self) -> Count {
        Count::of(&self.ops)
    }

    /// The symbols that are read, in the order of their first use.
    pub fn inputs(&self) -> Vec<Expr> {
        let symbol = |instr: &Instr| match instr.op {
            Op::Symbol(symbol) => Some(symbol),
            _ => None,
        };
        self.ops.iter().filter_map(symbol).collect()
    }

    /// Evaluates once with the given values of symbols. For many evaluations bind a [`Machine`].
    ///
    /// # Errors
    /// The first symbol that is read but has no value.
    pub fn eval(&self, bindings: &[(Expr, f64)]) -> Result<Vec<f64>, Expr> {
        let (symbols, values): (Vec<_>, Vec<_>) = bindings.iter().copied().unzip();
        let mut outputs = vec![0.0; self.outputs.len()];
        Machine::new(self, &symbols)?.run(&values, &mut outputs);
        Ok(outputs)
    }
}
