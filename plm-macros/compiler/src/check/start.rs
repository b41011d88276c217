//! The first evaluation: every constraint, force and rate must be a number at the assembled start.

use plm_cas::{Expr, Node, algebra};

use super::Assembly;
use crate::derive::{Equations, feeds_back};
use crate::diag::{Code, Diagnostics};
use crate::formulate::{Absolute, Place};
use crate::model::Model;
use crate::span::Span;

/// Reports the constraints that are not a number at the pose where assembly ended.
pub(super) fn check_rows(
    model: &Model,
    equations: &Equations,
    values: &[(Expr, f64)],
    found: &Assembly,
    diagnostics: &mut Diagnostics,
) {
    let mut values = values.to_vec();
    values.extend(equations.q.iter().copied().zip(found.q.iter().copied()));
    super::add_sides(model, &mut values);
    for (row, _) in model.rows.iter().zip(&found.phi).filter(|(_, residual)| !residual.is_finite()) {
        report(&values, &row.name, row.span, row.phi, diagnostics);
    }
}

/// Adds accelerations and multipliers at the start.
fn add_unknowns(equations: &Equations, program: &Absolute, values: &mut Vec<(Expr, f64)>) {
    let nq = equations.q.len();
    let results = program.dynamics.results.iter().filter_map(|(place, result)| match *place {
        Place::Element("dx", k) => Some((*equations.a.get(k.checked_sub(nq)?)?, *result)),
        Place::Element("lambda", k) => Some((equations.lambda[k], *result)),
        _ => None,
    });
    let (symbols, results): (Vec<Expr>, Vec<Expr>) = results.unzip();
    let found = super::values(&results, values);
    values.extend(symbols.into_iter().zip(found));
}

/// Evaluates loads and rates at the start; what is not finite is reported where it was declared.
pub(crate) fn check_start(
    model: &Model,
    equations: &Equations,
    (program, values): (&Absolute, &[(Expr, f64)]),
    found: &Assembly,
    diagnostics: &mut Diagnostics,
) {
    let mut values = found.values(equations, values);
    super::add_sides(model, &mut values);
    if feeds_back(model) {
        add_unknowns(equations, program, &mut values);
    }
    let loads = model.loads.iter().flat_map(|load| {
        let name = &model.parts[load.part].name;
        load.force.map(|force| (name.text.as_str(), name.span, force))
    });
    let rates = model.states.iter().map(|state| (state.name.text.as_str(), state.name.span, state.rate));
    let known = |(.., expr): &(&str, Span, Expr)| !model.reads_required(*expr);
    let asked: Vec<(&str, Span, Expr)> = loads.chain(rates).filter(known).collect();
    let exprs: Vec<Expr> = asked.iter().map(|(.., expr)| *expr).collect();
    let found = super::values(&exprs, &values);
    for ((name, span, expr), _) in asked.into_iter().zip(found).filter(|(_, found)| !found.is_finite()) {
        report(&values, name, span, expr, diagnostics);
    }
}

fn report(values: &[(Expr, f64)], name: &str, span: Span, expr: Expr, diagnostics: &mut Diagnostics) {
    match zero_denominator(values, expr) {
        Some(denominator) => {
            let text = denominator.to_string();
            diagnostics
                .error(Code::DivisionByZero, span, format!("`{name}` divides by zero at the start"))
                .note(format!("`{text}` is 0 there"))
                .help("start elsewhere, or keep the denominator away from zero, as in `max(d, 1e-6 m)`");
        }
        None => {
            diagnostics
                .error(Code::OutOfDomain, span, format!("`{name}` is not a number at the start"))
                .note(format!("it is `{}`", shortened(&expr.to_string())));
        }
    }
}

/// A factor with a negative exponent that is zero.
fn zero_denominator(values: &[(Expr, f64)], root: Expr) -> Option<Expr> {
    algebra::reachable(&[root]).into_iter().find_map(|expr| {
        let Node::Product(factors) = expr.node() else { return None };
        let denominators = factors.iter().filter(|(_, exponent)| *exponent < 0);
        denominators.map(|&(factor, _)| factor).find(|&factor| super::value(factor, values) == 0.0)
    })
}

/// At most a line of text.
fn shortened(text: &str) -> String {
    if text.chars().count() <= 80 { text.to_owned() } else { text.chars().take(79).chain(['…']).collect() }
}
