//! Values of expressions of the language.

mod allowed;
mod call;
pub(super) mod condition;
mod direction;
pub(super) mod drawn;
pub(super) mod expect;
mod expression;
pub(super) mod function_table;
mod inertia;
pub(super) mod interpolation;
mod jumps;
pub(super) mod lazy;
pub(super) mod member;
pub(super) mod member_table;
mod quantity;
mod rate;
pub(super) mod section;

use crate::collect::CollectVec;
use plm_cas::Expr;

use crate::model::FrameRef;
pub(crate) use direction::Direction;
pub(crate) use quantity::{Additive, Form, Nature, Quantity, Reads, Scalar, Vector};

impl From<Scalar> for Value {
    fn from(scalar: Scalar) -> Value {
        Value::Scalar(scalar)
    }
}

impl From<Vector> for Value {
    fn from(vector: Vector) -> Value {
        Value::Vector(vector)
    }
}

/// The value of an expression.
#[derive(Clone)]
pub(crate) enum Value {
    /// A number with its dimension.
    Scalar(Scalar),
    /// A vector in absolute axes, or any pair of one dimension.
    Vector(Vector),
    /// Condition of an `if`.
    Condition(Condition, Reads),
    /// A frame of a body or of the ground.
    Frame(FrameRef),
    /// A body; `None` is the ground.
    Body(Option<usize>),
    /// A node: index into the resolver's list.
    Node(usize),
    /// A part in use.
    Instance(usize),
    /// A choice made at compile time: index into the resolver's list.
    Choice(usize),
    /// A function that was handed over: index into the resolver's list.
    Function(usize),
    /// A list of points: how many.
    Points(usize),
}

impl Value {
    /// The components of a number or a vector, and what is known of them.
    pub(crate) fn components(&self) -> Option<(Vec<Expr>, Nature)> {
        match self {
            Value::Scalar(x) => Some((vec![x.value], x.nature)),
            Value::Vector(v) => Some((v.value.components().to_vec(), v.nature)),
            _ => None,
        }
    }

    /// Reads of a number, a vector or a condition.
    pub(crate) fn reads(&self) -> Reads {
        match self {
            Value::Scalar(x) => x.nature.reads,
            Value::Vector(v) => v.nature.reads,
            Value::Condition(_, reads) => *reads,
            _ => Reads::NOTHING,
        }
    }

    /// With its article.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Value::Scalar(..) => "a number",
            Value::Vector(..) => "a vector",
            Value::Condition(..) => "a condition",
            Value::Frame(_) => "a frame",
            Value::Body(Some(_)) => "a body",
            Value::Body(None) => "the ground",
            Value::Node(_) => "a node",
            Value::Instance(_) => "a part",
            Value::Choice(_) => "a choice",
            Value::Function(_) => "a function",
            Value::Points(_) => "a list of points",
        }
    }
}

/// A condition, kept apart from the graph until an `if` turns it into selections.
#[derive(Clone)]
pub(crate) enum Condition {
    Known(bool),
    /// The first is less than the second.
    Less(Expr, Expr),
    Not(Box<Condition>),
    All(Vec<Condition>),
    Any(Vec<Condition>),
}

/// The mistake has been reported; the value does not exist.
#[derive(Clone, Copy)]
pub(crate) struct Failed;

/// Result of evaluation.
pub(crate) type Eval<T> = Result<T, Failed>;

/// All values, or the first failure; every one is worked out, so that the mistakes of all are found.
pub(crate) fn all<T>(results: impl Iterator<Item = Eval<T>>) -> Eval<Vec<T>> {
    let results: Vec<Eval<T>> = results.collect_vec();
    results.into_iter().collect()
}
