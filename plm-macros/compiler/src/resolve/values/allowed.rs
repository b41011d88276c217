//! Expressions that read more than they may where they stand.

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Reads};
use crate::syntax::ast;

impl<'a> Resolver<'a> {
    /// Checks that an expression reads no more than it may.
    pub(super) fn reads_only(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        reads: Reads,
        allowed: Reads,
    ) -> Eval<()> {
        let beyond = reads.beyond(allowed);
        if beyond == Reads::NOTHING {
            return Ok(());
        }
        if allowed == Reads::ACTING {
            return Err(self.acts_by_contact(scope, expr, beyond));
        }
        let message = format!("this reads {}", beyond.describe());
        let diagnostic = self
            .error(scope, Code::NotConstant, expr.span, message)
            .note(format!("what stands here may read {}", allowed.describe()));
        if let Some([why, instead]) = beyond.no_place().filter(|_| allowed == Reads::SCHEDULED) {
            diagnostic.note(why).help(instead);
        }
        Err(Failed)
    }

    /// A force or a rate reads what a contact does.
    fn acts_by_contact(&mut self, scope: ScopeId, expr: &'a ast::Expr, beyond: Reads) -> Failed {
        let (scope, span) = self.culprit(scope, expr, beyond);
        let what = if beyond.has(Reads::PUSH) { "the push of a contact" } else { "a friction" };
        let message = format!("a force or a rate reads {what}, which is not known before they are");
        self.error(scope, Code::Feedback, span, message)
            .note("outputs read it, and bounds of frictions read pushes")
            .help("a friction is a row of its own: `friction name: rate(…) within mu*reaction(row);`");
        Failed
    }
}
