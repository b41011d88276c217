//! `ModelStructure`: outputs and derivatives, and what each depends on.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Write};

use plm_runtime::described::{Motion, Reads};
use plm_runtime::{System, Vector};

use super::description::output;
use super::{Exchanged, Variable};

/// Writes which variables are outputs, derivatives, and known at the start.
pub(super) fn structure<M: Exchanged>(declared: &M, to: &mut impl Write) -> fmt::Result {
    let all: Vec<Variable> = Variable::all(declared).collect();
    let mut each = |element: &str, wanted: &dyn Fn(Variable) -> bool| {
        let mut wanted = all.iter().enumerate().filter(|(_, variable)| wanted(**variable));
        wanted.try_for_each(|(reference, variable)| {
            let known = if element == "InitialUnknown" { None } else { known::<M>(*variable, &all) };
            let known = known.map_or(String::new(), |known| format!(" dependencies=\"{known}\""));
            writeln!(to, "    <{element} valueReference=\"{reference}\"{known}/>")
        })
    };
    let is_output = |variable| matches!(variable, Variable::Output(k) if output::<M>(k).is_some());
    let is_rate = |variable| matches!(variable, Variable::Rate(_));
    let at_start =
        |variable| is_output(variable) || is_rate(variable) || matches!(variable, Variable::State(_));
    each("Output", &is_output)?;
    each("ContinuousStateDerivative", &is_rate)?;
    each("InitialUnknown", &at_start)?;
    each("EventIndicator", &|variable| matches!(variable, Variable::Indicator(_)))
}

/// The value references of what an unknown depends on; none where it may depend on all that is known.
fn known<M: Exchanged>(unknown: Variable, all: &[Variable]) -> Option<String> {
    let coordinates = <M as System>::NQ;
    let row = row::<M>(unknown);
    let depends = |known: Variable| match (unknown, row) {
        // The rate of a coordinate is its velocity.
        (Variable::Rate(k), _) if k < coordinates => Some(known == Variable::State(k + coordinates)),
        (_, Some(reads)) => Some(is_read::<M>(reads, known)),
        _ => None,
    };
    depends(Variable::Time)?;
    let known = all.iter().enumerate().filter(|(_, known)| depends(**known) == Some(true));
    let known: Vec<String> = known.map(|(reference, _)| reference.to_string()).collect();
    Some(known.join(" "))
}

/// What an output or the rate of a first-order state reads.
fn row<M: Exchanged>(unknown: Variable) -> Option<&'static Reads> {
    let outputs = M::TABLES.outputs;
    let row = match unknown {
        Variable::Output(k) => {
            let (name, _) = M::OBSERVED.get(k)?;
            outputs.iter().position(|output| output.name == *name)?
        }
        Variable::Rate(k) => outputs.len() + k.checked_sub(2 * <M as System>::NQ)?,
        _ => return None,
    };
    M::TABLES.reads.get(row)?.as_ref()
}

/// Parameters may be in everything: poses depend on lengths.
fn is_read<M: Exchanged>(reads: &Reads, known: Variable) -> bool {
    let (coordinates, first) = (<M as System>::NQ, <M as System>::X::LEN - M::TABLES.states.len());
    match known {
        Variable::Time => reads.time,
        Variable::Parameter(_) => true,
        Variable::Input(k) => reads.inputs.contains(&k),
        Variable::State(k) if k < coordinates => reads.motion >= Motion::Poses,
        Variable::State(k) if k < first => reads.motion == Motion::Velocities,
        Variable::State(k) => reads.states.contains(&(k - first)),
        _ => false,
    }
}
