//! `ModelStructure`: outputs and derivatives, and what each depends on.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Write};

use plm_runtime::described::{Motion, Reads};

use super::{Facts, Variable, Version};

/// Writes which variables are outputs, derivatives, and known at the start. In 2.0 each of these is a list, whose variables are
/// counted from 1.
pub(super) fn structure(version: Version, facts: &Facts, to: &mut impl Write) -> fmt::Result {
    let all = &facts.variables;
    let first = version.pick(1, 0);
    let mut each = |element: &str, wanted: &dyn Fn(Variable) -> bool| {
        let wanted: Vec<_> = all.iter().enumerate().filter(|(_, variable)| wanted(**variable)).collect();
        let list = version == Version::Two && !wanted.is_empty();
        if list {
            writeln!(to, "    <{element}>")?;
        }
        for (reference, variable) in wanted {
            let known = if element.starts_with("Initial") { None } else { known(version, *variable, facts) };
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
    let is_output = |variable| matches!(variable, Variable::Output(k) if facts.output(k).is_some());
    let is_rate = |variable| matches!(variable, Variable::Rate(_));
    let is_state = |variable| matches!(variable, Variable::State(_)) && has_rates(facts);
    let at_start = |variable| is_output(variable) || is_rate(variable) || is_state(variable);
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
fn known(version: Version, unknown: Variable, facts: &Facts) -> Option<Vec<usize>> {
    let coordinates = facts.coordinates;
    let row = row(unknown, facts);
    let depends = |known: Variable| match (unknown, row) {
        // 2.0 lists only dependences on quantities that can change while equations hold.
        _ if version == Version::Two && matches!(known, Variable::Parameter(_)) => Some(false),
        // The rate of a coordinate is its velocity.
        (Variable::Rate(k), _) if k < coordinates => Some(known == Variable::State(k + coordinates)),
        (_, Some(reads)) => Some(is_read(reads, known, facts)),
        _ => None,
    };
    depends(Variable::Time)?;
    let known = facts.variables.iter().enumerate().filter(|(_, known)| depends(**known) == Some(true));
    Some(known.map(|(reference, _)| reference).collect())
}

/// Reads of an output or of the rate of a first-order state.
fn row<'a>(unknown: Variable, facts: &Facts<'a>) -> Option<&'a Reads> {
    let outputs = facts.tables.outputs;
    let row = match unknown {
        Variable::Output(k) => {
            let (name, _) = facts.observed.get(k)?;
            outputs.iter().position(|output| output.name == *name)?
        }
        Variable::Rate(k) => outputs.len() + k.checked_sub(2 * facts.coordinates)?,
        _ => return None,
    };
    facts.tables.reads.get(row)?.as_ref()
}

/// Has it the rates of its states? Without them states are no continuous states of the standard, which others depend on.
fn has_rates(facts: &Facts) -> bool {
    facts.variables.iter().any(|variable| matches!(variable, Variable::Rate(_)))
}

/// Parameters may be in everything: poses depend on lengths.
fn is_read(reads: &Reads, known: Variable, facts: &Facts) -> bool {
    let (coordinates, first) = (facts.coordinates, 2 * facts.coordinates);
    match known {
        Variable::Time => reads.time,
        Variable::Parameter(k) => facts.parameters.get(k).is_some_and(|own| !own.is_constant),
        Variable::Input(k) => reads.inputs.contains(&k),
        Variable::State(_) if !has_rates(facts) => false,
        Variable::State(k) if k < coordinates => reads.motion >= Motion::Poses,
        Variable::State(k) if k < first => reads.motion == Motion::Velocities,
        Variable::State(k) => reads.states.contains(&(k - first)),
        _ => false,
    }
}
