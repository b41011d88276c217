//! Events that give states other values.

use plm_cas::Expr;

use crate::diag::Code;
use crate::model::{Target, When};
use crate::resolve::Resolver;
use crate::resolve::declarations::state::StateKind;
use crate::resolve::names::ScopeId;
use crate::resolve::values::condition::side_text;
use crate::resolve::values::{Condition, Eval, Failed, Reads};
use crate::syntax::ast::{self, Moment};
use crate::units::Dimension;

impl<'a> Resolver<'a> {
    /// All events of the declaration; those that happen as a run begins stand last.
    pub(crate) fn evaluate_whens(&mut self) -> Vec<When> {
        let mut whens = Vec::new();
        for (scope, ast) in std::mem::take(&mut self.unresolved.whens) {
            // A mistake has been reported; what else is wrong is found all the same.
            if let Ok(when) = self.when(scope, ast) {
                whens.push(when);
            }
        }
        self.check_discrete(&whens);
        whens.sort_by_key(|when| when.condition.is_none());
        whens
    }

    fn when(&mut self, scope: ScopeId, ast: &'a ast::When) -> Eval<When> {
        let forces = Reads::REACTION.and(Reads::PUSH).and(Reads::FRICTION);
        let allowed = Reads::EVENT.and(Reads::ACCELERATION).and(forces);
        let condition = match &ast.moment {
            Moment::Start(_) => Ok(None),
            Moment::BecomesTrue(condition) => {
                self.event_condition(scope, condition, ("an event", allowed)).map(Some)
            }
        };
        let mut set = Vec::new();
        let mut failed = false;
        for assignment in &ast.assignments {
            match self.assignment(scope, assignment) {
                Ok((target, _)) if set.iter().any(|(known, _)| *known == target) => {
                    let span = assignment.target.span;
                    self.error(scope, Code::RepeatedItem, span, "one event sets this twice");
                }
                Ok(found) => set.push(found),
                Err(Failed) => failed = true,
            }
        }
        let condition = condition?;
        if failed {
            return Err(Failed);
        }
        let (text, span) = match &ast.moment {
            Moment::Start(span) => ("start".to_owned(), *span),
            Moment::BecomesTrue(condition) => (self.condition_text(condition), condition.span),
        };
        Ok(When { text, condition, set, span })
    }

    /// 1 where a condition of an event or of a row of contact holds, else 0.
    pub(crate) fn event_condition(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        reading: (&str, Reads),
    ) -> Eval<Expr> {
        let condition = self.condition_within(scope, expr, reading)?;
        if let Some(holds) = condition.known() {
            let always = if holds { "always" } else { "never" };
            self.error(scope, Code::WrongKind, expr.span, format!("this condition {always} holds"));
            return Err(Failed);
        }
        Ok(condition.select(Expr::ONE, Expr::ZERO))
    }

    /// 1 where a row of contact exists and 0 elsewhere. In a part this may be known: `None` of a row that always exists, and 0 of one that
    /// never does.
    pub(crate) fn existence(&mut self, scope: ScopeId, when: &'a ast::Expr) -> Eval<Option<Expr>> {
        let reading = ("a row of contact", Reads::EVENT);
        if self.names.instance(scope).is_none() {
            return self.event_condition(scope, when, reading).map(Some);
        }
        let condition = self.condition_within(scope, when, reading)?;
        Ok((condition.known() != Some(true)).then(|| condition.select(Expr::ONE, Expr::ZERO)))
    }

    /// A condition that reads no more than is allowed.
    fn condition_within(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        (of, allowed): (&str, Reads),
    ) -> Eval<Condition> {
        let (condition, reads) = self.condition(scope, expr)?;
        let beyond = reads.beyond(allowed);
        if beyond != Reads::NOTHING {
            let message = format!("the condition of {of} reads {}", beyond.describe());
            self.error(scope, Code::NotConstant, expr.span, message)
                .note(format!("it may read {}", allowed.describe()));
            return Err(Failed);
        }
        Ok(condition)
    }

    /// A condition as it was written, where that is short.
    fn condition_text(&self, expr: &ast::Expr) -> String {
        let known = self.unresolved.comparisons.last().map(|last| last.text.clone());
        side_text(expr).or(known).unwrap_or_default()
    }

    /// A target, and its value.
    fn assignment(
        &mut self,
        scope: ScopeId,
        ast::Assignment { target, value }: &'a ast::Assignment,
    ) -> Eval<(Target, Expr)> {
        let place = self.target(scope, target);
        let dimension = place.as_ref().map_or(Dimension::NUMBER, |(_, dimension)| *dimension);
        let (place, _) = place?;
        Ok((place, self.eval_number(scope, value, dimension, Reads::EVENT)?))
    }

    /// A state, or a velocity of a body.
    fn target(&mut self, scope: ScopeId, expr: &'a ast::Expr) -> Eval<(Target, Dimension)> {
        let named = self.eval_scalar(scope, expr)?;
        let found = self.state_of(named.value).map(Target::State).or_else(|| self.velocity_of(named.value));
        if let Some(found) = found {
            return Ok((found, named.nature.dimension));
        }
        let reads = named.nature.reads;
        let help = if reads.beyond(Reads::KNOWN) != Reads::NOTHING {
            "it follows from forces; what can be set is a velocity"
        } else if reads.has(Reads::VELOCITY) {
            "of a body whose origin is not its centre of gravity `omega` can be set"
        } else if reads.has(Reads::POSITION) {
            "joints would open; what can be set is a velocity"
        } else {
            "declare it as `discrete name: unit = value;`"
        };
        let message = match side_text(expr) {
            Some(text) => format!("an event cannot set `{text}`"),
            None => "an event cannot set this".to_owned(),
        };
        self.error(scope, Code::WrongKind, expr.span, message)
            .note("it sets states, discrete ones, and `vx`, `vy` and `omega` of bodies")
            .help(help);
        Err(Failed)
    }

    fn velocity_of(&self, symbol: Expr) -> Option<Target> {
        let mut velocities = self.unresolved.bodies.iter().flat_map(|body| body.v);
        velocities.position(|known| known == symbol).map(Target::Velocity)
    }

    /// Discrete states must be set by some event.
    fn check_discrete(&mut self, whens: &[When]) {
        if self.sink.has_errors() {
            return;
        }
        for state in 0..self.unresolved.states.len() {
            let declared = &self.unresolved.states[state];
            let is_set =
                || whens.iter().any(|when| when.set.iter().any(|(of, _)| *of == Target::State(state)));
            if declared.kind != StateKind::Discrete || is_set() {
                continue;
            }
            let (scope, name) = (declared.scope, declared.name.clone());
            let text = name.text.rsplit('.').next().unwrap_or_default().to_owned();
            self.error(scope, Code::StateRate, name.span, format!("no event sets `{}`", name.text))
                .help(format!("write `when … {{ {text} = …; }}`; a number that never changes is a `param`"));
        }
    }
}
