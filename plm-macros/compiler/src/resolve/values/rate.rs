//! Rates: total derivatives with respect to time.

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::syntax::ast;
use crate::units::Dimension;

impl<'a> Resolver<'a> {
    /// `rate(expr)`
    pub(crate) fn rate_of(&mut self, scope: ScopeId, argument: &'a ast::Expr) -> Eval<Value> {
        Ok(match self.eval(scope, argument)? {
            Value::Scalar(x) => {
                let nature = self.nature_of_rate(scope, argument, x.nature)?;
                Quantity::new(self.calculus.total_derivative(x.value), nature).into()
            }
            Value::Vector(v) => {
                let nature = self.nature_of_rate(scope, argument, v.nature)?;
                Quantity::new(v.value.map(|x| self.calculus.total_derivative(x)), nature).into()
            }
            other => return Err(self.wrong_kind(scope, argument, "a number or a vector", &other)),
        })
    }

    fn nature_of_rate(&mut self, scope: ScopeId, argument: &ast::Expr, nature: Nature) -> Eval<Nature> {
        let contact = Reads::PUSH.and(Reads::FRICTION);
        let unknown = Reads::INPUT.and(Reads::ACCELERATION).and(Reads::REACTION).and(contact);
        let mut reads = nature.reads;
        if reads.has(unknown) {
            let of = reads.beyond(reads.beyond(unknown)).describe();
            self.error(scope, Code::NoRate, argument.span, format!("the rate of {of} is not known"))
                .note("inputs are held over a step; a `state` has a rate");
            return Err(Failed);
        }
        if nature.reads.has(Reads::POSITION) {
            reads = reads.and(Reads::VELOCITY);
        }
        if nature.reads.has(Reads::VELOCITY) {
            reads = reads.and(Reads::ACCELERATION);
        }
        if nature.reads.has(Reads::STATE) {
            // The rate of a state may read anything, what is not known before the motion is solved too.
            reads = reads.and(Reads::ACTING);
        }
        Ok(Nature::derived(nature.dimension.over(Dimension::TIME), reads))
    }
}
