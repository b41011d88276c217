//! The functions of the language, as a table.

use std::ops::RangeInclusive;

use plm_cas::Expr;
use plm_cas::algebra::{Rotation, Vec2};

use crate::model::ContactMode;
use crate::resolve::values::interpolation::Interpolation;
use crate::resolve::values::section::SectionValue;
use crate::units::Dimension;

/// A function of the language.
pub(crate) struct Function {
    pub(crate) name: &'static str,
    /// How many arguments it takes.
    pub(crate) arguments: RangeInclusive<usize>,
    pub(crate) meaning: Meaning,
}

/// Meaning of a function.
pub(crate) enum Meaning {
    OfOne(OfOne),
    /// The largest integer that is not above a number.
    Floor,
    /// Of a quantity and a period.
    Remainder,
    /// Of numbers of one dimension, which the result has too.
    OfAlike(fn(&[Expr]) -> Expr),
    /// The angle of the point `(x, y)`, from y and x.
    Atan2,
    /// Values at points `(x, y)`, and how they go on between.
    Table(Interpolation),
    /// Of two vectors, a number whose dimension is the product of theirs.
    Product(fn(Vec2, Vec2) -> Expr),
    /// The length of a vector.
    Norm,
    /// A vector turned by an angle, counter-clockwise.
    Turn,
    /// A point in other axes, from point, origin and angle of the relative axes in the absolute ones.
    Axes(fn(Vec2, Vec2, Expr) -> Vec2),
    /// The derivative with respect to time.
    Rate,
    /// The value in the pose as drawn.
    Drawn,
    /// The derivative of a function that a part has, by its argument.
    Derivative,
    /// The number of points in a list.
    Count,
    /// The multipliers of one constraint row, or of two.
    Reaction,
    /// Does a row of contact do this?
    Mode(ContactMode),
    /// `Izz = factor mass (a^2 + b^2 + …)` over the lengths that follow the mass: numerator and denominator of the factor.
    Inertia(i32, i32),
    /// Of a cross section, by its name and its sizes.
    Section(SectionValue),
}

/// A function of one number.
pub(crate) struct OfOne {
    /// The dimension of its argument, if not any.
    pub(crate) argument: Option<Dimension>,
    pub(crate) gives: Gives,
    pub(crate) domain: Option<Domain>,
    pub(crate) value: fn(Expr) -> Expr,
}

/// The dimension of what a function gives.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gives {
    /// That of its argument.
    Same,
    /// The root of that of its argument.
    Root,
    Number,
    Angle,
}

/// Domain of a function of one number, and its words in messages.
pub(crate) struct Domain {
    pub(crate) holds: fn(f64) -> bool,
    pub(crate) text: &'static str,
}

/// Is the value of a call a vector?
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum CallShape {
    Number,
    Vector,
    /// As the argument is.
    OfArgument,
    /// If there are two arguments.
    OfCount,
}

impl Function {
    pub(crate) fn named(name: &str) -> Option<&'static Function> {
        FUNCTIONS.iter().find(|function| function.name == name)
    }

    pub(crate) fn shape(&self) -> CallShape {
        match self.meaning {
            Meaning::Turn | Meaning::Axes(_) => CallShape::Vector,
            Meaning::Rate | Meaning::Drawn => CallShape::OfArgument,
            Meaning::Reaction => CallShape::OfCount,
            _ => CallShape::Number,
        }
    }
}

/// In the order in which they are told of. The shapes are those of the manual's appendix 1, with their moments of inertia `Izz`
/// about the axis through G normal to the plane; its thin-walled hollow cylinder has a misprint in `Ixx` alone.
pub(crate) const FUNCTIONS: &[Function] = &[
    of_one("abs", None, Gives::Same, None, Expr::abs),
    of_one("sign", None, Gives::Number, None, Expr::sign),
    function("floor", 1..=1, Meaning::Floor),
    function("mod", 2..=2, Meaning::Remainder),
    function("min", 2..=usize::MAX, Meaning::OfAlike(least)),
    function("max", 2..=usize::MAX, Meaning::OfAlike(greatest)),
    function("clamp", 3..=3, Meaning::OfAlike(|x| x[0].clamp(x[1], x[2]))),
    of_one("sqrt", None, Gives::Root, Some(domain(|x| x >= 0.0, "0 and above")), Expr::sqrt),
    of_one("exp", NUMBER, Gives::Number, None, Expr::exp),
    of_one("ln", NUMBER, Gives::Number, Some(domain(|x| x > 0.0, "above 0")), Expr::ln),
    of_one("sin", ANGLE, Gives::Number, None, Expr::sin),
    of_one("cos", ANGLE, Gives::Number, None, Expr::cos),
    of_one("tan", ANGLE, Gives::Number, None, Expr::tan),
    of_one("asin", NUMBER, Gives::Angle, Some(domain(|x| x.abs() <= 1.0, "-1 to 1")), Expr::asin),
    of_one("acos", NUMBER, Gives::Angle, Some(domain(|x| x.abs() <= 1.0, "-1 to 1")), Expr::acos),
    of_one("atan", NUMBER, Gives::Angle, None, |x| x.atan2(Expr::ONE)),
    function("atan2", 2..=2, Meaning::Atan2),
    function("table", 3..=usize::MAX, Meaning::Table(Interpolation::Lines)),
    function("smooth_table", 3..=usize::MAX, Meaning::Table(Interpolation::Spline)),
    function("dot", 2..=2, Meaning::Product(Vec2::dot)),
    function("cross", 2..=2, Meaning::Product(Vec2::cross)),
    function("norm", 1..=1, Meaning::Norm),
    function("turn", 2..=2, Meaning::Turn),
    function("to_absolute", 3..=3, Meaning::Axes(to_absolute)),
    function("to_relative", 3..=3, Meaning::Axes(to_relative)),
    function("rate", 1..=1, Meaning::Rate),
    function("drawn", 1..=1, Meaning::Drawn),
    function("derivative", 2..=3, Meaning::Derivative),
    function("count", 1..=1, Meaning::Count),
    function("reaction", 1..=2, Meaning::Reaction),
    function("is_open", 1..=1, Meaning::Mode(ContactMode::Open)),
    function("is_sticking", 1..=1, Meaning::Mode(ContactMode::Sticking)),
    function("rod", 2..=2, Meaning::Inertia(1, 12)),
    function("disc", 2..=2, Meaning::Inertia(1, 2)),
    function("hollow_cylinder", 3..=3, Meaning::Inertia(1, 2)),
    function("thin_cylinder", 2..=2, Meaning::Inertia(1, 1)),
    function("plate", 3..=3, Meaning::Inertia(1, 12)),
    function("sphere", 2..=2, Meaning::Inertia(2, 5)),
    function("thin_sphere", 2..=2, Meaning::Inertia(2, 3)),
    function("section_area", 2..=4, Meaning::Section(SectionValue::Area)),
    function("section_moment", 2..=4, Meaning::Section(SectionValue::Moment)),
];

const NUMBER: Option<Dimension> = Some(Dimension::NUMBER);
const ANGLE: Option<Dimension> = Some(Dimension::ANGLE);

const fn function(name: &'static str, arguments: RangeInclusive<usize>, meaning: Meaning) -> Function {
    Function { name, arguments, meaning }
}

const fn of_one(
    name: &'static str,
    argument: Option<Dimension>,
    gives: Gives,
    domain: Option<Domain>,
    value: fn(Expr) -> Expr,
) -> Function {
    function(name, 1..=1, Meaning::OfOne(OfOne { argument, gives, domain, value }))
}

const fn domain(holds: fn(f64) -> bool, text: &'static str) -> Domain {
    Domain { holds, text }
}

fn least(all: &[Expr]) -> Expr {
    all[1..].iter().fold(all[0], |least, x| least.min(*x))
}

fn greatest(all: &[Expr]) -> Expr {
    all[1..].iter().fold(all[0], |greatest, x| greatest.max(*x))
}

/// The manual's PLMCALCUL, section 4.8: relative axes to absolute ones.
fn to_absolute(point: Vec2, origin: Vec2, angle: Expr) -> Vec2 {
    origin + Rotation::by(angle) * point
}

/// The manual's PLMCALCUL, section 4.8: absolute axes to relative ones.
fn to_relative(point: Vec2, origin: Vec2, angle: Expr) -> Vec2 {
    let arm = point - origin;
    Rotation::by(-angle) * arm
}
