//! The tolerances of steps without events, for who writes these steps in another language.

use super::BALANCE_ULPS;
use super::booked::GAIN;
use super::event::CLOSED;
use super::multipliers::ROUNDED;
use super::stepping::{CARRIED, DEPENDENT, NO_SLIP, ROUNDING, tail};
use super::{bounds, sunk};
use crate::scalar::Real;

/// The tolerances of time steps and of multipliers in a scalar type, for a mechanism of a length.
#[derive(Clone, Copy, Debug)]
pub struct Constants<S> {
    /// Pivot below which a row depends on others, relative to a diagonal of one.
    pub dependent: S,
    /// Relative error of a row that others carry.
    pub carried: S,
    /// Relative error of a law that is satisfied.
    pub rounding: S,
    /// Rate, as a fraction of the change by accelerations in a step, below which a friction is assumed to stick at first.
    pub no_slip: S,
    /// Shortest rest of a step after an impact, as a fraction of the step.
    pub tail: S,
    /// Gap below which a row is closed, m or rad.
    pub closed: S,
    /// Gap up to which a constraint that begins to exist is led back, m or rad.
    pub led_back: S,
    /// Gain of an impact, as a fraction of the energy that it turns over, up to which it is rounding.
    pub gain: S,
    /// Bound of friction that is rounding, as a fraction of the force that would hold the row.
    pub no_bound: S,
    /// Multiplier that is rounding of the largest one.
    pub balance: S,
    /// Change of the forces at which sweeps end, as a fraction of the largest one.
    pub swept: f64,
}

impl<S: Real> Constants<S> {
    /// Those of the type, for a mechanism of this length, m.
    pub fn new(length: S) -> Self {
        let rounding = S::lit(ROUNDING) * S::EPSILON;
        Self {
            dependent: S::lit(DEPENDENT).max(rounding),
            carried: S::lit(CARRIED),
            rounding,
            no_slip: S::lit(NO_SLIP).max(S::lit(64.0) * S::EPSILON),
            tail: tail(),
            closed: S::lit(CLOSED) * length,
            led_back: S::lit(sunk::ROUNDED) * length,
            gain: S::lit(GAIN).max(S::lit(64.0) * S::EPSILON),
            no_bound: S::lit(bounds::ROUNDING),
            balance: S::lit(BALANCE_ULPS * S::PRECISION),
            swept: ROUNDED * S::PRECISION,
        }
    }
}
