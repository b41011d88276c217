//! Directions: an angle, or a vector that points there.

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Reads, Value, Vector};
use crate::syntax::ast;
use crate::units::Dimension;

/// A direction as it was written.
#[derive(Clone, Copy)]
pub(crate) enum Direction {
    /// An angle against the x axis, rad.
    Angle(Expr),
    /// A vector that points there, of any length.
    Vector(Vec2),
}

impl Direction {
    /// Its angle against the x axis, rad.
    pub(crate) fn angle(self) -> Expr {
        match self {
            Direction::Angle(angle) => angle,
            Direction::Vector(Vec2 { x, y }) => y.atan2(x),
        }
    }
}

impl<'a> Resolver<'a> {
    /// A direction that reads no more than it may, and what it reads.
    pub(crate) fn eval_direction(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        reads: Reads,
    ) -> Eval<(Direction, Reads)> {
        match self.eval(scope, expr)? {
            Value::Scalar(found) => {
                let angle = self.suits(scope, expr, found, Dimension::ANGLE, reads)?;
                Ok((Direction::Angle(angle.value), angle.nature.reads))
            }
            Value::Vector(Vector { value, nature }) if !value.is_zero() => {
                self.reads_only(scope, expr, nature.reads, reads)?;
                Ok((Direction::Vector(value), nature.reads))
            }
            Value::Vector(_) => {
                self.error(
                    scope,
                    Code::WrongKind,
                    expr.span,
                    "expected a direction, found the vector (0, 0)",
                )
                .help("a vector has a direction where it joins two different points");
                Err(Failed)
            }
            other => Err(self.wrong_kind(scope, expr, "an angle or a vector", &other)),
        }
    }
}
