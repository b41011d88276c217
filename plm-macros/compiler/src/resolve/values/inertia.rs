//! Moments of inertia of common shapes about the axis through G normal to the plane: the manual's appendix 1.

use plm_cas::Expr;

use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Nature, Quantity, Reads, Value, all};
use crate::syntax::ast;
use crate::units::Dimension;

impl<'a> Resolver<'a> {
    /// `numerator/denominator mass (a^2 + b^2 + …)`, from the mass and the lengths.
    pub(crate) fn moment_of_inertia(
        &mut self,
        scope: ScopeId,
        [numerator, denominator]: [i32; 2],
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let wanted = |index| if index == 0 { Dimension::MASS } else { Dimension::LENGTH };
        let found = arguments.iter().enumerate();
        let found = all(
            found.map(|(index, argument)| self.eval_quantity(scope, argument, wanted(index), Reads::ALL))
        )?;
        let reads = found.iter().fold(Reads::NOTHING, |reads, of| reads.and(of.nature.reads));
        let (mass, lengths) = (found[0].value, &found[1..]);
        let squares: Expr = lengths.iter().map(|length| length.value.squared()).sum();
        let inertia = Expr::from(numerator) / Expr::from(denominator) * mass * squares;
        Ok(Quantity::new(inertia, Nature::derived(Dimension::INERTIA, reads)).into())
    }
}
