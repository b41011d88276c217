//! What makes a mechanism move: forces on its bodies and rates of its states.

use plm_cas::Expr;

use crate::collect::MapEach;
use crate::model::{Model, Name};

/// A force or a rate, and whose it is.
pub(crate) struct Cause<'a> {
    /// The part that acts, or the state.
    pub(crate) name: &'a Name,
    /// Is it a force or torque? Else it is a rate.
    pub(crate) is_force: bool,
    /// Its value: N, N m, or the state's unit per second.
    pub(crate) value: Expr,
}

/// All forces and torques, load by load, then all rates.
pub(crate) fn causes(model: &Model) -> impl Iterator<Item = Cause<'_>> {
    let loads = model.loads.iter().flat_map(|load| {
        let name = &model.parts[load.part].name;
        load.force.map_each(|value| Cause { name, is_force: true, value })
    });
    let rates = model.states.iter();
    loads.chain(rates.map(|state| Cause { name: &state.name, is_force: false, value: state.rate }))
}
