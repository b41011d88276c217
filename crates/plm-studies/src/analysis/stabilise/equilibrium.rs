//! An equilibrium, or how near to one a search has come.

use std::fmt;

use plm_runtime::{Dop853, Fault, Method, Sim, Statics};

use super::Stabilise;
use super::contact::Support;
use super::report::{Change, Freedom, Residual, Unbalanced};
use super::residuals::Setting;

/// Result of a search for static equilibrium.
#[derive(Clone)]
pub struct Equilibrium<M: Statics> {
    /// The mechanism with the equilibrium as its start; locks are those that it had.
    pub mechanism: M,
    /// Residuals that do not vanish: forces, rates and motions that equilibrium lacks.
    pub residuals: Vec<Residual>,
    /// Directions in which the equilibrium is not unique; along them the start was left as it was as far as possible.
    pub free: Vec<Freedom>,
    /// Coordinates and states, and how far they are from where they started.
    pub values: Vec<Change>,
    /// Gaps that are closed there and frictions that hold, with what they give.
    pub supports: Vec<Support>,
    /// Size of the mechanism, m.
    pub size: f64,
    /// Steps of the iteration.
    pub iterations: u32,
    pub(super) setting: Setting<M>,
}

impl<M: Stabilise> Equilibrium<M> {
    /// Starts a run from here, balanced or not, at the time and with the inputs that the search had: the manual's
    /// "stabilising + dynamic". Locks hold at the start alone.
    ///
    /// # Errors
    /// As those of [`Mechanism::start`](plm_runtime::Mechanism::start).
    pub fn start(self) -> Result<Sim<M>, Fault> {
        self.start_with(Dop853::default())
    }

    /// Starts a run from here with a method of choice.
    ///
    /// # Errors
    /// As those of [`Mechanism::start_with`](plm_runtime::Mechanism::start_with).
    pub fn start_with<I: Method<M>>(self, method: I) -> Result<Sim<M, I>, Fault> {
        Ok(Sim::new(self.setting.start(self.mechanism)?, method))
    }

    /// Itself, if everything is at rest.
    ///
    /// # Errors
    /// The residuals that do not vanish.
    pub fn balanced(self) -> Result<Self, Unbalanced> {
        if self.residuals.is_empty() { Ok(self) } else { Err(Unbalanced { residuals: self.residuals }) }
    }
}

impl<M: Statics> Equilibrium<M> {
    /// The position that moved most, if it moved by more than the size of the mechanism: such an equilibrium is hardly the
    /// one that was meant. A spring may be too soft, a stop be missing, or a start be far off.
    pub fn far(&self) -> Option<&Change> {
        let coordinates = self.mechanism.coordinate_names().len();
        let positions = self.values.iter().take(coordinates).filter(|change| change.unit == "m");
        let most = positions.max_by(|a, b| a.moved.abs().total_cmp(&b.moved.abs()));
        most.filter(|change| change.moved.abs() > self.size)
    }
}

/// The result without the time and the inputs of the search.
impl<M: Statics + fmt::Debug> fmt::Debug for Equilibrium<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mechanism, residuals, free, values, supports, size, iterations, setting: _ } = self;
        let mut shown = f.debug_struct("Equilibrium");
        shown.field("mechanism", mechanism).field("residuals", residuals).field("free", free);
        shown
            .field("values", values)
            .field("supports", supports)
            .field("size", size)
            .field("iterations", iterations);
        shown.finish_non_exhaustive()
    }
}

/// Results are equal whatever the time and the inputs of the search.
impl<M: Statics + PartialEq> PartialEq for Equilibrium<M> {
    fn eq(&self, other: &Self) -> bool {
        let Self { mechanism, residuals, free, values, supports, size, iterations, setting: _ } = other;
        (&self.mechanism, &self.residuals, &self.free, &self.values) == (mechanism, residuals, free, values)
            && self.supports == *supports
            && (self.size, self.iterations) == (*size, *iterations)
    }
}
