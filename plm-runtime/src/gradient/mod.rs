//! Derivatives of mechanisms and runs by parameters, start values, states and inputs, which are given by their names.

mod moment;
mod step;

pub use moment::{NoDerivatives, from_moment, set_input};
pub use step::Jacobian;

use core::fmt;

use crate::described::Described;
use crate::dual::Dual;
use crate::linear::Linear;
use crate::one_sided::{OneSided, Side};
use crate::scalar::{Real, Scalar};
use crate::start::{StartValues, follow};
use crate::statics::Statics;
use crate::trace::{Trace, Traced};

/// A number of a mechanism or of its run by which it is derived, by its name in the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By<'a> {
    /// A parameter, in SI units. Start values that are declared by it follow.
    Parameter(&'a str),
    /// A start value: `wheel.angle`, `wheel.omega`, or a first-order state; in SI units. It belongs to a mechanism.
    Start(&'a str),
    /// A number of the state, by its [name](crate::Labels::name_in_chart), in SI units. It belongs to a moment of a run.
    State(&'a str),
    /// An input, in SI units, which is constant until it is set. It belongs to a run, where [`set_input`] sets it; a mechanism keeps
    /// this direction free for it, or several for the intervals of a control grid.
    Input(&'a str),
}

impl<'a> By<'a> {
    /// The name.
    pub const fn name(self) -> &'a str {
        match self {
            Self::Parameter(name) | Self::Start(name) | Self::State(name) | Self::Input(name) => name,
        }
    }
}

/// The mechanism, or the moment of its run, has no number of this name.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Unknown<'a>(pub By<'a>);

impl fmt::Display for Unknown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            By::Parameter(name) => write!(f, "there is no parameter `{name}`"),
            By::Start(name) => write!(f, "there is no start value `{name}`"),
            By::State(name) => write!(f, "there is no state `{name}`; only a moment of a run has states"),
            By::Input(name) => write!(f, "there is no input `{name}`"),
        }
    }
}

impl fmt::Debug for Unknown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for Unknown<'_> {}

/// The mechanism in numbers with derivatives: direction k is the variable `by[k]`, per SI unit.
///
/// Its run makes the same steps to the same bits, except that steps of variable length end where derivatives of the rate jump (`max`,
/// `abs`, an `if` without a jump); every quantity has its derivatives, exact for the steps that were made; those of times of events,
/// impacts and changes of modes as well. A run ends with [`Cause::Grazes`](crate::Cause::Grazes), [`Cause::AtOnce`](crate::Cause::AtOnce)
/// or [`Cause::AtLimit`](crate::Cause::AtLimit) if it has no derivatives; [`with_side`] has those of either side. A run derived by lengths
/// ends with [`Cause::ChangePoint`](crate::Cause::ChangePoint) if a loop goes through a pose that exists for these lengths alone.
///
/// # Errors
/// The first name that the mechanism does not have.
pub fn with_derivatives<'a, M, const K: usize>(
    mechanism: &M,
    by: [By<'a>; K],
) -> Result<M::Lifted<K>, Unknown<'a>>
where
    M: Linear + Statics,
    M::Lifted<K>: Described<S = Dual<M::S, K>> + Statics,
{
    let (mut lifted, _) = mechanism.lift::<K>(&mechanism.unstarted());
    vary(&mut lifted, &by, |number, direction| Dual::variable(number.value, direction))?;
    Ok(lifted)
}

/// The mechanism in numbers that are recorded: variable k of the trace is `by[k]`, in SI units.
///
/// Its run makes the steps of [`with_derivatives`] to the same bits, and ends as that if there are no derivatives.
/// [`adjoint`](crate::adjoint::adjoint) computes them. Two events at one time end the run, since the forward sweep cannot know whether they
/// stay together.
///
/// # Errors
/// The first name that the mechanism does not have.
pub fn with_trace<'a, 't, M>(
    mechanism: &M,
    by: &[By<'a>],
    trace: &'t Trace<'t, M::S>,
) -> Result<M::In<Traced<'t, M::S>>, Unknown<'a>>
where
    M: Linear + Statics,
    M::In<Traced<'t, M::S>>: Described + Statics,
{
    let (mut own, _) = mechanism.in_numbers(&mechanism.unstarted(), Traced::constant);
    vary(&mut own, by, |number, index| trace.variable(number.value, index))?;
    Ok(own)
}

/// The mechanism in numbers with a one-sided derivative: by the variable `by`, which moves a little to `side`.
///
/// A run without derivatives ([`with_derivatives`]) has those of either side. Of two events at one time, the one happens that comes first
/// on this side; a condition that a motion only touches is not met if the motion moves away from it. Friction and gaps at their limits go
/// on as they do on this side. [`Side::derivative`] gives the derivative of a result.
///
/// A run to the other side of a touch has none, since there it is infinite: it ends with [`Cause::Grazes`](crate::Cause::Grazes).
///
/// # Errors
/// The mechanism does not have this name.
pub fn with_side<'a, M>(mechanism: &M, by: By<'a>, side: Side) -> Result<M::In<OneSided<M::S>>, Unknown<'a>>
where
    M: Linear + Statics,
    M::In<OneSided<M::S>>: Described + Statics,
{
    let (mut own, _) = mechanism.in_numbers(&mechanism.unstarted(), OneSided::constant);
    vary(&mut own, &[by], |number, _| OneSided::variable(number.value(), side))?;
    Ok(own)
}

/// Makes variables of what `by` has, with their indices.
fn vary<'a, M: Described<S: Real> + Statics>(
    own: &mut M,
    by: &[By<'a>],
    variable: impl Fn(M::S, usize) -> M::S,
) -> Result<(), Unknown<'a>> {
    let before = own.declared_starts();
    vary_parameters(own, by, &variable)?;
    let after = own.declared_starts();
    follow(own.starts_mut(), before, after);
    for (index, of) in by.iter().enumerate() {
        let name = match *of {
            By::Parameter(_) => continue,
            By::Start(name) => name,
            By::Input(name) if own.input_names().iter().any(|(input, _)| *input == name) => continue,
            By::State(_) | By::Input(_) => return Err(Unknown(*of)),
        };
        let mut found = false;
        own.starts_mut().each(&mut |known, start| {
            if known == name {
                // It keeps what it has of parameters that declare it, and what they give does not take its place again.
                let moves = variable(M::S::ZERO, index);
                *start = start.at((start.value + moves).with_plain(start.value.plain()));
                found = true;
            }
        });
        if !found {
            return Err(Unknown(*of));
        }
    }
    Ok(())
}

/// A number as the variable with this index. What `by` has twice goes along both.
fn varied<S: Scalar>(number: S, by: &[By<'_>], index: usize, variable: impl Fn(S, usize) -> S) -> S {
    let is_again = by.iter().take(index).any(|before| by.get(index) == Some(before));
    if is_again { number + variable(S::ZERO, index) } else { variable(number, index) }
}

/// As [`vary`], for parameters alone.
fn vary_parameters<'a, M: Described>(
    own: &mut M,
    by: &[By<'a>],
    variable: impl Fn(M::S, usize) -> M::S,
) -> Result<(), Unknown<'a>> {
    for (index, of) in by.iter().enumerate() {
        let By::Parameter(name) = *of else { continue };
        let number = own.tables().parameters.iter().position(|parameter| parameter.name == name);
        let place = number.and_then(|number| own.parameter_mut(number)).ok_or(Unknown(*of))?;
        *place = varied(*place, by, index, &variable);
    }
    Ok(())
}
