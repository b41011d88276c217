//! Rows of contact: what is known of them beside their equations.

use plm_cas::{Expr, algebra};

use crate::collect::{CollectVec, PushAll};
use crate::derive::range;
use crate::model::{Contact, ContactLaw, Model, bounding_reactions};

/// Guards of each row, and one for the determinant of the active rows: `rt::contact::guard_count`.
pub(crate) const PER_ROW: usize = 3;

/// Places for rows. After those that are declared there are some that never exist, where more reactions bound frictions than there are
/// rows.
pub(crate) fn places(model: &Model) -> usize {
    model.contacts.len().max(bounding_reactions(&model.contacts).len())
}

/// Guards of contact.
pub(crate) fn guards(model: &Model) -> usize {
    if model.contacts.is_empty() { 0 } else { PER_ROW * places(model) + 1 }
}

/// Frictions that are off without a push, by their numbers.
pub(crate) fn bounded_by_pushes(model: &Model) -> Vec<usize> {
    let contacts = &model.contacts;
    let none: Vec<(Expr, Expr)> = contacts.iter().map(|row| (row.lambda, Expr::ZERO)).collect_vec();
    let is_bounded = |row: &Contact| match &row.law {
        ContactLaw::Friction { kinetic, adhesion, reactions } if reactions.is_empty() => {
            let limits = [*kinetic, *adhesion].concat();
            algebra::substitute(&limits, &none).into_iter().all(Expr::is_zero)
        }
        _ => false,
    };
    let rows = contacts.iter().enumerate().filter(|(_, row)| is_bounded(row));
    rows.map(|(row, _)| row).collect_vec()
}

/// Frictions whose bounds follow the state or the time, and are not known to be positive whatever these are.
pub(crate) fn bounds_that_may_fall(model: &Model) -> Vec<usize> {
    let sizes = bounding_reactions(&model.contacts).into_iter().map(|reaction| reaction.size);
    let presses = sizes.chain(model.contacts.iter().map(|row| row.lambda)).collect_vec();
    let none = presses.iter().map(|press| (*press, Expr::ZERO)).collect_vec();
    let held = model.params.iter().map(|param| param.symbol);
    let held = held.chain(model.inputs.iter().map(|input| input.symbol)).collect_vec();
    let falls = |value: Expr| {
        let moves = algebra::symbols(&[value]).iter().any(|symbol| !held.contains(symbol));
        moves && range(value)[0] < 0.0
    };
    let rows = model.contacts.iter().enumerate().filter(|(_, row)| {
        let ContactLaw::Friction { kinetic, adhesion, .. } = &row.law else { return false };
        [*kinetic, *adhesion].concat().into_iter().any(|limit| {
            let own = algebra::substitute(&[limit], &none)[0];
            falls(own) || presses.iter().any(|press| falls(limit.diff(*press)))
        })
    });
    rows.map(|(row, _)| row).collect_vec()
}

/// Has a row a condition for its existence?
pub(crate) fn some_may_not_exist(model: &Model) -> bool {
    model.contacts.iter().any(|row| row.exists.is_some())
}

/// Rows whose gaps read discrete states.
pub(crate) fn moved_by_states(model: &Model) -> Vec<usize> {
    let states = model.states.iter().map(|state| state.symbol).collect_vec();
    let rows = model.contacts.iter().enumerate();
    let reads = |of: Expr| algebra::symbols(&[of]).iter().any(|symbol| states.contains(symbol));
    rows.filter(|(_, row)| reads(row.displacement)).map(|(row, _)| row).collect_vec()
}

/// By guard of contact, the name of its row; the sign of a reaction has that of the first row that it bounds, and the determinant of the
/// active rows that of the first.
pub(crate) fn names_of_guards(model: &Model) -> Vec<&String> {
    let contacts = &model.contacts;
    let Some(first) = contacts.first() else { return Vec::new() };
    let reactions = bounding_reactions(contacts);
    let mut names = Vec::new();
    for place in 0..places(model) {
        let own = &contacts.get(place).unwrap_or(first).name;
        let size = reactions.get(place).map(|reaction| reaction.size);
        let reads = |contact: &&Contact| contact.reactions().iter().any(|read| Some(read.size) == size);
        let of_sign = contacts.iter().find(reads).map_or(own, |contact| &contact.name);
        names.push_all([own; PER_ROW - 1].into_iter().chain([of_sign]));
    }
    names.push(&first.name);
    names
}

/// By reaction that bounds frictions, the rows whose limits read it.
pub(crate) fn readers(model: &Model) -> Vec<Vec<usize>> {
    let reactions = bounding_reactions(&model.contacts).into_iter();
    let of_reaction = |size: Expr| {
        let reads = |contact: &Contact| contact.reactions().iter().any(|read| read.size == size);
        let rows = model.contacts.iter().enumerate().filter(|(_, contact)| reads(contact));
        rows.map(|(row, _)| row).collect_vec()
    };
    reactions.map(|reaction| of_reaction(reaction.size)).collect_vec()
}

/// Does a condition of the state read forces of contact?
pub(crate) fn are_read_by_conditions(model: &Model) -> bool {
    let read = read_by_conditions(model);
    model.contacts.iter().any(|row| read.contains(&row.lambda))
}

/// Does a condition of the state read what contacts do?
pub(crate) fn modes_are_read_by_conditions(model: &Model) -> bool {
    let read = read_by_conditions(model);
    model.contacts.iter().any(|row| read.contains(&row.mode))
}

fn read_by_conditions(model: &Model) -> Vec<Expr> {
    algebra::symbols(&model.switches.iter().map(|switch| switch.difference).collect_vec())
}
