//! Identifiers that the user's names become.

use crate::collect::CollectVec;
use proc_macro2::{Ident, Span};

use super::Place;
use super::indexed_accessors::{self, IndexedAccessor};
use super::names::{Names, token};
use crate::model::{Model, Name};

/// Identifiers of the fields and accessors of the emitted types, in the order of the model.
pub(super) struct Fields {
    pub(super) params: Vec<Ident>,
    pub(super) inputs: Vec<Ident>,
    pub(super) bodies: Vec<Ident>,
    pub(super) states: Vec<Ident>,
    /// Accessors of the outputs, beside those of the bodies.
    pub(super) outputs: Vec<Ident>,
    /// Accessors of both by their indices.
    pub(super) indexed_accessors: Vec<IndexedAccessor>,
}

/// Methods of the emitted state that no body or output may take, then those of a run, which would hide them, and those that
/// every type has. What is not for users ends in `_`, as no name of theirs does.
pub(crate) const METHODS: &[&str] = &[
    "time",
    "kinetic_energy",
    "gravity_energy",
    "load_power",
    "outputs",
    "undetermined",
    "branches",
    "starts",
    "find",
    "observed",
    "step",
    "step_to",
    "step_rk4",
    "step_semi_implicit_euler",
    "step_linearly_implicit",
    "at",
    "reset",
    "run",
    "project",
    "drift",
    "state",
    "method",
    "method_mut",
    "stats",
    "notice",
    "stop_at_change_points",
    "watch_energy",
    "count_states",
    "state_count",
    "save",
    "resume",
    "clone",
    "clone_from",
    "into",
    "try_into",
    "to_owned",
];

impl Fields {
    pub(super) fn new(model: &Model, place: Place) -> Fields {
        let mut params = Names::with_reserved(&["start"]);
        let mut inputs = Names::default();
        let mut accessors = Names::with_reserved(METHODS);
        let named = |names: &mut Names, name: &Name| {
            let span = if name.span.source == 0 { place(name.span) } else { Span::call_site() };
            token(&names.unique(&name.text), span)
        };
        let bodies: Vec<Ident> =
            model.bodies.iter().map(|body| named(&mut accessors, &body.name)).collect_vec();
        let taken: Vec<String> = bodies.iter().map(Ident::to_string).collect_vec();
        let mut starts = Names::with_reserved(&taken.iter().map(String::as_str).collect_vec());
        let outputs = model.outputs.iter();
        let outputs = outputs.map(|output| token(&accessors.unique(&output.name.text), Span::call_site()));
        Fields {
            outputs: outputs.collect_vec(),
            params: model.params.iter().map(|param| named(&mut params, &param.name)).collect_vec(),
            inputs: model.inputs.iter().map(|input| named(&mut inputs, &input.name)).collect_vec(),
            states: model.states.iter().map(|state| named(&mut starts, &state.name)).collect_vec(),
            indexed_accessors: indexed_accessors::find(model, &mut accessors),
            bodies,
        }
    }
}
