//! Nodes of the arena.

use core::fmt;

use crate::hash::Mixer;
use crate::number::Number;

/// An expression: the index of a node in its [`Graph`](crate::Graph).
///
/// Equal expressions have equal indices. A node comes after everything that it is made of, so that ascending order
/// is an order of evaluation, and the order of creation is the order of printing.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expr(pub(crate) u32);

impl Expr {
    /// Position in the arena, below `graph.len()`.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation. See the canonical forms at the variants; the constructors of the graph keep them.
#[derive(Clone, PartialEq, Debug)]
pub enum Node {
    /// A constant.
    Number(Number),
    /// A named atom.
    Symbol,
    /// A named atom that stands for the value of another expression and is never expanded.
    Defined(Expr),
    /// `constant + sum of coefficient * term`.
    ///
    /// Terms ascend and are neither numbers nor sums, coefficients are not zero, the first one is positive, and
    /// coefficients that all have one magnitude have magnitude 1. What violates the last two is a sum of the single
    /// scaled term that is the canonical sum: `-(b*x + c*y)` shares the node of `b*x + c*y`.
    Sum {
        /// The constant part.
        constant: Number,
        /// Coefficient and term.
        terms: Box<[(Number, Expr)]>,
    },
    /// Product of integer powers: factors ascend, exponents are not zero. A coefficient lives in a sum around it.
    Product(Box<[(Expr, i32)]>),
    /// A function of its arguments.
    Call(Function, Box<[Expr]>),
    /// `a < b`, false if either is NaN. Stands in the first place of a `Select` only.
    Less(Expr, Expr),
    /// `Select(condition, a, b)` is `a` where the condition holds, else `b`.
    Select(Expr, Expr, Expr),
}

impl Node {
    /// The node with other operands, as they come: not in canonical form.
    pub(crate) fn mapped(self, of: impl Fn(Expr) -> Expr) -> Node {
        match self {
            Node::Number(_) | Node::Symbol => self,
            Node::Defined(value) => Node::Defined(of(value)),
            Node::Sum { constant, mut terms } => {
                terms.iter_mut().for_each(|(_, term)| *term = of(*term));
                Node::Sum { constant, terms }
            }
            Node::Product(mut factors) => {
                factors.iter_mut().for_each(|(factor, _)| *factor = of(*factor));
                Node::Product(factors)
            }
            Node::Call(function, mut arguments) => {
                arguments.iter_mut().for_each(|argument| *argument = of(*argument));
                Node::Call(function, arguments)
            }
            Node::Less(a, b) => Node::Less(of(a), of(b)),
            Node::Select(condition, a, b) => Node::Select(of(condition), of(a), of(b)),
        }
    }
}

/// The elementary functions. There is no tangent: `tan` is the quotient of the pair `sin`, `cos`.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Function {
    /// Sine of an angle in radians.
    Sin,
    /// Cosine of an angle in radians.
    Cos,
    /// Arc sine in [-pi/2, pi/2].
    Asin,
    /// Arc cosine in [0, pi].
    Acos,
    /// `atan2(y, x)`: the angle of the point (x, y) in [-pi, pi].
    Atan2,
    /// Square root; NaN below zero.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Absolute value.
    Abs,
    /// `if 0 < x { 1 } else if x < 0 { -1 } else { x }`, so that zero and NaN pass through.
    Sign,
    /// `min(a, b)` is `if a < b { a } else { b }`.
    Min,
    /// `max(a, b)` is `if b < a { a } else { b }`.
    Max,
    /// The largest integer that is not above x.
    Floor,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Sin,
        Self::Cos,
        Self::Asin,
        Self::Acos,
        Self::Atan2,
        Self::Sqrt,
        Self::Exp,
        Self::Ln,
        Self::Abs,
        Self::Sign,
        Self::Min,
        Self::Max,
        Self::Floor,
    ];

    /// The name in the language and in print.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan2 => "atan2",
            Self::Sqrt => "sqrt",
            Self::Exp => "exp",
            Self::Ln => "ln",
            Self::Abs => "abs",
            Self::Sign => "sign",
            Self::Min => "min",
            Self::Max => "max",
            Self::Floor => "floor",
        }
    }

    /// Number of arguments.
    pub const fn arity(self) -> usize {
        match self {
            Self::Atan2 | Self::Min | Self::Max => 2,
            _ => 1,
        }
    }
}

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Node {
    /// Operands in order; an iterator would cost more than the loop body in an unoptimised build.
    pub fn for_each_child(&self, mut visit: impl FnMut(Expr)) {
        match self {
            Self::Number(_) | Self::Symbol => {}
            Self::Defined(value) => visit(*value),
            Self::Sum { terms, .. } => {
                for &(_, term) in terms {
                    visit(term);
                }
            }
            Self::Product(factors) => {
                for &(factor, _) in factors {
                    visit(factor);
                }
            }
            Self::Call(_, arguments) => {
                for &argument in arguments {
                    visit(argument);
                }
            }
            Self::Less(a, b) => {
                visit(*a);
                visit(*b);
            }
            Self::Select(condition, a, b) => {
                visit(*condition);
                visit(*a);
                visit(*b);
            }
        }
    }

    pub(crate) fn hash(&self) -> u32 {
        match self {
            Self::Sum { constant, terms } => hash_sum(*constant, terms),
            Self::Product(factors) => hash_product(factors),
            Self::Number(number) => {
                let mut mixer = Mixer::new(1);
                number.mix(&mut mixer);
                mixer.finish()
            }
            Self::Symbol => 0, // never looked up
            Self::Defined(value) => hash_words(2, &[value.0]),
            Self::Call(function, arguments) => {
                let mut mixer = Mixer::new(3 + 16 * (*function as u64));
                for argument in arguments {
                    mixer.word(u64::from(argument.0));
                }
                mixer.finish()
            }
            Self::Less(a, b) => hash_words(4, &[a.0, b.0]),
            Self::Select(condition, a, b) => hash_words(5, &[condition.0, a.0, b.0]),
        }
    }
}

pub(crate) fn hash_words(tag: u64, words: &[u32]) -> u32 {
    let mut mixer = Mixer::new(tag);
    for &word in words {
        mixer.word(u64::from(word));
    }
    mixer.finish()
}

pub(crate) fn hash_sum(constant: Number, terms: &[(Number, Expr)]) -> u32 {
    let mut mixer = Mixer::new(6);
    constant.mix(&mut mixer);
    for &(coefficient, term) in terms {
        coefficient.mix(&mut mixer);
        mixer.word(u64::from(term.0));
    }
    mixer.finish()
}

pub(crate) fn hash_product(factors: &[(Expr, i32)]) -> u32 {
    let mut mixer = Mixer::new(7);
    for &(factor, exponent) in factors {
        mixer.word(u64::from(factor.0) << 32 | u64::from(exponent as u32));
    }
    mixer.finish()
}
