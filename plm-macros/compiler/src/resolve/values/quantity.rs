//! Numbers and vectors, with what is known of them: dimension, how they came about, what they read.

use crate::collect::CollectVec;
use core::ops::{Add, Neg, Sub};

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::resolve::values::Condition;
use crate::units::Dimension;

/// Reads of an expression, as a set; it decides where the expression may stand.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Reads(u16);

impl Reads {
    pub(crate) const NOTHING: Reads = Reads(0);
    pub(crate) const PARAM: Reads = Reads(1);
    pub(crate) const INPUT: Reads = Reads(2);
    pub(crate) const TIME: Reads = Reads(4);
    pub(crate) const STATE: Reads = Reads(8);
    pub(crate) const POSITION: Reads = Reads(16);
    pub(crate) const VELOCITY: Reads = Reads(32);
    pub(crate) const ACCELERATION: Reads = Reads(64);
    pub(crate) const REACTION: Reads = Reads(128);
    /// The push of a unilateral row.
    pub(crate) const PUSH: Reads = Reads(256);
    /// The force of a friction row.
    pub(crate) const FRICTION: Reads = Reads(512);

    /// Modes of rows of contact: open, sticking.
    pub(crate) const MODE: Reads = Reads(1024);
    /// A sum at a node, whose summands are not known yet.
    pub(crate) const SUM: Reads = Reads(2048);

    /// Reads that are known before the run: parameters.
    pub(crate) const FIXED: Reads = Reads::PARAM;
    /// Reads that a place may have: parameters and the time.
    pub(crate) const SCHEDULED: Reads = Reads::PARAM.and(Reads::TIME);
    /// Reads that a constraint may have.
    pub(crate) const GEOMETRY: Reads = Reads::SCHEDULED.and(Reads::POSITION);
    /// Reads that are known at a state: everything but the unknowns of the equations of motion.
    pub(crate) const KNOWN: Reads =
        Reads::GEOMETRY.and(Reads::INPUT).and(Reads::STATE).and(Reads::VELOCITY).and(Reads::SUM);
    /// Reads that a force or a rate may have: all but what contacts do, which is not known before they are solved.
    pub(crate) const ACTING: Reads = Reads::KNOWN.and(Reads::ACCELERATION).and(Reads::REACTION);
    /// Reads that the bound of a friction may have.
    pub(crate) const BOUND: Reads = Reads::KNOWN.and(Reads::PUSH);
    /// Reads that an event may have.
    pub(crate) const EVENT: Reads = Reads::KNOWN.and(Reads::MODE);
    /// Everything.
    pub(crate) const ALL: Reads = Reads(4095);

    const NAMES: [(Reads, &'static str); 11] = [
        (Reads::PARAM, "parameters"),
        (Reads::INPUT, "inputs"),
        (Reads::TIME, "the time"),
        (Reads::STATE, "states"),
        (Reads::POSITION, "positions"),
        (Reads::VELOCITY, "velocities"),
        (Reads::ACCELERATION, "accelerations"),
        (Reads::REACTION, "reactions"),
        (Reads::PUSH, "pushes of contacts"),
        (Reads::FRICTION, "frictions"),
        (Reads::MODE, "what contacts do"),
    ];

    pub(crate) const fn and(self, other: Reads) -> Reads {
        Reads(self.0 | other.0)
    }

    pub(crate) fn has(self, other: Reads) -> bool {
        self.0 & other.0 != 0
    }

    /// The set without the others.
    pub(crate) fn beyond(self, allowed: Reads) -> Reads {
        Reads(self.0 & !allowed.0)
    }

    /// Why inputs or states tell no place, and what to do instead.
    pub(crate) fn no_place(self) -> Option<[&'static str; 2]> {
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
    pub(crate) fn describe(self) -> String {
        let names: Vec<&str> =
            Reads::NAMES.iter().filter(|(of, _)| self.has(*of)).map(|(_, name)| *name).collect_vec();
        match names.split_last() {
            // A place that sums may stand in is told by what they read.
            None if self.has(Reads::SUM) => "what acts on nodes".to_string(),
            None => "nothing".to_string(),
            Some((last, [])) => (*last).to_string(),
            Some((last, others)) => format!("{} and {last}", others.join(", ")),
        }
    }
}

/// How a value came about: it decides how strictly its unit is looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// From bare numbers alone: it has no unit, and where one is needed it must say so.
    Bare,
    /// From literals and parameters that state a unit.
    Written,
    /// From anything else; the radian cancels freely.
    Derived,
}

/// All that is known of a quantity besides its expression.
#[derive(Clone, Copy)]
pub(crate) struct Nature {
    pub(crate) dimension: Dimension,
    pub(crate) form: Form,
    pub(crate) reads: Reads,
}

impl Nature {
    /// Of a bare number.
    pub(crate) const BARE: Nature =
        Nature { dimension: Dimension::NUMBER, form: Form::Bare, reads: Reads::NOTHING };

    pub(crate) fn derived(dimension: Dimension, reads: Reads) -> Nature {
        Nature { dimension, form: Form::Derived, reads }
    }

    pub(crate) fn written(dimension: Dimension, reads: Reads) -> Nature {
        Nature { dimension, form: Form::Written, reads }
    }

    /// Of a product or a quotient.
    pub(crate) fn scaled(self, other: Nature, dimension: Dimension) -> Nature {
        let form = match (self.form, other.form) {
            (Form::Bare, form) | (form, Form::Bare) => form,
            _ => Form::Derived,
        };
        Nature { dimension, form, reads: self.reads.and(other.reads) }
    }

    /// Of a sum, a choice between both, and the like: the dimension of whichever states one.
    pub(crate) fn joined(self, other: Nature) -> Nature {
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
#[derive(Clone, Copy)]
pub(crate) struct Quantity<T> {
    pub(crate) value: T,
    pub(crate) nature: Nature,
}

pub(crate) type Scalar = Quantity<Expr>;
pub(crate) type Vector = Quantity<Vec2>;

impl<T> Quantity<T> {
    pub(crate) const fn new(value: T, nature: Nature) -> Quantity<T> {
        Quantity { value, nature }
    }

    /// Something else of the same nature.
    pub(crate) fn map<U>(self, of: impl FnOnce(T) -> U) -> Quantity<U> {
        Quantity { value: of(self.value), nature: self.nature }
    }
}

/// Values that can be added, compared with zero and chosen between: a number or a vector.
pub(crate) trait Additive:
    Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    fn is_zero(self) -> bool;

    /// Applies `of` to each component.
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
    pub(crate) fn is_bare_zero(self) -> bool {
        self.nature.form == Form::Bare && self.value.is_zero()
    }

    /// As one that is written in a dimension.
    pub(crate) fn written_as(self, dimension: Dimension) -> Quantity<T> {
        Quantity::new(self.value, Nature::written(dimension, self.nature.reads))
    }

    /// `factor self`
    pub(crate) fn times(self, factor: Scalar) -> Quantity<T> {
        let dimension = factor.nature.dimension.times(self.nature.dimension);
        let value = self.value.each(|x| factor.value * x);
        Quantity::new(value, factor.nature.scaled(self.nature, dimension))
    }

    /// `self/divisor`
    pub(crate) fn over(self, divisor: Scalar) -> Quantity<T> {
        let dimension = self.nature.dimension.over(divisor.nature.dimension);
        let value = self.value.each(|x| x / divisor.value);
        Quantity::new(value, self.nature.scaled(divisor.nature, dimension))
    }
}
