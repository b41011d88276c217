//! Laws of the rows of contact, and their forces: `+lambda` along the gradient of the displacement, so that a positive
//! multiplier pushes it up.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, algebra};

use super::bound::{Bounded, found, is_negative};
use crate::diag::Code;
use crate::model::{Contact, ContactLaw, ContactMode, Load, Range, Reaction, Step};
use crate::resolve::Resolver;
use crate::resolve::declarations::contact::{Displacement, UnresolvedContact, WrittenContact};
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Quantity, Reads, Scalar, all};
use crate::syntax::ast;
use crate::units::{Dimension, DisplayUnit};

/// The scope of the mechanism, where steps are ordered.
const MECHANISM: ScopeId = 0;

impl<'a> Resolver<'a> {
    /// All rows of contact; their forces go to the loads.
    pub(crate) fn evaluate_contacts(&mut self, loads: &mut Vec<Load>) -> Eval<Vec<Contact>> {
        if !self.unresolved.contacts.is_empty() {
            self.refuse_steps();
        }
        let mut contacts = all((0..self.unresolved.contacts.len()).map(|contact| self.contact(contact)))?;
        // A friction whose bound is the number zero is no row: a part may have one whose coefficient nobody sets. Nor is what never
        // exists, as in a repetition.
        let idle = contacts.iter().filter(|contact| contact.is_idle());
        let symbols = idle.flat_map(|of| {
            let is_open = of.kind_of_mode() == ContactMode::Open;
            [(of.lambda, Expr::ZERO, of.span), (of.mode, Expr::from(i32::from(is_open)), of.span)]
        });
        self.unresolved.idle = symbols.collect_vec();
        contacts.retain(|contact| !contact.is_idle());
        for contact in &contacts {
            let lambda = contact.lambda;
            self.push_force(contact.displacement, contact.part, |entry| entry * lambda, loads);
        }
        Ok(contacts)
    }

    fn contact(&mut self, contact: usize) -> Eval<Contact> {
        let UnresolvedContact { scope, written, .. } = self.unresolved.contacts[contact];
        let displacement = self.displacement(contact);
        let law = match written {
            WrittenContact::Unilateral(row) => self.unilateral(contact, row),
            WrittenContact::Friction(row) => displacement.and_then(|displacement: Displacement| {
                let dimension = displacement.of_multiplier();
                self.friction(Bounded { contact, scope, dimension }, row)
            }),
        };
        let exists = written.when().map(|when| self.existence(scope, when)).transpose();
        let (displacement, law, exists) = (displacement?, law?, exists?.flatten());
        let declared = self.contact_declared(contact);
        let UnresolvedContact { name, part, span, lambda, mode, .. } = &self.unresolved.contacts[contact];
        Ok(Contact {
            name: name.clone(),
            part: *part,
            displacement: displacement.value,
            lambda: *lambda,
            mode: *mode,
            law,
            exists,
            unit: DisplayUnit::si(displacement.dimension),
            span: *span,
            declared,
        })
    }

    /// Of the ordered steps one solves for contact forces.
    fn refuse_steps(&mut self) {
        for (step, span) in std::mem::take(&mut self.unresolved.settings.steps) {
            if step == Step::MoreauJean {
                self.unresolved.settings.steps.insert(step, span);
                continue;
            }
            let message = "this step knows no contact";
            self.error(MECHANISM, Code::MisplacedItem, span, message)
                .help("`moreau_jean` steps over impacts and friction; `start()` and `start_with` run the mechanism with its events");
        }
    }

    fn unilateral(&mut self, contact: usize, row: &'a ast::Unilateral) -> Eval<ContactLaw> {
        let Some(expr) = &row.restitution else {
            return Ok(ContactLaw::Unilateral { restitution: Expr::ZERO });
        };
        let scope = self.unresolved.contacts[contact].scope;
        let of = self.eval_quantity(scope, expr, Dimension::NUMBER, Reads::FIXED)?;
        let restitution = of.value;
        let loss = Expr::ONE - restitution;
        if is_negative(restitution, &[]) || is_negative(loss, &[]) {
            let (scope, expr) = self.origin(scope, expr);
            let message = format!("a coefficient of restitution is 0 to 1{}", found(expr, restitution));
            let diagnostic = self.error(scope, Code::ContactNumber, expr.span, message);
            if is_negative(loss, &[]) {
                diagnostic.help("above 1 the energy would grow with every impact");
            }
            return Err(Failed);
        }
        if of.nature.reads == Reads::PARAM {
            let limited = (restitution, Dimension::NUMBER, Range::Share);
            self.look_later(contact, "restitution", limited, expr.span);
        }
        Ok(ContactLaw::Unilateral { restitution })
    }

    fn friction(&mut self, of: Bounded, row: &'a ast::Friction) -> Eval<ContactLaw> {
        let kinetic = self.limits(of, &row.kinetic);
        let adhesion = row.adhesion.as_ref().map(|bound| self.limits(of, bound)).transpose();
        let (kinetic, adhesion) = (kinetic?, adhesion?);
        let (Some(bound), Some(adhesion)) = (&row.adhesion, adhesion) else {
            let (kinetic, reactions) = (values(kinetic), self.bounding_reactions(of));
            return Ok(ContactLaw::Friction { kinetic, adhesion: kinetic, reactions });
        };
        let presses = self.presses(of);
        let sides = [(bound.lower.as_ref().unwrap_or(&bound.upper), 0), (&bound.upper, 1)];
        for (expr, side) in sides {
            let (more, less) = (adhesion[side].value, kinetic[side].value);
            if is_negative(more - less, &presses) {
                let message = format!("the static bound is below the kinetic one{}", found(expr, more));
                self.error(of.scope, Code::ContactNumber, expr.span, message).help(
                    "what sticks holds as much as what slips, or more; without `static` it holds the same",
                );
                return Err(Failed);
            }
        }
        let is_even = bound.lower.is_none() && row.kinetic.lower.is_none();
        for (expr, side) in sides.into_iter().skip(usize::from(is_even)) {
            let (more, less) = (adhesion[side], kinetic[side]);
            let nature = more.nature.joined(less.nature);
            let more = Quantity::new(more.value - less.value, nature);
            let what = [
                "excess of the static bound over the kinetic one",
                "excess of the static factor over the kinetic one",
            ];
            self.check_later(of, more, (what, Range::NotNegative), expr.span);
        }
        let [kinetic, adhesion] = [kinetic, adhesion].map_each(values);
        Ok(ContactLaw::Friction { kinetic, adhesion, reactions: self.bounding_reactions(of) })
    }

    /// The reactions of joints that the limits of a friction read.
    fn bounding_reactions(&self, of: Bounded) -> Vec<Reaction> {
        self.unresolved.contacts[of.contact].reactions.clone()
    }

    /// The generalised force along the gradient of a residual or a displacement, on every body that it reads: of each entry that
    /// which `force` gives.
    pub(crate) fn push_force(
        &mut self,
        of: Expr,
        part: usize,
        force: impl Fn(Expr) -> Expr,
        loads: &mut Vec<Load>,
    ) {
        for body in 0..self.unresolved.bodies.len() {
            let mut forces = [Expr::ZERO; 3];
            for (axis, entry) in algebra::gradient(of, &self.unresolved.bodies[body].q) {
                forces[axis] = force(entry);
            }
            if forces != [Expr::ZERO; 3] {
                loads.push(Load { body, part, force: forces });
            }
        }
    }
}

fn values(limits: [Scalar; 2]) -> [Expr; 2] {
    limits.map_each(|limit| limit.value)
}
