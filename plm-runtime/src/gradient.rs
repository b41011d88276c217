//! Mechanisms whose runs are derived by parameters and start values, which are given by their names.

use core::fmt;

use crate::described::Described;
use crate::dual::Dual;
use crate::linear::Linear;
use crate::start::{StartValues, follow};
use crate::statics::Statics;

/// A number of a mechanism by which a run is derived, by its name in the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By<'a> {
    /// A parameter, in SI units. Start values that are declared by it follow.
    Parameter(&'a str),
    /// A start value: `wheel.angle`, `wheel.omega`, or a first-order state; in SI units.
    Start(&'a str),
}

/// The mechanism has no number of this name.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it, and `unwrap`, show that one.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Unknown<'a>(pub By<'a>);

impl fmt::Display for Unknown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            By::Parameter(name) => write!(f, "there is no parameter `{name}`"),
            By::Start(name) => write!(f, "there is no start value `{name}`"),
        }
    }
}

impl fmt::Debug for Unknown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for Unknown<'_> {}

/// The same mechanism in numbers with derivatives: in direction k by what `by` has there, per SI unit.
///
/// Its run makes the same steps to the same bits, and every quantity has its derivatives, exact for the steps that were made; of times of
/// events, impacts and changes of modes as well. A run ends with [`Cause::Grazes`](crate::Cause::Grazes) or
/// [`Cause::AtOnce`](crate::Cause::AtOnce) where there are none.
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
    let before = lifted.declared_starts();
    for (direction, by) in by.into_iter().enumerate() {
        let By::Parameter(name) = by else { continue };
        let index = lifted.tables().parameters.iter().position(|parameter| parameter.name == name);
        let place = index.and_then(|index| lifted.parameter_mut(index)).ok_or(Unknown(by))?;
        *place = Dual::variable(place.value, direction);
    }
    let after = lifted.declared_starts();
    follow(lifted.starts_mut(), before, after);
    for (direction, by) in by.into_iter().enumerate() {
        let By::Start(name) = by else { continue };
        let mut found = false;
        lifted.starts_mut().each(&mut |own, start| {
            if own == name {
                start.value = Dual::variable(start.value.value, direction);
                found = true;
            }
        });
        if !found {
            return Err(Unknown(by));
        }
    }
    Ok(lifted)
}
