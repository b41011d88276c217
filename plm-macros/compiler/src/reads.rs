//! Reads of outputs and of rates of first-order states at a moment, for whoever couples mechanisms: nothing else has
//! influence on them.

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use crate::model::Model;

/// Reads of a quantity, beside parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reads {
    /// Quantities of bodies.
    pub motion: Motion,
    /// Is the time read, by itself or by a motion that is prescribed?
    pub time: bool,
    /// First-order states, by number.
    pub states: Vec<usize>,
    /// Inputs, by number.
    pub inputs: Vec<usize>,
}

/// Quantities of bodies that are read; called as in the runtime.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// None.
    Nothing,
    /// Poses, which all coordinates may give.
    Poses,
    /// Velocities, which all coordinates and their rates may give.
    Velocities,
}

/// Reads of each component of the declared outputs, then of the rate of each first-order state; `None` where an acceleration, a
/// reaction or an unknown of another kind is read, which may depend on all.
pub(crate) fn reads(model: &Model) -> Vec<Option<Reads>> {
    let phi: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
    let prescribed = algebra::symbols(&phi).contains(&model.time);
    let declared = model.outputs.iter().filter(|output| output.declared);
    let outputs = declared.flat_map(|output| output.components.iter().copied());
    let rates = model.states.iter().map(|state| state.rate);
    outputs.chain(rates).map(|value| of(model, value, prescribed)).collect_vec()
}

/// Reads of an expression; poses read the time where it is prescribed how something moves.
fn of(model: &Model, value: Expr, prescribed: bool) -> Option<Reads> {
    let mut reads = Reads { motion: Motion::Nothing, time: false, states: Vec::new(), inputs: Vec::new() };
    for symbol in algebra::symbols(&[value]) {
        if symbol == model.time {
            reads.time = true;
        } else if let Some(input) = model.inputs.iter().position(|input| input.symbol == symbol) {
            reads.inputs.push(input);
        } else if let Some(state) = model.states.iter().position(|state| state.symbol == symbol) {
            reads.states.push(state);
        } else if model.bodies.iter().any(|body| body.v.contains(&symbol)) {
            reads.motion = Motion::Velocities;
        } else if model.bodies.iter().any(|body| body.q.contains(&symbol)) {
            reads.motion = reads.motion.max(Motion::Poses);
        } else if !is_constant(model, symbol) {
            return None;
        }
    }
    reads.time |= prescribed && reads.motion > Motion::Nothing;
    reads.states.sort_unstable();
    reads.inputs.sort_unstable();
    Some(reads)
}

/// Does a symbol stay as it is between two events?
fn is_constant(model: &Model, symbol: Expr) -> bool {
    model.params.iter().any(|param| param.symbol == symbol)
        || model.switches.iter().any(|side| side.symbol == symbol)
        || model.turns.iter().any(|counted| counted.symbol == symbol)
}
