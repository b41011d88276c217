//! Forcing terms: applied forces and torques, limits of frictions, and the rates of first-order states.

use plm_cas::Expr;

use crate::collect::{CollectVec, MapEach};
use crate::model::{ContactLaw, Model, Name};

/// An applied force or torque, a limit of one, or the rate of a state.
pub(crate) struct ForcingTerm<'a> {
    /// The part that acts, or the state.
    pub(crate) name: &'a Name,
    /// Is it a force or torque? Else it is a rate.
    pub(crate) is_force: bool,
    /// Its value: N, N m, or the state's unit per second.
    pub(crate) value: Expr,
}

/// All forces and torques, load by load, then the limits of frictions, then all rates.
pub(crate) fn forcing_terms(model: &Model) -> impl Iterator<Item = ForcingTerm<'_>> {
    let loads = model.loads.iter().flat_map(|load| {
        let name = &model.parts[load.part].name;
        load.force.map_each(|value| ForcingTerm { name, is_force: true, value })
    });
    let limits = model.contacts.iter().flat_map(|contact| {
        let name = &model.parts[contact.part].name;
        let limits = match &contact.law {
            ContactLaw::Unilateral { .. } | ContactLaw::Constraint => Vec::new(),
            ContactLaw::Friction { kinetic, adhesion, .. } => {
                kinetic.iter().chain(adhesion).copied().collect_vec()
            }
        };
        limits.into_iter().map(move |value| ForcingTerm { name, is_force: true, value })
    });
    let rates = model.states.iter();
    loads.chain(limits).chain(rates.map(|state| ForcingTerm {
        name: &state.name,
        is_force: false,
        value: state.rate,
    }))
}
