//! What an expression of the language stands for.

mod call;
mod condition;
pub(super) mod expect;
mod expression;
pub(super) mod function_table;
mod inertia;
pub(super) mod interpolation;
pub(super) mod lazy;
pub(super) mod member;
pub(super) mod member_table;
mod rate;

use core::ops::{Add, Neg, Sub};

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::model::FrameRef;
use crate::units::Dimension;

/// What an expression reads, as a set; it decides where the expression may stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Reads(u16);

impl Reads {
    pub(super) const NOTHING: Reads = Reads(0);
    pub(super) const PARAM: Reads = Reads(1);
    pub(super) const INPUT: Reads = Reads(2);
    pub(super) const TIME: Reads = Reads(4);
    pub(super) const STATE: Reads = Reads(8);
    pub(super) const POSITION: Reads = Reads(16);
    pub(super) const VELOCITY: Reads = Reads(32);
    pub(super) const ACCELERATION: Reads = Reads(64);
    pub(super) const REACTION: Reads = Reads(128);

    /// What is known before the run: parameters.
    pub(super) const FIXED: Reads = Reads::PARAM;
    /// What a place may depend on: parameters and the time.
    pub(super) const SCHEDULED: Reads = Reads(1 | 4);
    /// What a constraint may hold.
    pub(super) const GEOMETRY: Reads = Reads(1 | 4 | 16);
    /// What is known at a state: everything but the unknowns of the equations of motion.
    pub(super) const KNOWN: Reads = Reads(1 | 2 | 4 | 8 | 16 | 32);
    /// Everything.
    pub(super) const ALL: Reads = Reads(255);

    const NAMES: [(Reads, &'static str); 8] = [
        (Reads::PARAM, "parameters"),
        (Reads::INPUT, "inputs"),
        (Reads::TIME, "the time"),
        (Reads::STATE, "states"),
        (Reads::POSITION, "positions"),
        (Reads::VELOCITY, "velocities"),
        (Reads::ACCELERATION, "accelerations"),
        (Reads::REACTION, "reactions"),
    ];

    pub(super) const fn and(self, other: Reads) -> Reads {
        Reads(self.0 | other.0)
    }

    pub(super) fn has(self, other: Reads) -> bool {
        self.0 & other.0 != 0
    }

    /// What is left without the others.
    pub(super) fn beyond(self, allowed: Reads) -> Reads {
        Reads(self.0 & !allowed.0)
    }

    /// Why inputs or states tell no place, and what to do instead.
    pub(super) fn no_place(self) -> Option<[&'static str; 2]> {
        if self.has(Reads::INPUT) {
            return Some([
                "an input is held over a step and has no rate: what it places would rest in every step and jump between them",
                "to move it between steps make it a `param`: joints are assembled anew; to move it within them write a function \
                 of the time, or place it on a body whose joint has a `drive` that follows the input",
            ]);
        }
        self.has(Reads::STATE).then_some([
            "joints are closed by places alone, before states are known",
            "place it on a body whose joint has a `drive` that follows the state",
        ])
    }

    /// `positions and the time`
    pub(super) fn describe(self) -> String {
        let names: Vec<&str> =
            Reads::NAMES.iter().filter(|(of, _)| self.has(*of)).map(|(_, name)| *name).collect();
        match names.split_last() {
            None => "nothing".to_string(),
            Some((last, [])) => (*last).to_string(),
            Some((last, others)) => format!("{} and {last}", others.join(", ")),
        }
    }
}

/// How a value came about: it decides how strictly its unit is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// From bare numbers alone: it has no unit, and where one is needed it must say so.
    Bare,
    /// From literals and parameters that state a unit.
    Written,
    /// From anything else; the radian cancels freely.
    Derived,
}

/// All that is known of a quantity besides its expression.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nature {
    pub(super) dimension: Dimension,
    pub(super) form: Form,
    pub(super) reads: Reads,
}

impl Nature {
    /// Of a bare number.
    pub(super) const BARE: Nature =
        Nature { dimension: Dimension::NUMBER, form: Form::Bare, reads: Reads::NOTHING };

    pub(super) fn derived(dimension: Dimension, reads: Reads) -> Nature {
        Nature { dimension, form: Form::Derived, reads }
    }

    pub(super) fn written(dimension: Dimension, reads: Reads) -> Nature {
        Nature { dimension, form: Form::Written, reads }
    }

    /// Of a product or a quotient.
    pub(super) fn scaled(self, other: Nature, dimension: Dimension) -> Nature {
        let form = match (self.form, other.form) {
            (Form::Bare, form) | (form, Form::Bare) => form,
            _ => Form::Derived,
        };
        Nature { dimension, form, reads: self.reads.and(other.reads) }
    }

    /// Of a sum, a choice between both, and the like: the dimension of whichever states one.
    pub(super) fn joined(self, other: Nature) -> Nature {
        let (form, dimension) = match (self.form, other.form) {
            (Form::Bare, form) => (form, other.dimension),
            (form, Form::Bare) => (form, self.dimension),
            (Form::Written, Form::Written) => (Form::Written, self.dimension),
            _ => (Form::Derived, self.dimension),
        };
        Nature { dimension, form, reads: self.reads.and(other.reads) }
    }
}

/// A number or a vector, and what is known of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<T> {
    pub(super) value: T,
    pub(super) nature: Nature,
}

pub(super) type Scalar = Quantity<Expr>;
pub(super) type Vector = Quantity<Vec2>;

impl<T> Quantity<T> {
    pub(super) const fn new(value: T, nature: Nature) -> Quantity<T> {
        Quantity { value, nature }
    }

    /// Something else of the same nature.
    pub(super) fn map<U>(self, of: impl FnOnce(T) -> U) -> Quantity<U> {
        Quantity { value: of(self.value), nature: self.nature }
    }
}

/// What can be added, compared with zero and chosen between: a number or a vector.
pub(super) trait Additive:
    Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    fn is_zero(self) -> bool;

    /// The same of each component.
    fn each(self, of: impl FnMut(Expr) -> Expr) -> Self;

    /// `yes` where the condition holds, else `no`.
    fn select(condition: &Condition, yes: Self, no: Self) -> Self;
}

impl Additive for Expr {
    fn is_zero(self) -> bool {
        self.is_zero()
    }

    fn each(self, mut of: impl FnMut(Expr) -> Expr) -> Expr {
        of(self)
    }

    fn select(condition: &Condition, yes: Expr, no: Expr) -> Expr {
        condition.select(yes, no)
    }
}

impl Additive for Vec2 {
    fn is_zero(self) -> bool {
        self.is_zero()
    }

    fn each(self, of: impl FnMut(Expr) -> Expr) -> Vec2 {
        self.map(of)
    }

    fn select(condition: &Condition, yes: Vec2, no: Vec2) -> Vec2 {
        let x = condition.select(yes.x, no.x);
        Vec2::new(x, condition.select(yes.y, no.y))
    }
}

impl<T: Additive> Quantity<T> {
    /// A zero without a unit, which goes with every dimension.
    pub(super) fn is_bare_zero(self) -> bool {
        self.nature.form == Form::Bare && self.value.is_zero()
    }

    /// As one that is written in a dimension.
    pub(super) fn written_as(self, dimension: Dimension) -> Quantity<T> {
        Quantity::new(self.value, Nature::written(dimension, self.nature.reads))
    }

    /// `factor self`
    pub(super) fn times(self, factor: Scalar) -> Quantity<T> {
        let dimension = factor.nature.dimension.times(self.nature.dimension);
        let value = self.value.each(|x| factor.value * x);
        Quantity::new(value, factor.nature.scaled(self.nature, dimension))
    }

    /// `self/divisor`
    pub(super) fn over(self, divisor: Scalar) -> Quantity<T> {
        let dimension = self.nature.dimension.over(divisor.nature.dimension);
        let value = self.value.each(|x| x / divisor.value);
        Quantity::new(value, self.nature.scaled(divisor.nature, dimension))
    }
}

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
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// A number with its dimension.
    Scalar(Scalar),
    /// A vector in absolute axes, or any pair of one dimension.
    Vector(Vector),
    /// What `if` asks for.
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
}

impl Value {
    /// The components of a number or a vector, and what is known of them.
    pub(super) fn components(&self) -> Option<(Vec<Expr>, Nature)> {
        match self {
            Value::Scalar(x) => Some((vec![x.value], x.nature)),
            Value::Vector(v) => Some((v.value.components().to_vec(), v.nature)),
            _ => None,
        }
    }

    /// With its article.
    pub(super) fn kind(&self) -> &'static str {
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
        }
    }
}

/// A condition, kept apart from the graph until an `if` turns it into selections.
#[derive(Clone, Debug)]
pub(super) enum Condition {
    Known(bool),
    /// The first is less than the second.
    Less(Expr, Expr),
    Not(Box<Condition>),
    All(Vec<Condition>),
    Any(Vec<Condition>),
}

/// The mistake has been reported; the value does not exist.
#[derive(Clone, Copy, Debug)]
pub(super) struct Failed;

/// What evaluation gives.
pub(super) type Eval<T> = Result<T, Failed>;

/// All values, or the first failure; every one is worked out, so that the mistakes of all are found.
pub(super) fn all<T>(results: impl Iterator<Item = Eval<T>>) -> Eval<Vec<T>> {
    let results: Vec<Eval<T>> = results.collect();
    results.into_iter().collect()
}
