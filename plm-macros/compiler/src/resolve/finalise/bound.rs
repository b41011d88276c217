//! Bounds of frictions: limits to either side, affine in what presses.

use crate::collect::CollectVec;
use plm_cas::{Expr, Node, algebra};

use crate::diag::Code;
use crate::model::{Limit, Range};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::expect::text_of;
use crate::resolve::values::{Eval, Failed, Form, Reads, Scalar, Value};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::{Dimension, DisplayUnit};

/// A friction whose bound is worked out.
#[derive(Clone, Copy)]
pub(super) struct Bounded {
    pub(super) contact: usize,
    pub(super) scope: ScopeId,
    /// Of its multiplier.
    pub(super) dimension: Dimension,
}

impl<'a> Resolver<'a> {
    /// How far the friction goes downwards and upwards, both not negative.
    pub(super) fn limits(&mut self, of: Bounded, bound: &'a ast::Bound) -> Eval<[Scalar; 2]> {
        let lower = bound.lower.as_ref().map(|lower| self.limit(of, lower).map(|value| (lower, value)));
        let upper = self.limit(of, &bound.upper);
        let (lower, upper) = (lower.transpose()?, upper?);
        self.check_order(of, bound, lower.map(|(expr, lower)| (expr, lower.value)), upper.value)?;
        let what = match lower {
            None => ["bound", "factor of the bound"],
            Some(_) => ["upper limit", "factor of the upper limit"],
        };
        self.check_sizes(of, &bound.upper, upper.value)?;
        self.check_later(of, upper, (what, Range::NotNegative), bound.upper.span);
        let Some((expr, lower)) = lower else { return Ok([upper; 2]) };
        self.check_sizes(of, expr, -lower.value)?;
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
        let presses = self.presses(of);
        let above = &bound.upper;
        let (span, message, help) = match lower {
            None if is_negative(upper, &presses) => {
                let help =
                    "it is the greatest friction either way; limits of their own are written `-2 N .. 3 N`";
                (
                    above.span,
                    format!("a bound of friction is not negative{}", found(above, upper)),
                    help.to_owned(),
                )
            }
            Some((below, lower)) if is_negative(upper - lower, &presses) => {
                let help = match (text_of(below), text_of(above)) {
                    (Some(below), Some(above)) => format!("the lower one stands first: `{above} .. {below}`"),
                    _ => "the lower one stands first: `-2 N .. 3 N`".to_owned(),
                };
                (bound.span(), "the limits of this friction stand in the wrong order".to_owned(), help)
            }
            Some((below, lower)) if is_negative(-lower, &presses) => {
                let help = match (text_of(below), text_of(above)) {
                    (Some(below), Some(above)) => format!("write `-{below} .. {above}`"),
                    _ => "it is written with its sign: `-2 N .. 3 N`".to_owned(),
                };
                let message = format!("the lower limit of a friction is negative{}", found(below, lower));
                (below.span, message, help)
            }
            Some(_) if is_negative(upper, &presses) => {
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

    /// A bound that falls with a size would be negative where a joint carries much.
    fn check_sizes(&mut self, of: Bounded, expr: &'a ast::Expr, bound: Expr) -> Eval<()> {
        let factors = self.sizes(of).into_iter().map(|size| bound.diff(size));
        let Some(factor) = factors.filter_map(Expr::as_number).find(|factor| factor.is_negative()) else {
            return Ok(());
        };
        let (name, factor) = (&self.unresolved.contacts[of.contact].name, factor.to_f64());
        let message =
            format!("the bound of `{name}` falls with the size of a reaction, by the factor {factor}");
        self.error(of.scope, Code::ContactNumber, expr.span, message)
            .help("a friction grows with what presses: a coefficient is not negative");
        Err(Failed)
    }

    /// A limit that depends on parameters must have its sign when they are known, and so must the factor of what presses. `what`
    /// names both.
    pub(super) fn check_later(
        &mut self,
        of: Bounded,
        limit: Scalar,
        (what, range): ([&str; 2], Range),
        span: Span,
    ) {
        if limit.nature.reads.beyond(Reads::PUSH.and(Reads::REACTION)) != Reads::PARAM {
            return;
        }
        let (value, presses) = (limit.value, self.presses(of));
        let rest = without(value, &presses);
        let factors = presses.iter().map(|press| value.diff(*press)).filter(|factor| !factor.is_zero());
        match &factors.collect_vec()[..] {
            [] => self.look_later(of.contact, what[0], (rest, of.dimension, range), span),
            [factor] if rest.is_zero() => {
                self.look_later(of.contact, what[1], (*factor, Dimension::NUMBER, range), span);
            }
            _ => {
                for size in self.sizes(of) {
                    let factor = value.diff(size);
                    if !factor.is_zero() {
                        self.look_later(of.contact, what[1], (factor, Dimension::NUMBER, range), span);
                    }
                }
            }
        }
    }

    /// A value of parameters, which is looked at when these are known.
    pub(super) fn look_later(
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

    /// A limit, which reads what is known of the state, and pushes and sizes of reactions in proportion.
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
        let (pushes, presses) = (self.pushes(), self.presses(of));
        let held = algebra::symbols(&[found.value]);
        let bends = |press: &&Expr| held.contains(press) && !is_affine(found.value, **press, &presses);
        let Some(press) = presses.iter().find(bends) else { return Ok(found) };
        let contacts = &self.unresolved.contacts;
        let row = contacts.iter().find(|row| row.lambda == *press);
        let (what, reads) = match row.filter(|_| pushes.contains(press)) {
            Some(row) => (format!("the push of `{}`", row.name), Reads::PUSH),
            None => ("the size of a reaction".to_owned(), Reads::REACTION),
        };
        let message = format!("the bound of `{}` is not in proportion to {what}", contacts[contact].name);
        let (scope, span) = self.culprit(scope, expr, reads);
        self.error(scope, Code::Feedback, span, message)
            .help("it is a sum of products like `mu*reaction(row)` and `mu*abs(reaction(row))`, with what the state gives");
        Err(Failed)
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
        let part = self.without_size(of, expr);
        let (scope, span) = self.culprit(of.scope, part, beyond);
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
                "write `mu*abs(reaction(row))`, or `mu*norm(reaction(x, y))` of two rows, or a sum of these, each to the first power",
            ),
            None => (beyond.describe(), "let it read a `state` that follows them with a lag"),
        };
        let message = format!("the bound of `{name}` reads {what}");
        self.error(scope, Code::Feedback, span, message).help(help);
        Failed
    }

    /// The term of a bound that reads a reaction otherwise than by its size, where there is one alone; else all of it.
    fn without_size(&mut self, of: Bounded, expr: &'a ast::Expr) -> &'a ast::Expr {
        let mut found = None;
        for part in self.operands(of.scope, expr) {
            let Ok(Value::Scalar(value)) = self.eval(of.scope, part) else { continue };
            let is_reaction = value.nature.reads.has(Reads::REACTION);
            if is_reaction && self.sized(of.contact, value.value).is_none() && found.replace(part).is_some() {
                return expr;
            }
        }
        found.map_or(expr, |part| self.without_size(of, part))
    }

    /// Multipliers of the unilateral rows.
    fn pushes(&self) -> Vec<Expr> {
        let rows = self.unresolved.contacts.iter().filter(|row| !row.is_friction());
        rows.map(|row| row.lambda).collect_vec()
    }

    /// Pushes, and the sizes of reactions that the limits of a friction read: none of them negative.
    pub(super) fn presses(&self, of: Bounded) -> Vec<Expr> {
        self.pushes().into_iter().chain(self.sizes(of)).collect_vec()
    }

    /// Sizes of the reactions that the limits of a friction read.
    fn sizes(&self, of: Bounded) -> Vec<Expr> {
        let reactions = &self.unresolved.contacts[of.contact].reactions;
        reactions.iter().map(|reaction| reaction.size).collect_vec()
    }
}

/// A value where nothing presses.
fn without(value: Expr, presses: &[Expr]) -> Expr {
    let none: Vec<(Expr, Expr)> = presses.iter().map(|press| (*press, Expr::ZERO)).collect_vec();
    if none.is_empty() { value } else { algebra::substitute(&[value], &none)[0] }
}

/// Is a value that is affine in what presses negative, whatever this is? What presses is not.
pub(super) fn is_negative(value: Expr, presses: &[Expr]) -> bool {
    let factors = presses.iter().map(|press| value.diff(*press));
    let terms = factors.chain([without(value, presses)]).map(Expr::as_number).collect::<Option<Vec<_>>>();
    terms.is_some_and(|terms| {
        terms.iter().any(|term| term.is_negative())
            && terms.iter().all(|term| term.is_negative() || term.is_zero())
    })
}

/// Is a value what presses times what reads nothing of this kind, and what does not read this one? A function and a condition of it
/// are not.
fn is_affine(value: Expr, press: Expr, presses: &[Expr]) -> bool {
    let factor = algebra::symbols(&[value.diff(press)]);
    let bends = |expr: Expr| {
        matches!(expr.node(), Node::Call(..) | Node::Less(..)) && algebra::symbols(&[expr]).contains(&press)
    };
    !factor.iter().any(|symbol| presses.contains(symbol))
        && !algebra::reachable(&[value]).into_iter().any(bends)
}

/// `, found …`, where that can be said in a word.
pub(super) fn found(expr: &ast::Expr, value: Expr) -> String {
    let number = value.as_number().map(|number| number.to_f64().to_string());
    text_of(expr).or(number).map_or_else(String::new, |text| format!(", found {text}"))
}
