//! The first evaluation: every constraint, force and rate must be a number at the assembled start.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Node, algebra};

use crate::derive::{feeds_back, forcing_terms};
use crate::diag::{Code, Diagnostics};
use crate::formulate::Place;
use crate::numeric::{self, Assembly, Scene, add_switches, value};
use crate::span::Span;

/// Reports the constraints that are not a number at the pose where assembly ended.
pub(super) fn check_rows(scene: &Scene, found: &Assembly, diagnostics: &mut Diagnostics) {
    let mut values = scene.at(&found.q);
    add_switches(scene.model, &mut values);
    let rows = scene.model.rows.iter().zip(&found.phi);
    for (row, _) in rows.filter(|(_, phi)| !phi.is_finite()) {
        report(&values, &row.name, row.span, row.phi, diagnostics);
    }
}

/// Reports loads and rates that are not finite at the start, where they were declared.
pub(super) fn check_forces(scene: &Scene, found: &Assembly, diagnostics: &mut Diagnostics) {
    let mut values = scene.moving(&found.q, &found.v);
    add_switches(scene.model, &mut values);
    if feeds_back(scene.model) {
        add_unknowns(scene, &mut values);
    }
    let forcing: Vec<_> =
        forcing_terms(scene.model).filter(|term| !scene.model.reads_required(term.value)).collect_vec();
    let found: Vec<Expr> = forcing.iter().map(|term| term.value).collect_vec();
    let found = numeric::values(&found, &values);
    for (term, _) in forcing.iter().zip(found).filter(|(_, found)| !found.is_finite()) {
        report(&values, &term.name.text, term.name.span, term.value, diagnostics);
    }
}

/// Gives accelerations and multipliers their values at the start.
fn add_unknowns(scene: &Scene, values: &mut Vec<(Expr, f64)>) {
    let equations = scene.equations;
    let nq = equations.q.len();
    let results = scene.absolute.dynamics.results.iter().filter_map(|(place, result)| match *place {
        Place::Element("dx", k) => Some((*equations.a.get(k.checked_sub(nq)?)?, *result)),
        Place::Element("lambda", k) => Some((equations.lambda[k], *result)),
        _ => None,
    });
    let (symbols, results): (Vec<Expr>, Vec<Expr>) = results.unzip();
    let found = numeric::values(&results, values);
    values.retain(|(symbol, _)| !symbols.contains(symbol));
    values.push_all(symbols.into_iter().zip(found));
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
        denominators.map(|&(factor, _)| factor).find(|&factor| value(factor, values) == 0.0)
    })
}

/// At most a line of text.
fn shortened(text: &str) -> String {
    if text.chars().count() <= 80 { text.to_owned() } else { text.chars().take(79).chain(['…']).collect() }
}
