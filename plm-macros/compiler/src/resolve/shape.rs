//! Moments of inertia of common shapes about the axis through G normal to the plane: the manual's appendix 1.

use plm_cas::Expr;

use super::Resolver;
use super::names::ScopeId;
use super::value::{Eval, Nature, Reads, Value, all};
use crate::syntax::ast;
use crate::units::Dimension;

/// `Izz = numerator/denominator mass (a^2 + b^2 + …)` over the lengths that follow the mass.
#[derive(Debug)]
pub(super) struct Shape {
    name: &'static str,
    numerator: i64,
    denominator: i64,
}

/// The Izz of the manual's appendix 1, in its order. Its thin-walled hollow cylinder has a misprint in Ixx alone.
const SHAPES: [Shape; 7] = [
    of("rod", 1, 12),
    of("disc", 1, 2),
    of("hollow_cylinder", 1, 2),
    of("thin_cylinder", 1, 1),
    of("plate", 1, 12),
    of("sphere", 2, 5),
    of("thin_sphere", 2, 3),
];

const fn of(name: &'static str, numerator: i64, denominator: i64) -> Shape {
    Shape { name, numerator, denominator }
}

/// The shape that a function is called after.
pub(super) fn named(name: &str) -> Option<&'static Shape> {
    SHAPES.iter().find(|shape| shape.name == name)
}

impl<'a> Resolver<'a> {
    pub(super) fn moment_of_inertia(
        &mut self,
        scope: ScopeId,
        shape: &Shape,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let wanted = |index| if index == 0 { Dimension::MASS } else { Dimension::LENGTH };
        let found = arguments.iter().enumerate();
        let found = all(
            found.map(|(index, argument)| self.eval_quantity(scope, argument, wanted(index), Reads::ALL))
        )?;
        let reads = found.iter().fold(Reads::NOTHING, |reads, (_, nature)| reads.and(nature.reads));
        let (mass, lengths) = (found[0].0, &found[1..]);
        let squares: Expr = lengths.iter().map(|(length, _)| length.squared()).sum();
        let factor = Expr::from(shape.numerator) / Expr::from(shape.denominator);
        let inertia = factor * mass * squares;
        Ok(Value::Scalar(inertia, Nature::derived(Dimension::INERTIA, reads)))
    }
}
