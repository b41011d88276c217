//! Expressions, as written.

use plm_cas::Number;

use super::{Ident, IndexedName};
use crate::span::Span;
use crate::units::DisplayUnit;

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Its place.
    pub span: Span,
}

/// Forms of expressions.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// What could not be read. The mistake is reported; the item keeps its name, so that its uses are no mistakes.
    Unknown,
    /// A bare number.
    Number(Number),
    /// A number or a pair with a unit.
    Quantity(Box<Expr>, DisplayUnit),
    /// `(x, y)`
    Pair(Box<Expr>, Box<Expr>),
    /// `name`, `name[i]`
    Name(IndexedName),
    /// `expr.name.name[i]`
    Path(Box<Expr>, Vec<IndexedName>),
    /// `f(args)`
    Call(Ident, Vec<Expr>),
    /// `-expr`
    Neg(Box<Expr>),
    /// `not expr`
    Not(Box<Expr>),
    /// `base ^ exponent`
    Power(Box<Expr>, Box<Expr>),
    /// `expr op expr op expr …`, operators of one precedence, from left to right. A list and not a tree, so that a
    /// long sum is not deep.
    Chain(Box<Expr>, Vec<Link>),
    /// `if expr then expr else expr`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
}

/// An operator with its right operand.
#[derive(Clone, Debug)]
pub struct Link {
    /// The operator.
    pub operator: Operator,
    /// Its right operand.
    pub operand: Expr,
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `or`
    Or,
    /// `and`
    And,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

impl Operator {
    /// How tightly it binds, from 0.
    pub fn precedence(self) -> u8 {
        match self {
            Operator::Or => 0,
            Operator::And => 1,
            Operator::Less
            | Operator::LessEqual
            | Operator::Greater
            | Operator::GreaterEqual
            | Operator::Equal
            | Operator::NotEqual => 2,
            Operator::Add | Operator::Sub => 3,
            Operator::Mul | Operator::Div => 4,
        }
    }

    /// As it is written.
    pub fn text(self) -> &'static str {
        match self {
            Operator::Or => "or",
            Operator::And => "and",
            Operator::Less => "<",
            Operator::LessEqual => "<=",
            Operator::Greater => ">",
            Operator::GreaterEqual => ">=",
            Operator::Equal => "==",
            Operator::NotEqual => "!=",
            Operator::Add => "+",
            Operator::Sub => "-",
            Operator::Mul => "*",
            Operator::Div => "/",
        }
    }
}
