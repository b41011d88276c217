//! Points at a length and an angle from another one, as locked dimensions write them: `p1 + turn((length, 0 mm), angle)`.

use std::ops::Range;

use plm_compiler::syntax::ast::{Expr, ExprKind, IndexedName, Link, Operator};

use super::Sheet;
use crate::number::Literal;
use crate::picture::Point;

/// A point of a drawing at a length and an angle from another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Polar {
    /// The name of the other point.
    pub from: String,
    /// The place of that, m, in the axes of the drawing.
    pub base: Point,
    /// The bytes of the expression.
    pub range: Range<usize>,
    /// How far.
    pub length: Literal,
    /// In which direction.
    pub angle: Literal,
}

impl Polar {
    /// Its place, m, in the axes of the drawing.
    pub fn at(&self) -> Point {
        let (sin, cos) = self.angle.si().sin_cos();
        [self.base[0] + self.length.si() * cos, self.base[1] + self.length.si() * sin]
    }

    /// Its two numbers.
    pub(crate) fn numbers(&self) -> [&Literal; 2] {
        [&self.length, &self.angle]
    }
}

/// The name, the vector and the angle of `name + turn(vector, angle)`.
fn parts(expr: &Expr) -> Option<(&IndexedName, &Expr, &Expr)> {
    let ExprKind::Chain(first, links) = &expr.kind else { return None };
    let (ExprKind::Name(name), [Link { operator: Operator::Add, operand }]) = (&first.kind, &links[..])
    else {
        return None;
    };
    let ExprKind::Call(function, arguments) = &operand.kind else { return None };
    let [along, angle] = &arguments[..] else { return None };
    (function.text == "turn").then_some((name, along, angle))
}

/// The vector of such a point.
pub(super) fn along(expr: &Expr) -> Option<&Expr> {
    parts(expr).map(|(_, along, _)| along)
}

impl Sheet<'_> {
    /// The point that an expression says so.
    pub(crate) fn polar(&self, expr: &Expr) -> Option<Polar> {
        self.polar_within(expr, self.items().len())
    }

    /// A point that stands at another one, and so on, no more often than there are names: a circle has none.
    fn polar_within(&self, expr: &Expr, depth: usize) -> Option<Polar> {
        let (IndexedName { ident, indices }, along, angle) = parts(expr)?;
        if !indices.is_empty() || depth == 0 {
            return None;
        }
        let ([length, across], ..) = self.pair(along)?;
        if !across.is_zero() {
            return None;
        }
        let (name, value) = self.value_of(&ident.text)?;
        let base = match self.pair(value) {
            Some((numbers, ..)) => numbers.each_ref().map(Literal::si),
            None => self.polar_within(value, depth - 1)?.at(),
        };
        let range = self.range(expr.span);
        Some(Polar { from: name.to_owned(), base, range, length, angle: self.number(angle, "rad")? })
    }

    /// Does a point of a drawing stand at another one, or at one that does?
    pub(crate) fn stands_at(&self, name: &str, other: &str) -> bool {
        let mut name = name.to_owned();
        for _ in 0..=self.items().len() {
            if name == other {
                return true;
            }
            match self.value_of(&name).and_then(|(_, value)| self.polar(value)) {
                Some(polar) => name = polar.from,
                None => return false,
            }
        }
        true
    }
}
