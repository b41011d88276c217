//! Numbers of a mechanism, read and set by index.

use std::format;
use std::string::String;
use std::vec::Vec;

use plm_runtime::described::{Place, Quantity};
use plm_runtime::{Described, Method, Moment, Sim, StartValues, Statics};

/// Display unit of each observed quantity: the declared output of its name in its unit, or SI where there is none.
pub(crate) fn shown<M: Described>() -> impl Iterator<Item = Option<(usize, &'static Quantity)>> {
    // Both lists are in the order of the declaration.
    let mut declared = M::TABLES.outputs.iter().enumerate().peekable();
    M::OBSERVED.iter().map(move |(name, _)| declared.next_if(|(_, output)| output.name == *name))
}

/// Adds the numbers of a moment: the time (s); x, y, angle, vx, vy, omega of each body; x, y, angle of each port of the ground;
/// all observed quantities, outputs in their declared units and the others in SI.
pub(crate) fn moment<M: Described<S = f64>>(state: &M::State, numbers: &mut Vec<f64>) {
    numbers.push(state.time());
    M::poses(state, &mut |pose| numbers.extend(pose.components()));
    for port in 0..M::TABLES.ground.len() {
        numbers.extend(Place::components(state.mechanism().ground(state.time(), port)));
    }
    numbers.extend(shown::<M>().enumerate().map(|(k, output)| {
        let value = M::observed(state, k).unwrap_or(f64::NAN);
        // As the output itself is made, to the bit.
        output.map_or(value, |(_, output)| value / output.factor)
    }));
}

/// Adds what parameters change of bodies and ground, as [`Live::shape`](super::Live::shape) tells it.
pub(crate) fn shape<M: Described<S = f64>>(of: &M, shape: &mut Vec<f64>) {
    let number = |number: Option<f64>| number.unwrap_or(f64::NAN);
    for (k, body) in M::TABLES.bodies.iter().enumerate() {
        shape.extend([of.mass(k), of.inertia(k), of.depth(k)].map(number));
        shape.extend((0..body.ports.len()).flat_map(|port| Place::components(of.port(k, port))));
        shape.push(body.contour as f64);
        shape.extend((0..body.contour).flat_map(|point| of.contour(k, point).unwrap_or([f64::NAN; 2])));
    }
    for k in 0..M::TABLES.ground.len() {
        shape.extend(Place::components(of.ground(0.0, k)));
        shape.push(number(of.ground_depth(k)));
    }
    for (k, part) in M::TABLES.parts.iter().enumerate() {
        shape.extend((0..part.sizes.len()).map(|size| number(of.size(k, size))));
    }
}

/// As [`Live::size_names`](super::Live::size_names).
pub(crate) fn size_names<M: Described<S = f64>>() -> String {
    let sized = M::TABLES.parts.iter().filter(|part| !part.sizes.is_empty());
    let lines: Vec<String> = sized.map(|part| format!("{} {}", part.name, part.sizes.join(" "))).collect();
    lines.join("\n")
}

/// Sets a parameter, SI, and the start values that are made of it; those that were set by hand stay. False if there is none
/// with this index.
pub(crate) fn set_parameter<M: Described<S = f64> + Statics>(
    mechanism: &mut M,
    index: usize,
    value: f64,
) -> bool {
    let before = values(mechanism.declared_starts());
    let is_known = mechanism.set_parameter(index, value);
    let after = values(mechanism.declared_starts());
    let mut declared = before.into_iter().zip(after);
    mechanism.starts_mut().each(&mut |_, start| {
        if let Some((before, after)) = declared.next()
            && start.value == before
        {
            start.value = after;
        }
    });
    is_known
}

fn values(mut starts: impl StartValues<f64>) -> Vec<f64> {
    let mut values = Vec::new();
    starts.each(&mut |_, start| values.push(start.value));
    values
}

/// Sets a parameter in a run that goes on, SI.
pub(crate) fn set_running_parameter<M, I>(sim: &mut Sim<M, I>, index: usize, value: f64)
where
    M: Described<S = f64> + Statics,
    I: Method<M>,
{
    let state = sim.state();
    let (mut mechanism, held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    set_parameter(&mut mechanism, index, value);
    **sim = Moment::new(mechanism, held, time, x);
}

/// Sets all parameters of a run that goes on to those of a mechanism.
pub(crate) fn set_parameters<M, I>(sim: &mut Sim<M, I>, mechanism: &M)
where
    M: Described<S = f64> + Statics,
    I: Method<M>,
{
    for (index, value) in parameters(mechanism).enumerate() {
        if sim.state().mechanism().parameter(index) != Some(value) {
            set_running_parameter(sim, index, value);
        }
    }
}

/// All parameters, SI.
pub(crate) fn parameters<M: Described<S = f64>>(mechanism: &M) -> impl Iterator<Item = f64> {
    (0..).map_while(|index| mechanism.parameter(index))
}

/// An input of a run, SI.
pub(crate) fn input<M: Described<S = f64>>(state: &M::State, index: usize) -> Option<f64> {
    M::input(M::inputs(&mut state.held()), index).copied()
}

/// Sets an input of a run, SI; false if there is none with this index.
pub(crate) fn set_input<M, I>(sim: &mut Sim<M, I>, index: usize, value: f64) -> bool
where
    M: Described<S = f64>,
    I: Method<M>,
{
    let state = sim.state();
    let (mechanism, mut held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    let Some(input) = M::input(M::inputs(&mut held), index) else { return false };
    *input = value;
    **sim = Moment::new(mechanism, held, time, x);
    true
}
