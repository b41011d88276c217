//! Constraints that hold while a condition does: rows of contact with a force of either sign.
//!
//! A joint that may open is no pair that coordinates could follow: its bodies move by themselves, and it holds them by forces.

use plm_cas::{Expr, algebra};

use crate::collect::{CollectVec, MapEach};
use crate::diag::Code;
use crate::model::{Contact, ContactLaw, Load, Output, Row, State, When};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Reads};
use crate::syntax::ast;

/// The field of a joint that says while what it holds.
pub(crate) const WHEN: &str = "when";

impl<'a> Resolver<'a> {
    /// Makes rows of contact of the constraints that have a condition; the others are left. Springs, dampers, limits and friction of a
    /// joint act while it holds.
    pub(crate) fn apply_conditions(
        &mut self,
        rows: Vec<Row>,
        loads: &mut Vec<Load>,
        (states, outputs, whens): (&[State], &mut [Output], &mut [When]),
        contacts: &mut Vec<Contact>,
    ) -> Eval<Vec<Row>> {
        let mut left = Vec::with_capacity(rows.len());
        let (mut stands_for, mut opened) = (Vec::new(), Vec::new());
        for row in rows {
            let Some((scope, condition)) = self.condition_of(&row) else {
                left.push(row);
                continue;
            };
            let exists = self.event_condition(scope, condition, ("a constraint", Reads::EVENT))?;
            self.refuse_reading(scope, condition, &row, (loads, states))?;
            let is_joint = self.unresolved.parts[row.part].pair.is_some();
            if is_joint && opened.iter().all(|(part, _)| *part != row.part) {
                opened.push((row.part, exists));
            }
            let lambda = Expr::symbol(format!("lambda_{}", row.name));
            stands_for.push((row.lambda, -lambda));
            contacts.push(Contact {
                name: row.name,
                part: row.part,
                displacement: row.phi,
                lambda,
                mode: Expr::symbol("mode"),
                law: ContactLaw::Constraint,
                exists: Some(exists),
                unit: row.unit,
                span: row.span,
                declared: row.declared,
            });
        }
        for (part, exists) in opened {
            self.unresolved.parts[part].pair = None;
            for load in loads.iter_mut().filter(|load| load.part == part) {
                load.force = load.force.map_each(|force| force * exists);
            }
            let is_beside = |of: &&mut Contact| of.part == part && !matches!(of.law, ContactLaw::Constraint);
            for contact in contacts.iter_mut().filter(is_beside) {
                contact.exists = Some(contact.exists.map_or(exists, |own| own * exists));
            }
        }
        for output in outputs {
            output.components = algebra::substitute(&output.components, &stands_for);
        }
        let of_events = whens.iter_mut().filter_map(|when| when.condition.as_mut());
        for place in contacts.iter_mut().flat_map(Contact::expressions_mut).chain(of_events) {
            *place = algebra::substitute(&[*place], &stands_for)[0];
        }
        for contact in contacts.iter().filter(|contact| matches!(contact.law, ContactLaw::Constraint)) {
            let lambda = contact.lambda;
            self.push_force(contact.displacement, contact.part, |entry| entry * lambda, loads);
        }
        Ok(left)
    }

    /// The condition of a row: its own, or that of its joint.
    fn condition_of(&self, row: &Row) -> Option<(ScopeId, &'a ast::Expr)> {
        let of = self.unresolved.rows.iter().find(|of| of.lambda == row.lambda)?;
        let own = of.when.map(|when| (of.scope, when));
        own.or_else(|| {
            let (scope, field) = self.names.word(self.names.instance(of.scope)?, WHEN)?;
            Some((scope, &field.value))
        })
    }

    /// Forces and rates do not read the reactions of what may open.
    fn refuse_reading(
        &mut self,
        scope: ScopeId,
        condition: &ast::Expr,
        row: &Row,
        (loads, states): (&[Load], &[State]),
    ) -> Eval<()> {
        let of_loads = loads.iter().flat_map(|load| load.force);
        let read = algebra::symbols(&of_loads.chain(states.iter().map(|state| state.rate)).collect_vec());
        if !read.contains(&row.lambda) {
            return Ok(());
        }
        let message = format!("a force or a rate reads the reaction of `{}`, which may open", row.name);
        self.error(scope, Code::Feedback, condition.span, message)
            .help("let it read a `state` that follows the reaction with a lag, or the joint hold always");
        Err(Failed)
    }
}
