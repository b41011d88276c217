//! Conditions of the state: their texts, and what they read.

use plm_cas::algebra;

use crate::collect::CollectVec;
use crate::derive::Equations;
use crate::model::{Model, Switch};

/// The conditions of the state as they were written; with whose they are, where several are written alike.
pub(crate) fn texts(model: &Model) -> impl Iterator<Item = String> {
    let of_state = || model.switches.iter().take(model.guards());
    let is_alone = move |text: &str| of_state().filter(|other| other.text == text).count() < 2;
    of_state().map(move |Switch { text, name, .. }| match text.as_str() {
        "" => name.clone(),
        text if is_alone(text) => text.to_owned(),
        text => format!("{text} ({name})"),
    })
}

/// Does a condition read accelerations or reactions of joints?
pub(crate) fn read_solution(model: &Model, equations: &Equations) -> bool {
    let differences = model.switches.iter().map(|switch| switch.difference);
    let read = algebra::symbols(&differences.collect_vec());
    equations.a.iter().chain(&equations.lambda).any(|unknown| read.contains(unknown))
}
