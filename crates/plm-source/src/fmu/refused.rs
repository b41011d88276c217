//! Parts of a mechanism for which a source has no model exchange.

use plm_compiler::lowered::{Form, Lowered, Set};

use crate::plan::Refused;

/// All of them. Co-simulation may have them nevertheless.
pub(super) fn exchange(lowered: &Lowered) -> Vec<Refused> {
    let mut all = Vec::new();
    let mut refuse = |part: &str, what| all.push(Refused { part: part.to_owned(), what });
    if lowered.form == Form::Absolute {
        let part = lowered.rows.first().map(|row| &row.part).or(lowered.bodies.first());
        refuse(
            part.map_or("", String::as_str),
            "model exchange in absolute coordinates, whose joints a solver's steps open",
        );
    }
    for row in lowered.contacts.iter().flat_map(|contacts| &contacts.rows) {
        refuse(&row.name, "model exchange with friction and contact that change their modes");
    }
    let switches = &lowered.switches;
    if switches.read_solution
        && let Some(switch) = switches.all.first()
    {
        refuse(&switch.name, "model exchange with a condition that reads an acceleration or a reaction");
    }
    for row in switches.jumps.iter().filter_map(|jump| lowered.rows.get(jump.row)) {
        refuse(&row.name, "model exchange with a prescribed motion that may jump");
    }
    for set in lowered.sets.events.iter().flatten() {
        let part = match *set {
            Set::State(k) => lowered.states.get(k).map(|state| &state.name),
            Set::Velocity(k) => lowered.coordinates.get(k),
        };
        refuse(part.map_or("when", String::as_str), "model exchange with an event that sets values");
    }
    all
}
