//! Conditions and what hangs on them.

use crate::collect::CollectVec;
use plm_cas::Expr;

use crate::diag::{Code, help_similar};
use crate::model::Comparison;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::expect::text_of;
use crate::resolve::values::{Additive, Condition, Eval, Failed, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, Link, Operator};

impl<'a> Resolver<'a> {
    /// `a and b and c`, `a or b`
    pub(crate) fn logic(
        &mut self,
        scope: ScopeId,
        first: &'a ast::Expr,
        links: &'a [Link],
        operator: Operator,
    ) -> Eval<Value> {
        let (condition, mut reads) = self.condition(scope, first)?;
        let mut conditions = vec![condition];
        for link in links {
            let (condition, also) = self.condition(scope, &link.operand)?;
            conditions.push(condition);
            reads = reads.and(also);
        }
        let condition =
            if operator == Operator::And { Condition::All(conditions) } else { Condition::Any(conditions) };
        Ok(Value::Condition(condition, reads))
    }

    /// `a < b` and its kin; `choice == option`.
    pub(crate) fn comparison(
        &mut self,
        scope: ScopeId,
        first: &'a ast::Expr,
        links: &'a [Link],
    ) -> Eval<Value> {
        let Some(Link { operator, operand }) = links.first() else { return Err(Failed) };
        let span = first.span.to(operand.span);
        if matches!(operator, Operator::Equal | Operator::NotEqual) {
            return self.equality(scope, span, first, operand, *operator);
        }
        let (a, b) = (self.eval_scalar(scope, first)?, self.eval_scalar(scope, operand)?);
        let nature = self.joined(scope, span, a, b)?;
        let (a, b) = (a.value, b.value);
        self.note_comparison(first, *operator, operand, (a, b));
        let condition = match operator {
            Operator::Less => Condition::less(a, b),
            Operator::Greater => Condition::less(b, a),
            Operator::LessEqual => Condition::Not(Box::new(Condition::less(b, a))),
            _ => Condition::Not(Box::new(Condition::less(a, b))),
        };
        Ok(Value::Condition(condition, nature.reads))
    }

    /// Keeps how a comparison was written, for faults that name it.
    fn note_comparison(
        &mut self,
        first: &ast::Expr,
        operator: Operator,
        second: &ast::Expr,
        of: (Expr, Expr),
    ) {
        let [Some(first), Some(second)] = [first, second].map(side_text) else { return };
        let text = format!("{first} {} {second}", operator.text());
        self.unresolved.comparisons.push(Comparison { of: [of.0, of.1], text });
    }

    /// Equality is for choices; that of two computed numbers is an accident.
    fn equality(
        &mut self,
        scope: ScopeId,
        span: Span,
        left: &'a ast::Expr,
        right: &'a ast::Expr,
        operator: Operator,
    ) -> Eval<Value> {
        let left = self.eval(scope, left)?;
        let (Value::Choice(choice), ExprKind::Name(option)) = (left, &right.kind) else {
            self.error(
                scope,
                Code::WrongKind,
                span,
                "`==` and `!=` compare a choice with one of its options",
            )
            .help("numbers are compared with `<`, `<=`, `>` and `>=`");
            return Err(Failed);
        };
        let (chosen, options) = self.names.choices[choice].clone();
        let text = option.ident.text.as_str();
        if !options.contains(&text) {
            self.unknown_option(scope, text, option.ident.span, &options);
            return Err(Failed);
        }
        let equal = chosen == text;
        let holds = if operator == Operator::Equal { equal } else { !equal };
        Ok(Value::Condition(Condition::Known(holds), Reads::NOTHING))
    }

    pub(crate) fn unknown_option(&mut self, scope: ScopeId, option: &str, span: Span, options: &[&str]) {
        let diagnostic = self.error(scope, Code::UnknownOption, span, format!("unknown option `{option}`"));
        help_similar(diagnostic, option, "option", "options", options);
    }

    /// `if condition then yes else no`. If the condition is known, the other branch is not even looked at: it may have
    /// no meaning there.
    pub(crate) fn choose(
        &mut self,
        scope: ScopeId,
        span: Span,
        condition: &'a ast::Expr,
        yes: &'a ast::Expr,
        no: &'a ast::Expr,
    ) -> Eval<Value> {
        let (condition, reads) = self.condition(scope, condition)?;
        if let Some(holds) = condition.known() {
            return self.eval(scope, if holds { yes } else { no });
        }
        let (on_yes, on_no) = (self.eval(scope, yes), self.eval(scope, no));
        match (on_yes?, on_no?) {
            (Value::Scalar(yes), Value::Scalar(no)) => {
                let nature = self.joined(scope, span, yes, no)?;
                Ok(selected(&condition, reads, nature, [yes.value, no.value]).into())
            }
            (Value::Vector(yes), Value::Vector(no)) => {
                let nature = self.joined(scope, span, yes, no)?;
                Ok(selected(&condition, reads, nature, [yes.value, no.value]).into())
            }
            (a, b) => {
                let message = format!("one branch is {}, the other {}", a.kind(), b.kind());
                self.error(scope, Code::WrongKind, span, message);
                Err(Failed)
            }
        }
    }
}

/// One side of a comparison as it was written, where that is short.
pub(crate) fn side_text(expr: &ast::Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Path(first, members) if members.iter().all(|member| member.indices.is_empty()) => {
            let members = members.iter().map(|member| format!(".{}", member.ident.text));
            Some(text_of(first)? + &members.collect::<String>())
        }
        _ => text_of(expr),
    }
}

/// One of two values by a condition, which has been read too.
fn selected<T: Additive>(
    condition: &Condition,
    reads: Reads,
    nature: Nature,
    [yes, no]: [T; 2],
) -> Quantity<T> {
    let value = T::select(condition, yes, no);
    Quantity::new(value, Nature::derived(nature.dimension, nature.reads.and(reads)))
}

impl Condition {
    /// `low < high`
    fn less(low: Expr, high: Expr) -> Condition {
        match (low.as_number(), high.as_number()) {
            (Some(low), Some(high)) => Condition::Known(low.to_f64() < high.to_f64()),
            _ => Condition::Less(low, high),
        }
    }

    /// Its truth, if that is known at compile time.
    pub(crate) fn known(&self) -> Option<bool> {
        match self {
            Condition::Known(holds) => Some(*holds),
            Condition::Less(..) => None,
            Condition::Not(inner) => inner.known().map(|holds| !holds),
            Condition::All(inner) => decided(inner, false),
            Condition::Any(inner) => decided(inner, true),
        }
    }

    /// Selections that give `yes` where it holds, else `no`.
    pub(crate) fn select(&self, yes: Expr, no: Expr) -> Expr {
        match self {
            Condition::Known(true) => yes,
            Condition::Known(false) => no,
            Condition::Less(low, high) => low.less(*high).select(yes, no),
            Condition::Not(inner) => inner.select(no, yes),
            Condition::All(inner) => inner.iter().rev().fold(yes, |yes, one| one.select(yes, no)),
            Condition::Any(inner) => inner.iter().rev().fold(no, |no, one| one.select(yes, no)),
        }
    }
}

/// A single condition that is `decisive` decides; else all must be known.
fn decided(conditions: &[Condition], decisive: bool) -> Option<bool> {
    let each: Vec<Option<bool>> = conditions.iter().map(Condition::known).collect_vec();
    if each.contains(&Some(decisive)) {
        return Some(decisive);
    }
    (!each.contains(&None)).then_some(!decisive)
}
