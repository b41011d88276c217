//! Moments of runs that are derived by what they have: states, inputs, parameters.

use core::fmt;

use super::{By, Unknown, varied, vary_parameters};
use crate::described::Described;
use crate::dual::Dual;
use crate::fault::Fault;
use crate::linear::Linear;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::ports::Ports;
use crate::sim::Sim;
use crate::system::Rate;
use crate::vector::Vector;

/// The reason why there are no derivatives.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq)]
pub enum NoDerivatives<'a> {
    /// There is no number of this name.
    Unknown(Unknown<'a>),
    /// The run ends early, or has no derivatives.
    Fault(Fault),
}

impl<'a> From<Unknown<'a>> for NoDerivatives<'a> {
    fn from(unknown: Unknown<'a>) -> Self {
        Self::Unknown(unknown)
    }
}

impl From<Fault> for NoDerivatives<'_> {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl fmt::Display for NoDerivatives<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(unknown) => unknown.fmt(f),
            Self::Fault(fault) => fault.fmt(f),
        }
    }
}

impl fmt::Debug for NoDerivatives<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for NoDerivatives<'_> {}

/// A simulation that begins in a moment of another one, in numbers with derivatives: in direction k by what `by` has there, states, inputs
/// and parameters, per SI unit.
///
/// Contacts, conditions and charts go on as they are at that moment. The state is taken as it is: with absolute coordinates the numbers of
/// a state depend on each other, and a direction that leaves the constraints is projected as every drift is.
///
/// # Errors
/// The first name that the moment does not have; a [start value](By::Start) is none of it.
pub fn from_moment<'a, M, J, const K: usize>(
    state: &M::State,
    method: J,
    by: [By<'a>; K],
) -> Result<Sim<M::Lifted<K>, J>, Unknown<'a>>
where
    M: Linear + Mechanism,
    M::Lifted<K>: Described<S = Dual<M::S, K>>,
    J: Method<M::Lifted<K>>,
{
    let (mut lifted, mut held) = state.mechanism().lift::<K>(&state.held());
    let mut x = <M::Lifted<K> as Rate>::X::from_fn(|i| Dual::constant(state.x().at(i)));
    let variable = |number: Dual<M::S, K>, direction| Dual::variable(number.value, direction);
    vary_parameters(&mut lifted, &by, variable)?;
    let own = |number, direction| varied(number, &by, direction, variable);
    for (direction, by) in by.into_iter().enumerate() {
        match by {
            By::Parameter(_) => {}
            By::Start(_) => return Err(Unknown(by)),
            By::State(name) => {
                let is_it = |i: &usize| state.mechanism().name_in_chart(&state.held(), *i) == name;
                let index = (0..M::X::LEN).find(is_it).ok_or(Unknown(by))?;
                x.set(index, own(x.at(index), direction));
            }
            By::Input(name) => {
                put_input(&lifted, &mut held, name, |input| own(input, direction)).ok_or(Unknown(by))?;
            }
        }
    }
    let moment = Moment::new(lifted, held, Dual::constant(state.time()), x);
    Ok(Sim::new(moment, method))
}

/// Sets an input of a run by its name, in SI units, in numbers of any kind: a variable derives what follows by this input, until it is set
/// again. So the intervals of a control grid are variables of their own.
///
/// # Errors
/// The run has no such input.
pub fn set_input<'a, M, I>(sim: &mut Sim<M, I>, name: &'a str, number: M::S) -> Result<(), Unknown<'a>>
where
    M: Ports,
    I: Method<M>,
{
    let state = sim.state();
    let (mechanism, mut held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    put_input(&mechanism, &mut held, name, |_| number).ok_or(Unknown(By::Input(name)))?;
    **sim = Moment::new(mechanism, held, time, x);
    Ok(())
}

/// Gives the input of this name another number.
fn put_input<M: Ports>(
    mechanism: &M,
    held: &mut M::U,
    name: &str,
    number: impl FnOnce(M::S) -> M::S,
) -> Option<()> {
    let index = mechanism.input_names().iter().position(|(input, _)| *input == name)?;
    let input = M::input(M::inputs(held), index)?;
    *input = number(*input);
    Some(())
}
