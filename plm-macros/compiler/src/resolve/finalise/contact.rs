//! Laws of the rows of contact, and their forces: `+lambda` along the gradient of the displacement, so that a positive
//! multiplier pushes it up.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Node, algebra};

use crate::diag::Code;
use crate::model::{Contact, ContactLaw, Limit, Load, Range, Reaction, Step};
use crate::resolve::Resolver;
use crate::resolve::declarations::contact::{Displacement, UnresolvedContact, WrittenContact};
use crate::resolve::names::ScopeId;
use crate::resolve::values::expect::text_of;
use crate::resolve::values::{Eval, Failed, Form, Quantity, Reads, Scalar, Value, all};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::{Dimension, DisplayUnit};

/// The scope of the mechanism, where steps are ordered.
const MECHANISM: ScopeId = 0;

/// A friction whose bound is worked out.
#[derive(Clone, Copy)]
struct Bounded {
    contact: usize,
    scope: ScopeId,
    /// Of its multiplier.
    dimension: Dimension,
}

impl<'a> Resolver<'a> {
    /// All rows of contact; their forces go to the loads.
    pub(crate) fn evaluate_contacts(&mut self, loads: &mut Vec<Load>) -> Eval<Vec<Contact>> {
        if !self.unresolved.contacts.is_empty() {
            self.refuse_steps();
        }
        let contacts = all((0..self.unresolved.contacts.len()).map(|contact| self.contact(contact)))?;
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
        let exists = written
            .when()
            .map(|when| self.event_condition(scope, when, ("a row of contact", Reads::EVENT)))
            .transpose();
        let (displacement, law, exists) = (displacement?, law?, exists?);
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
            let kinetic = values(kinetic);
            return Ok(ContactLaw::Friction {
                kinetic,
                adhesion: kinetic,
                reaction: self.bounding_reaction(of),
            });
        };
        let pushes = self.pushes();
        let sides = [(bound.lower.as_ref().unwrap_or(&bound.upper), 0), (&bound.upper, 1)];
        for (expr, side) in sides {
            let (more, less) = (adhesion[side].value, kinetic[side].value);
            if is_negative(more - less, &pushes) {
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
        Ok(ContactLaw::Friction { kinetic, adhesion, reaction: self.bounding_reaction(of) })
    }

    /// The reaction of joints that the limits of a friction read.
    fn bounding_reaction(&self, of: Bounded) -> Option<Reaction> {
        self.unresolved.contacts[of.contact].reaction.clone()
    }

    /// How far the friction goes downwards and upwards, both not negative.
    fn limits(&mut self, of: Bounded, bound: &'a ast::Bound) -> Eval<[Scalar; 2]> {
        let lower = bound.lower.as_ref().map(|lower| self.limit(of, lower).map(|value| (lower, value)));
        let upper = self.limit(of, &bound.upper);
        let (lower, upper) = (lower.transpose()?, upper?);
        self.check_order(of, bound, lower.map(|(expr, lower)| (expr, lower.value)), upper.value)?;
        let what = match lower {
            None => ["bound", "factor of the bound"],
            Some(_) => ["upper limit", "factor of the upper limit"],
        };
        self.check_later(of, upper, (what, Range::NotNegative), bound.upper.span);
        let Some((expr, lower)) = lower else { return Ok([upper; 2]) };
        let what = ["lower limit", "factor of the lower limit"];
        self.check_later(of, lower, (what, Range::NotPositive), expr.span);
        Ok([lower.map(|lower| -lower), upper])
    }

    /// The limits of a bound must hold zero between them.
    fn check_order(
        &mut self,
        of: Bounded,
        bound: &'a ast::Bound,
        lower: Option<(&'a ast::Expr, Expr)>,
        upper: Expr,
    ) -> Eval<()> {
        let pushes = self.pushes();
        let above = &bound.upper;
        let (span, message, help) = match lower {
            None if is_negative(upper, &pushes) => {
                let help =
                    "it is the greatest friction either way; limits of their own are written `-2 N .. 3 N`";
                (
                    above.span,
                    format!("a bound of friction is not negative{}", found(above, upper)),
                    help.to_owned(),
                )
            }
            Some((below, lower)) if is_negative(upper - lower, &pushes) => {
                let help = match (text_of(below), text_of(above)) {
                    (Some(below), Some(above)) => format!("the lower one stands first: `{above} .. {below}`"),
                    _ => "the lower one stands first: `-2 N .. 3 N`".to_owned(),
                };
                (bound.span(), "the limits of this friction stand in the wrong order".to_owned(), help)
            }
            Some((below, lower)) if is_negative(-lower, &pushes) => {
                let help = match (text_of(below), text_of(above)) {
                    (Some(below), Some(above)) => format!("write `-{below} .. {above}`"),
                    _ => "it is written with its sign: `-2 N .. 3 N`".to_owned(),
                };
                let message = format!("the lower limit of a friction is negative{}", found(below, lower));
                (below.span, message, help)
            }
            Some(_) if is_negative(upper, &pushes) => {
                let help = "a friction may act both ways: zero stands between its limits".to_owned();
                (
                    above.span,
                    format!("the upper limit of a friction is not negative{}", found(above, upper)),
                    help,
                )
            }
            _ => return Ok(()),
        };
        self.error(of.scope, Code::ContactNumber, span, message).help(help);
        Err(Failed)
    }

    /// A limit that depends on parameters must have its sign when they are known, and so must the factor of a push. `what` names
    /// both.
    fn check_later(&mut self, of: Bounded, limit: Scalar, (what, range): ([&str; 2], Range), span: Span) {
        if limit.nature.reads.beyond(Reads::PUSH) != Reads::PARAM {
            return;
        }
        let (value, pushes) = (limit.value, self.pushes());
        let rest = without(value, &pushes);
        let factors = pushes.iter().map(|push| value.diff(*push)).filter(|factor| !factor.is_zero());
        match &factors.collect_vec()[..] {
            [] => self.look_later(of.contact, what[0], (rest, of.dimension, range), span),
            [factor] if rest.is_zero() => {
                self.look_later(of.contact, what[1], (*factor, Dimension::NUMBER, range), span);
            }
            _ => {}
        }
    }

    /// A value of parameters, which is looked at when these are known.
    fn look_later(
        &mut self,
        contact: usize,
        what: &str,
        (value, of, range): (Expr, Dimension, Range),
        span: Span,
    ) {
        self.unresolved.limits.push(Limit {
            part: self.unresolved.contacts[contact].name.clone(),
            what: what.to_owned(),
            value,
            unit: DisplayUnit::si(of).text,
            range,
            code: Code::ContactNumber,
            span,
        });
    }

    /// A limit, which reads what is known of the state, and pushes in proportion.
    fn limit(&mut self, of: Bounded, expr: &'a ast::Expr) -> Eval<Scalar> {
        let Bounded { contact, scope, dimension } = of;
        self.is_no_coefficient(of, expr)?;
        let mut found = self.eval_quantity(scope, expr, dimension, Reads::ALL)?;
        let beyond = found.nature.reads.beyond(Reads::BOUND);
        let sized = if beyond == Reads::REACTION { self.sized(contact, found.value) } else { None };
        if let Some(sized) = sized {
            found.value = sized;
        } else if beyond != Reads::NOTHING {
            return Err(self.unbound(of, expr, beyond, found.value));
        }
        let pushes = self.pushes();
        let held = algebra::symbols(&[found.value]);
        for push in pushes.iter().filter(|push| held.contains(push)) {
            if !is_affine(found.value, *push, &pushes) {
                let of = &self.unresolved.contacts;
                let row = of.iter().find(|row| row.lambda == *push).map_or("", |row| &row.name);
                let message = format!(
                    "the bound of `{}` is not in proportion to the push of `{row}`",
                    of[contact].name
                );
                let (scope, span) = self.culprit(scope, expr, Reads::PUSH);
                self.error(scope, Code::Feedback, span, message)
                    .help("it is a sum of products like `mu*reaction(row)`, with what the state gives");
                return Err(Failed);
            }
        }
        Ok(found)
    }

    /// A coefficient of friction alone is no bound.
    fn is_no_coefficient(&mut self, of: Bounded, expr: &'a ast::Expr) -> Eval<()> {
        let Ok(Value::Scalar(found)) = self.eval(of.scope, expr) else { return Ok(()) };
        if found.nature.dimension != Dimension::NUMBER || found.value.is_zero() {
            return Ok(());
        }
        let (text, wanted) = (text_of(expr), of.dimension.describe());
        let (code, found) = match (&text, found.nature.form) {
            (Some(text), Form::Bare) => (Code::MissingUnit, format!("{text} without a unit")),
            _ => (Code::WrongDimension, "a number".to_owned()),
        };
        let (text, unit) = (text.as_deref().unwrap_or("mu"), of.dimension.si_unit());
        let help = format!(
            "a coefficient stands before a push, `{text}*reaction(row)`; a bound by itself has a unit, as `5 {unit}`"
        );
        self.error(of.scope, code, expr.span, format!("expected {wanted}, found {found}")).help(help);
        Err(Failed)
    }

    /// A bound reads what it may not.
    fn unbound(&mut self, of: Bounded, expr: &'a ast::Expr, beyond: Reads, value: Expr) -> Failed {
        let (scope, span) = self.culprit(of.scope, expr, beyond);
        let read = algebra::symbols(&[value]);
        let contacts = &self.unresolved.contacts;
        let name = &contacts[of.contact].name;
        let other = contacts.iter().find(|row| row.is_friction() && read.contains(&row.lambda));
        let (what, help) = match other.filter(|_| beyond.has(Reads::FRICTION)) {
            Some(row) if row.lambda == contacts[of.contact].lambda => (
                "its own friction".to_owned(),
                "a bound says how great the friction may be: let it read what presses, `mu*reaction(row)`",
            ),
            Some(row) => (
                format!("the friction of `{}`", row.name),
                "let both bounds read what presses, `mu*reaction(row)`",
            ),
            None if beyond.has(Reads::REACTION) => (
                "the reaction of a joint, and not its size".to_owned(),
                "write `mu*abs(reaction(row))`, or `mu*norm(reaction(x, y))` of two rows: one of them, to the first power",
            ),
            None => (beyond.describe(), "let it read a `state` that follows them with a lag"),
        };
        let message = format!("the bound of `{name}` reads {what}");
        self.error(scope, Code::Feedback, span, message).help(help);
        Failed
    }

    /// Multipliers of the unilateral rows.
    fn pushes(&self) -> Vec<Expr> {
        let rows = self.unresolved.contacts.iter().filter(|row| !row.is_friction());
        rows.map(|row| row.lambda).collect_vec()
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

/// A value where nothing pushes.
fn without(value: Expr, pushes: &[Expr]) -> Expr {
    let none: Vec<(Expr, Expr)> = pushes.iter().map(|push| (*push, Expr::ZERO)).collect_vec();
    if none.is_empty() { value } else { algebra::substitute(&[value], &none)[0] }
}

/// Is a value that is affine in pushes negative, whatever these are? Pushes are not.
fn is_negative(value: Expr, pushes: &[Expr]) -> bool {
    let factors = pushes.iter().map(|push| value.diff(*push));
    let terms = factors.chain([without(value, pushes)]).map(Expr::as_number).collect::<Option<Vec<_>>>();
    terms.is_some_and(|terms| {
        terms.iter().any(|term| term.is_negative())
            && terms.iter().all(|term| term.is_negative() || term.is_zero())
    })
}

/// Is a value a push times what reads no push, and what does not read this one? A function and a condition of it are not.
fn is_affine(value: Expr, push: Expr, pushes: &[Expr]) -> bool {
    let factor = algebra::symbols(&[value.diff(push)]);
    let bends = |expr: Expr| {
        matches!(expr.node(), Node::Call(..) | Node::Less(..)) && algebra::symbols(&[expr]).contains(&push)
    };
    !factor.iter().any(|symbol| pushes.contains(symbol))
        && !algebra::reachable(&[value]).into_iter().any(bends)
}

/// `, found …`, where that can be said in a word.
fn found(expr: &ast::Expr, value: Expr) -> String {
    let number = value.as_number().map(|number| number.to_f64().to_string());
    text_of(expr).or(number).map_or_else(String::new, |text| format!(", found {text}"))
}
