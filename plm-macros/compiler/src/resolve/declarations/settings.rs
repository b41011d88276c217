//! Settings of the whole mechanism: gravity, the formulation, how constraints are kept, the law of impact, which warnings are
//! allowed.

use crate::collect::MapEach;
use crate::sorted::SortedMap;

use plm_cas::algebra::Vec2;
use plm_cas::{Expr, Number};

use crate::diag::Code;
use crate::model::{Formulation, Impacts, Repetitions, Stabilisation, Step};
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, SlotId, Thunk};
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Value};
use crate::span::Span;
use crate::syntax::ast::{self, Ident, Item};
use crate::units::Dimension;

/// Settings that have been declared so far.
#[derive(Default)]
pub(crate) struct Settings<'a> {
    gravity: Option<SlotId>,
    /// The method and its time constant.
    stabilisation: Option<(&'a Ident, Option<&'a ast::Expr>)>,
    pub(crate) formulation: Option<(Formulation, Span)>,
    pub(crate) repetitions: Option<(Repetitions, Span)>,
    /// The law of impact.
    pub(crate) impacts: Option<(Impacts, Span)>,
    /// Steps that the code is to hold, and where they are asked for.
    pub(crate) steps: SortedMap<Step, Span>,
    /// Codes of warnings.
    pub(crate) allowed: Vec<String>,
}

impl<'a> Resolver<'a> {
    /// `gravity: 9.81 m/s^2;`
    pub(crate) fn declare_gravity(&mut self, scope: ScopeId, item: &'a Item, expr: &'a ast::Expr) {
        if let Some(first) = self.unresolved.settings.gravity {
            let first = self.names.slots[first].span;
            self.said_twice(scope, item.span, "gravity", first);
            return;
        }
        let reads = Reads::SCHEDULED.and(Reads::INPUT);
        let wanted = Wanted::NumberOrVector(Dimension::ACCELERATION, reads);
        let slot = self.names.waiting_slot(item.span, Thunk { scope, expr, wanted });
        self.unresolved.settings.gravity = Some(slot);
        self.names.checks.push(slot);
    }

    /// `stabilisation: baumgarte(0.1 s);`
    pub(crate) fn declare_stabilisation(
        &mut self,
        scope: ScopeId,
        method: &'a Ident,
        time: Option<&'a ast::Expr>,
    ) {
        if let Some((first, _)) = self.unresolved.settings.stabilisation {
            self.said_twice(scope, method.span, "the stabilisation", first.span);
        } else if method.text == "projection" || method.text == "baumgarte" {
            self.unresolved.settings.stabilisation = Some((method, time));
        } else {
            self.unknown_option(scope, &method.text, method.span, &["projection", "baumgarte"]);
        }
    }

    /// `formulation: tree;`
    pub(crate) fn declare_formulation(&mut self, scope: ScopeId, formulation: &'a Ident) {
        if let Some((_, first)) = self.unresolved.settings.formulation {
            self.said_twice(scope, formulation.span, "the formulation", first);
        } else if let Some(known) = Formulation::named(&formulation.text) {
            self.unresolved.settings.formulation = Some((known, formulation.span));
        } else {
            self.unknown_option(
                scope,
                &formulation.text,
                formulation.span,
                &Formulation::NAMES.map_each(|(name, _)| name),
            );
        }
    }

    /// `code: rolled;`
    pub(crate) fn declare_code(&mut self, scope: ScopeId, repetitions: &'a Ident) {
        if let Some((_, first)) = self.unresolved.settings.repetitions {
            self.said_twice(scope, repetitions.span, "the code", first);
        } else if let Some(known) = Repetitions::named(&repetitions.text) {
            self.unresolved.settings.repetitions = Some((known, repetitions.span));
        } else {
            let known = Repetitions::NAMES.map_each(|(name, _)| name);
            self.unknown_option(scope, &repetitions.text, repetitions.span, &known);
        }
    }

    /// `impacts: newton;`
    pub(crate) fn declare_impacts(&mut self, scope: ScopeId, law: &'a Ident) {
        if let Some((_, first)) = self.unresolved.settings.impacts {
            self.said_twice(scope, law.span, "the law of impact", first);
        } else if let Some(known) = Impacts::named(&law.text) {
            self.unresolved.settings.impacts = Some((known, law.span));
        } else {
            self.unknown_option(scope, &law.text, law.span, &Impacts::NAMES.map_each(|(name, _)| name));
        }
    }

    /// `emit: step(rk4);`
    pub(crate) fn declare_steps(&mut self, scope: ScopeId, methods: &'a [Ident]) {
        for method in methods {
            let Some(step) = Step::named(&method.text) else {
                let known = Step::NAMES.map_each(|(name, _)| name);
                self.unknown_option(scope, &method.text, method.span, &known);
                continue;
            };
            if let Some(first) = self.unresolved.settings.steps.insert(step, method.span) {
                self.said_twice(scope, method.span, &format!("a step of `{}`", method.text), first);
            }
        }
    }

    /// `allow: W0002;`
    pub(crate) fn declare_allowed(&mut self, codes: &'a [Ident]) {
        for code in codes {
            if Code::ALL.iter().any(|known| known.id() == code.text && known.id().starts_with('W')) {
                self.unresolved.settings.allowed.push(code.text.clone());
            } else {
                let message = format!("there is no warning `{}` to allow", code.text);
                self.sink.warning(Code::UnknownCode, code.span, message);
            }
        }
    }

    fn said_twice(&mut self, scope: ScopeId, span: Span, what: &str, first: Span) {
        self.error(scope, Code::RepeatedItem, span, format!("{what} is declared twice"))
            .note_at(first, "it is declared first here");
    }

    /// Gravity as it was written; zero if it was not.
    pub(crate) fn gravity(&mut self, scope: ScopeId, span: Span) -> Eval<Value> {
        if let Some(slot) = self.unresolved.settings.gravity {
            return self.slot_value(slot, scope, span);
        }
        let nature = Nature::written(Dimension::ACCELERATION, Reads::NOTHING);
        Ok(Quantity::new(Expr::ZERO, nature).into())
    }

    /// The acceleration of gravity in absolute axes. Where a number was written, it points along -y.
    pub(crate) fn evaluate_gravity(&mut self) -> Eval<Vec2> {
        let Some(slot) = self.unresolved.settings.gravity else { return Ok(Vec2::ZERO) };
        let span = self.names.slots[slot].span;
        match self.slot_value(slot, 0, span)? {
            Value::Scalar(down) => Ok(Vec2::new(Expr::ZERO, -down.value)),
            Value::Vector(gravity) => Ok(gravity.value),
            _ => Err(Failed),
        }
    }

    /// How constraints are kept over a run.
    pub(crate) fn evaluate_stabilisation(&mut self) -> Eval<Stabilisation> {
        let Some((method, time)) = self.unresolved.settings.stabilisation else {
            return Ok(Stabilisation::Projection);
        };
        match time {
            None if method.text == "projection" => Ok(Stabilisation::Projection),
            // The time constant that the manual's own integrator was found to need (issue 2, point 5).
            None => {
                let tenth = Number::rational(1, 10).ok_or(Failed)?;
                Ok(Stabilisation::Baumgarte(Expr::from(tenth)))
            }
            Some(time) if method.text == "projection" => {
                self.error(0, Code::UnexpectedToken, time.span, "projection has no time constant");
                Err(Failed)
            }
            Some(time) => {
                self.eval_number(0, time, Dimension::TIME, Reads::FIXED).map(Stabilisation::Baumgarte)
            }
        }
    }
}
