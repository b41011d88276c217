//! `ModelStructure`: outputs and derivatives, and what each depends on.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Write};

use plm_runtime::described::{Motion, Reads};
use plm_runtime::{Rate, Vector};

use super::description::output;
use super::{Exchanged, Variable, Version};

/// Writes which variables are outputs, derivatives, and known at the start. In 2.0 each of these is a list, whose variables are
/// counted from 1.
pub(super) fn structure<M: Exchanged>(version: Version, declared: &M, to: &mut impl Write) -> fmt::Result {
    let all: Vec<Variable> = Variable::all(declared).collect();
    let first = version.pick(1, 0);
    let mut each = |element: &str, wanted: &dyn Fn(Variable) -> bool| {
        let wanted: Vec<_> = all.iter().enumerate().filter(|(_, variable)| wanted(**variable)).collect();
        let list = version == Version::Two && !wanted.is_empty();
        if list {
            writeln!(to, "    <{element}>")?;
        }
        for (reference, variable) in wanted {
            let known =
                if element.starts_with("Initial") { None } else { known::<M>(version, *variable, &all) };
            let known = known.map_or(String::new(), |known| {
                let known: Vec<String> = known.iter().map(|known| (known + first).to_string()).collect();
                format!(" dependencies=\"{}\"", known.join(" "))
            });
            match version {
                Version::Two => writeln!(to, "      <Unknown index=\"{}\"{known}/>", reference + first)?,
                Version::Three => writeln!(to, "    <{element} valueReference=\"{reference}\"{known}/>")?,
            }
        }
        if list { writeln!(to, "    </{element}>") } else { Ok(()) }
    };
    let is_output = |variable| matches!(variable, Variable::Output(k) if output::<M>(k).is_some());
    let is_rate = |variable| matches!(variable, Variable::Rate(_));
    let at_start =
        |variable| is_output(variable) || is_rate(variable) || matches!(variable, Variable::State(_));
    each(version.pick("Outputs", "Output"), &is_output)?;
    each(version.pick("Derivatives", "ContinuousStateDerivative"), &is_rate)?;
    each(version.pick("InitialUnknowns", "InitialUnknown"), &at_start)?;
    match version {
        // 2.0 gives their number elsewhere.
        Version::Two => Ok(()),
        Version::Three => each("EventIndicator", &|variable| matches!(variable, Variable::Indicator(_))),
    }
}

/// The value references of what an unknown depends on; none where it may depend on all that is known.
fn known<M: Exchanged>(version: Version, unknown: Variable, all: &[Variable]) -> Option<Vec<usize>> {
    let coordinates = <M as Rate>::NQ;
    let row = row::<M>(unknown);
    let depends = |known: Variable| match (unknown, row) {
        // 2.0 lists only dependences on quantities that can change while equations hold.
        _ if version == Version::Two && matches!(known, Variable::Parameter(_)) => Some(false),
        // The rate of a coordinate is its velocity.
        (Variable::Rate(k), _) if k < coordinates => Some(known == Variable::State(k + coordinates)),
        (_, Some(reads)) => Some(is_read::<M>(reads, known)),
        _ => None,
    };
    depends(Variable::Time)?;
    let known = all.iter().enumerate().filter(|(_, known)| depends(**known) == Some(true));
    Some(known.map(|(reference, _)| reference).collect())
}

/// Reads of an output or of the rate of a first-order state.
fn row<M: Exchanged>(unknown: Variable) -> Option<&'static Reads> {
    let outputs = M::TABLES.outputs;
    let row = match unknown {
        Variable::Output(k) => {
            let (name, _) = M::OBSERVED.get(k)?;
            outputs.iter().position(|output| output.name == *name)?
        }
        Variable::Rate(k) => outputs.len() + k.checked_sub(2 * <M as Rate>::NQ)?,
        _ => return None,
    };
    M::TABLES.reads.get(row)?.as_ref()
}

/// Parameters may be in everything: poses depend on lengths.
fn is_read<M: Exchanged>(reads: &Reads, known: Variable) -> bool {
    let (coordinates, first) = (<M as Rate>::NQ, <M as Rate>::X::LEN - M::TABLES.states.len());
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
