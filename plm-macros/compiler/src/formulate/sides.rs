//! How far conditions are from switching, and when those of the time do.

use plm_cas::{Expr, algebra};

use super::function::{Function, Place};
use crate::model::Model;

/// `g`: positive as long as the side that is held applies, then what kinks bend at; symbols are replaced by `substitution`.
pub(crate) fn guards(model: &Model, substitution: &[(Expr, Expr)]) -> Function {
    let of_state = model.sides.iter().filter(|side| side.instant.is_none());
    let differences: Vec<Expr> =
        of_state.clone().map(|side| side.difference).chain(model.kinks.iter().copied()).collect();
    let differences = algebra::substitute(&differences, substitution);
    let kinks = differences[model.guards()..].to_vec();
    let results = of_state
        .zip(differences)
        .enumerate()
        .map(|(k, (side, difference))| (Place::Element("g", k), side.symbol * difference));
    let mut results: Vec<(Place, Expr)> = results.collect();
    results.extend(
        kinks.into_iter().enumerate().map(|(k, kink)| (Place::Element("g", model.guards() + k), kink)),
    );
    Function::of_results(results).optimise()
}

/// `at` and `slope` of the conditions of the time.
pub(crate) fn instants(model: &Model) -> Function {
    let instants: Vec<[Expr; 2]> = model.sides.iter().filter_map(|side| side.instant).collect();
    let times = instants.iter().enumerate().map(|(k, instant)| (Place::Element("at", k), instant[0]));
    let slopes = instants.iter().enumerate().map(|(k, instant)| (Place::Element("slope", k), instant[1]));
    Function::of_results(times.chain(slopes).collect()).optimise()
}

/// The terms of the rows that may jump, one after the other.
pub(crate) fn jumps(model: &Model) -> Function {
    let terms = model.jumps.iter().flat_map(|jump| jump.terms);
    let results = terms.enumerate().map(|(k, term)| (Place::Element("jump", k), term));
    Function::of_results(results.collect()).optimise()
}
