//! Requirements: what must hold for the model to mean anything.
//!
//! A requirement is a condition with a held side. The run ends where that side would change. One of parameters alone is a limit, which
//! is looked at when they change.

use plm_cas::{Expr, algebra};

use crate::collect::PushAll;
use crate::diag::Code;
use crate::model::{Limit, Param, Range, Switch};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::condition::side_text;
use crate::resolve::values::{Condition, Eval, Failed, Reads};
use crate::sorted::SortedSet;
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind, Field, Operator};

/// A requirement that was declared.
pub(crate) struct Requirement<'a> {
    scope: ScopeId,
    condition: &'a ast::Expr,
    /// Full name, `cylinder.cap.above_vacuum`.
    name: String,
    span: Span,
    /// The use of the part does without it.
    is_off: bool,
}

/// A requirement that the use of a part switches on or off.
pub(crate) struct Switched {
    /// The scope of the use.
    scope: ScopeId,
    /// Full name of the requirement.
    name: String,
    span: Span,
}

impl<'a> Resolver<'a> {
    /// `require name: condition;`
    pub(crate) fn declare_requirement(
        &mut self,
        scope: ScopeId,
        name: &'a ast::IndexedName,
        condition: &'a ast::Expr,
    ) {
        if self.needs_index(scope, name) {
            return;
        }
        let Ok(key) = self.key(scope, name) else { return };
        let (full, span) = (format!("{}{key}", self.names.prefix(scope)), name.ident.span);
        if let Some(first) = self.unresolved.requirements.iter().find(|known| known.name == full) {
            let first = first.span;
            self.duplicate(scope, &key, span, first);
            return;
        }
        let set = self.names.instance(scope).and_then(|instance| self.names.field(instance, &key));
        let is_off = set.is_some_and(|(_, field)| word(field) == Some("off"));
        self.unresolved.requirements.push(Requirement { scope, condition, name: full, span, is_off });
    }

    /// `above_vacuum: off;` in the use of a part; `name` is the full name of the requirement.
    pub(crate) fn switch_requirement(&mut self, scope: ScopeId, name: String, field: &'a Field) {
        if !matches!(word(field), Some("on" | "off")) {
            let message = "a requirement is switched `on` or `off`";
            self.error(scope, Code::UnknownOption, field.value.span, message);
        }
        self.unresolved.switched.push(Switched { scope, name, span: field.span() });
    }

    /// With its indices a requirement must exist, which is known when all are declared.
    fn check_switched(&mut self) {
        for Switched { scope, name, span } in std::mem::take(&mut self.unresolved.switched) {
            if !self.unresolved.requirements.iter().any(|known| known.name == name) {
                self.error(scope, Code::BadIndex, span, format!("there is no requirement `{name}`"));
            }
        }
    }

    /// Requirements as switches that must not change; those of parameters become limits.
    pub(crate) fn evaluate_requirements(&mut self) -> Vec<(Switch, Span)> {
        self.check_switched();
        let mut switches = Vec::new();
        for Requirement { scope, condition, name, span, is_off } in
            std::mem::take(&mut self.unresolved.requirements)
        {
            if is_off {
                // Its mistakes are told all the same, and what it reads is not for nobody.
                let _ = self.condition(scope, condition);
                continue;
            }
            // A mistake has been reported; what else is wrong is found all the same.
            let Ok((differences, reads)) = self.requirement(scope, condition, &name) else { continue };
            if reads.beyond(Reads::FIXED) == Reads::NOTHING {
                let limits = differences.into_iter().map(|value| margin(name.clone(), value, span));
                self.unresolved.limits.push_all(limits);
                continue;
            }
            for difference in differences {
                let symbol = Expr::symbol(format!("switch_{}", switches.len()));
                let switch = Switch {
                    symbol,
                    difference,
                    beyond: None,
                    instant: None,
                    name: name.clone(),
                    text: String::new(),
                    end: None,
                    must_hold: true,
                };
                switches.push((switch, span));
            }
        }
        switches
    }

    /// The requirements that a run may break. What reads sums at nodes may read nothing that changes, when these are known.
    pub(crate) fn changing(&mut self, switches: Vec<(Switch, Span)>, params: &[Param]) -> Vec<Switch> {
        let params: SortedSet<Expr> = params.iter().map(|param| param.symbol).collect();
        let is_fixed = |switch: &Switch| {
            algebra::symbols(&[switch.difference]).iter().all(|symbol| params.contains(symbol))
        };
        let mut changing: Vec<Switch> = Vec::new();
        for (switch, span) in switches {
            if is_fixed(&switch) {
                self.unresolved.limits.push(margin(switch.name, switch.difference, span));
            } else {
                let symbol = Expr::symbol(format!("switch_{}", changing.len()));
                changing.push(Switch { symbol, ..switch });
            }
        }
        changing
    }

    /// Expressions that are positive as long as a condition holds, and what they read.
    fn requirement(&mut self, scope: ScopeId, expr: &'a ast::Expr, name: &str) -> Eval<(Vec<Expr>, Reads)> {
        let (condition, reads) = self.condition(scope, expr)?;
        let beyond = reads.beyond(Reads::KNOWN);
        if beyond != Reads::NOTHING {
            let message = format!("a requirement reads {}", beyond.describe());
            self.error(scope, Code::NotConstant, expr.span, message)
                .note(format!("it may read {}", Reads::KNOWN.describe()));
            return Err(Failed);
        }
        let mut differences = Vec::new();
        if positive(&condition, &mut differences) {
            return Ok((differences, reads));
        }
        if condition.known().is_some() {
            return Err(self.never_holds(scope, expr, name));
        }
        let message = "a requirement is a comparison, or several with `and`";
        self.error(scope, Code::WrongKind, expr.span, message);
        Err(Failed)
    }

    /// A requirement that is known to fail: told where the use of the part sets what it compares, else where it stands.
    fn never_holds(&mut self, scope: ScopeId, expr: &'a ast::Expr, name: &str) -> Failed {
        let failing = self.failing(scope, expr);
        let (sides, text) = match &failing.kind {
            ExprKind::Chain(first, links) => {
                let sides = [&**first, &links[0].operand];
                let texts = sides.map(side_text);
                let operator = links[0].operator.text();
                let text = if let [Some(left), Some(right)] = texts {
                    Some(format!("`{left} {operator} {right}`"))
                } else {
                    None
                };
                (sides.to_vec(), text)
            }
            _ => (Vec::new(), None),
        };
        let instance = self.names.instance(scope);
        let set = sides.into_iter().find_map(|side| match &side.kind {
            ExprKind::Name(name) if name.indices.is_empty() => self.names.field(instance?, &name.ident.text),
            _ => None,
        });
        if let Some((outer, field)) = set {
            let text = text.unwrap_or_else(|| "another value".to_owned());
            let message = format!("`{name}` requires {text}");
            self.error(outer, Code::WrongKind, field.value.span, message)
                .note_at(failing.span, "the requirement stands here");
        } else {
            let message = format!("the requirement `{name}` never holds");
            self.error(scope, Code::WrongKind, failing.span, message);
        }
        Failed
    }

    /// The first part of a condition with `and` that is known to fail.
    fn failing(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> &'a ast::Expr {
        let ExprKind::Chain(first, links) = &expr.kind else { return expr };
        if links[0].operator != Operator::And {
            return expr;
        }
        let mut parts = std::iter::once(&**first).chain(links.iter().map(|link| &link.operand));
        let fails = |part: &&'a ast::Expr| {
            self.condition(scope, part).is_ok_and(|(condition, _)| condition.known() == Some(false))
        };
        parts.find(fails).unwrap_or(expr)
    }
}

/// The limit that the margin of a requirement is where it reads parameters alone.
fn margin(part: String, value: Expr, span: Span) -> Limit {
    let (what, unit) = ("requirement".to_owned(), String::new());
    Limit { part, what, value, unit, range: Range::Required, code: Code::WrongKind, span }
}

/// The word that a field is set to.
fn word(field: &Field) -> Option<&str> {
    match &field.value.kind {
        ExprKind::Name(name) if name.indices.is_empty() => Some(&name.ident.text),
        _ => None,
    }
}

/// Adds what is positive where a condition holds; false if that cannot be said, or never holds.
fn positive(condition: &Condition, differences: &mut Vec<Expr>) -> bool {
    if let Some(holds) = condition.known() {
        return holds;
    }
    match condition {
        Condition::Less(low, high) => {
            differences.push(*high - *low);
            true
        }
        Condition::Not(inner) => match &**inner {
            Condition::Less(low, high) => {
                differences.push(*low - *high);
                true
            }
            _ => false,
        },
        Condition::All(inner) => inner.iter().all(|one| positive(one, differences)),
        Condition::Known(_) | Condition::Any(_) => false,
    }
}
