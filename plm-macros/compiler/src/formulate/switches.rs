//! How far conditions are from switching, and when those of the time do.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, algebra};

use super::function::{Function, stored};
use crate::model::{Model, When};

/// `g`: positive as long as the side that is held applies, then what kinks bend at; symbols are replaced by `substitution`.
pub(crate) fn guards(model: &Model, substitution: &[(Expr, Expr)]) -> Function {
    let of_state = model.switches.iter().filter(|switch| switch.instant.is_none());
    let differences: Vec<Expr> =
        of_state.clone().map(|switch| switch.difference).chain(model.kinks.iter().copied()).collect_vec();
    let mut g = algebra::substitute(&differences, substitution);
    for (g, switch) in g.iter_mut().zip(of_state) {
        *g = switch.symbol * *g;
        if let Some(beyond) = switch.beyond {
            *g = (*g).max(algebra::substitute(&[beyond], substitution)[0]);
        }
    }
    Function::of_array("g", &g).optimise()
}

/// `at` and `slope` of the conditions of the time: when each of them changes, s, and how fast what it compares does then.
pub(crate) fn instants(model: &Model) -> Function {
    let instants = model.switches.iter().filter_map(|switch| switch.instant);
    let (at, slope): (Vec<Expr>, Vec<Expr>) = instants.map(|[at, slope]| (at, slope)).unzip();
    let mut results = stored("at", at.iter());
    results.extend(stored("slope", slope.iter()));
    Function::of_results(results).optimise()
}

/// `holds` of the conditions of events: 1, or 0.
pub(crate) fn events(model: &Model) -> Function {
    let conditions: Vec<Expr> = model.whens.iter().filter_map(|when| when.condition).collect_vec();
    Function::of_array("holds", &conditions).optimise()
}

/// `exist` of the rows of contact: 1, or 0.
pub(crate) fn rows_exist(model: &Model) -> Function {
    let exist: Vec<Expr> = model.contacts.iter().map(|row| row.exists.unwrap_or(Expr::ONE)).collect_vec();
    Function::of_array("exist", &exist).optimise()
}

/// `set`: the values that events give, one event after the other; of events that follow conditions, and of those at the start.
pub(crate) fn values_set(model: &Model) -> [Function; 2] {
    let (whens, at_start) = When::parted(&model.whens);
    [whens, at_start].map_each(|whens| Function::of_array("set", &When::values(whens)).optimise())
}

/// The terms of the rows that may jump, one after the other.
pub(crate) fn jumps(model: &Model) -> Function {
    let terms: Vec<Expr> = model.jumps.iter().flat_map(|jump| jump.terms).collect_vec();
    Function::of_array("jump", &terms).optimise()
}
