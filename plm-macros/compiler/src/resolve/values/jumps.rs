//! Functions that jump wherever a number passes an integer: `floor` and `mod`.
//!
//! Within a step `floor` keeps the parity of the integer that it had at the beginning, and is constant for half a unit beyond either
//! jump. So a step is smooth across the jump, and the condition that locates it is the sign of `sin(pi x)`, which is negative where
//! the integer is odd.

use plm_cas::{Expr, Number, algebra};

use crate::model::Comparison;
use crate::resolve::Resolver;
use crate::resolve::declarations::state::StateKind;
use crate::resolve::names::ScopeId;
use crate::resolve::values::expect::text_of;
use crate::resolve::values::{Eval, Nature, Quantity, Reads, Scalar, Value};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A number counts as the integer that it is below by less than this part of its size: rounding of `sin(pi x)` is smaller.
const ROUNDING: f64 = 1.0 / (1_u64 << 49) as f64;

impl<'a> Resolver<'a> {
    /// `floor(x)` of a number.
    pub(crate) fn floor(&mut self, scope: ScopeId, argument: &'a ast::Expr) -> Eval<Value> {
        let x = self.eval_quantity(scope, argument, Dimension::NUMBER, Reads::ALL)?;
        let text = text_of(argument).unwrap_or_else(|| x.value.to_string());
        let value = self.stepped(x, &text);
        Ok(Quantity::new(value, x.nature).into())
    }

    /// `mod(x, period)`: what is left of x after the last whole multiple of the period below it.
    pub(crate) fn remainder(
        &mut self,
        scope: ScopeId,
        span: Span,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let (x, nature) = self.alike(scope, span, arguments)?;
        let number = Quantity::new(x[0] / x[1], Nature::derived(Dimension::NUMBER, nature.reads));
        let text = match (text_of(&arguments[0]), text_of(&arguments[1])) {
            (Some(of), Some(by)) => format!("{of}/{by}"),
            _ => number.value.to_string(),
        };
        let whole = self.stepped(number, &text);
        Ok(Quantity::new(x[0] - x[1] * whole, nature).into())
    }

    /// The largest integer that is not above x, as a choice by the parity that is held over a step where x moves.
    fn stepped(&mut self, x: Scalar, text: &str) -> Expr {
        if !self.moves(x) {
            return x.value.floor();
        }
        let (x, half) = (x.value, Expr::ONE / Expr::from(2));
        let quarter = half * half;
        let even = Expr::from(2) * (half * x + quarter).floor();
        let odd = Expr::from(2) * (half * x - quarter).floor() + Expr::ONE;
        let slack = Expr::from(Number::from_f64(ROUNDING)) * (x * x + Expr::ONE).sqrt();
        let parity = (Expr::from(Number::pi()) * (x + slack)).sin();
        self.unresolved
            .comparisons
            .push(Comparison { of: [parity, Expr::ZERO], text: format!("floor({text})") });
        parity.less(Expr::ZERO).select(odd, even)
    }

    /// Does it change between events?
    fn moves(&self, x: Scalar) -> bool {
        if x.nature.reads.beyond(Reads::PARAM.and(Reads::INPUT).and(Reads::STATE)) != Reads::NOTHING {
            return true;
        }
        let is_fixed = |symbol: Expr| {
            let fields = || self.unresolved.params.iter().chain(&self.unresolved.inputs);
            match self.state_of(symbol) {
                Some(state) => self.unresolved.states[state].kind == StateKind::Discrete,
                None => fields().any(|field| field.symbol == symbol),
            }
        };
        !algebra::symbols(&[x.value]).into_iter().all(is_fixed)
    }
}
