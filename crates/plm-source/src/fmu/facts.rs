//! Facts of a mechanism that the description of its FMU tells.

use plm_foreign::fmi::{Code, Facts, Interfaces, Parameter, Variable};

use crate::plan::Plan;

/// A kind of variable, and how many there are.
type Count = (fn(usize) -> Variable, usize);

/// The usual length of steps of co-simulation, s.
const STEP: f64 = 1e-3;

/// Those of a plan.
pub(super) fn facts<'a>(
    plan: &Plan<'a>,
    interfaces: Interfaces,
    token: &str,
    files: &'a [&'a str],
) -> Facts<'a> {
    let (lowered, counts) = (plan.lowered, &plan.counts);
    let observed: Vec<_> =
        plan.outputs().map(|(_, output)| (output.name.as_str(), output.si.as_str())).collect();
    let guards: Vec<&str> =
        lowered.switches.all.iter().take(counts.guards).map(|switch| switch.name.as_str()).collect();
    // One of the loops, where they are followed.
    let indicators = if interfaces.exchange() { guards.len() + usize::from(plan.is_loops()) } else { 0 };
    let kinds: [Count; 7] = [
        (Variable::Parameter, plan.start.parameters.len()),
        (Variable::Input, plan.start.inputs.len()),
        (Variable::Output, observed.len()),
        (Variable::State, counts.states),
        (Variable::Rate, if plan.has_own_rate() { counts.states } else { 0 }),
        (Variable::Indicator, indicators),
        (|_| Variable::Step, usize::from(interfaces.co_simulation())),
    ];
    let of_kinds = kinds.into_iter().flat_map(|(make, count)| (0..count).map(make));
    let parameters = plan.start.parameters.iter().zip(&plan.is_fixed);
    let names = lowered.names.iter().map(String::as_str).chain(std::iter::repeat(""));
    let typical = lowered.typical.iter().copied().chain(std::iter::repeat(1.0));
    Facts {
        tables: plan.tables,
        token: token.to_owned(),
        code: Code::Source(files),
        interfaces,
        variables: std::iter::once(Variable::Time).chain(of_kinds).collect(),
        parameters: parameters
            .map(|(value, is_fixed)| Parameter { value: *value, is_constant: *is_fixed })
            .collect(),
        inputs: plan.start.inputs.clone(),
        starts: Vec::new(),
        observed,
        coordinates: counts.coordinates,
        states: names.zip(typical).take(counts.states).collect(),
        guards,
        contacts: Vec::new(),
        time: plan.start.time,
        tolerance: None,
        step: STEP,
    }
}
