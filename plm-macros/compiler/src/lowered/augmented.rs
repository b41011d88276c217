//! Linearised equations as data.

use super::Parts;
use super::routine::Routine;
use crate::formulate::Elimination;
use crate::source::Origin;

/// The linearised equations that implicit methods solve in place of df/dx.
#[derive(Clone, Debug)]
pub struct Augmented {
    /// `c`: the coefficients where the rate `dx` is known, in absolute coordinates with the multipliers `lambda`.
    pub coefficients: Routine,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Number of first-order states.
    pub states: usize,
    /// How they are eliminated.
    pub elimination: Elimination,
}

impl Augmented {
    /// Those of the form of the state, if implicit methods solve any.
    pub(super) fn new(parts: &Parts) -> Option<Augmented> {
        let (linearised, origin) = match parts.reduced {
            None => (parts.program.absolute.linearised.as_ref()?, Origin::Linearised),
            Some(reduced) => {
                let chart = reduced.first()?;
                (chart.linearised.as_ref()?, Origin::Chart(chart))
            }
        };
        let augmented = &linearised.augmented;
        linearised.sparse.then(|| Augmented {
            coefficients: parts.routine(&augmented.coefficients, origin),
            coordinates: augmented.accelerations.len(),
            states: augmented.states,
            elimination: Elimination::of(augmented),
        })
    }
}
