//! The contract between generated equations of motion and the methods that integrate them, in four parts.

mod computation;
mod constraints;
mod events;
mod labels;
mod rate;
mod values;
mod whole;

pub use computation::Computation;
pub use constraints::Constraints;
pub use events::Events;
pub use labels::{LabelTable, Labels, PartNames};
pub use rate::{Rate, rate_aside};
pub use values::Question;
pub(crate) use values::{value, values};
pub use whole::{OneStep, WholeStep};

use crate::scalar::Scalar;

#[doc = include_str!("systems.md")]
pub trait System: Constraints + Events + Labels {}

impl<M: Constraints + Events + Labels> System for M {}

/// An accepted step, as its observers see it.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a, M: System> {
    /// The equations.
    pub system: &'a M,
    /// The discrete state over it.
    pub held: &'a M::U,
    /// Time, s, and state where it began.
    pub from: (M::S, &'a M::X),
    /// Time, s, and state where it ended.
    pub to: (M::S, &'a M::X),
    /// The smallest pivot ratio of its rates, [`Health`].
    pub health: M::S,
}

/// Outcome of [`Constraints::update`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Updated {
    /// The state was mapped to another chart: stored rates belong to the old one.
    pub moved: bool,
    /// Angles were reduced by whole revolutions: stored values of the state belong to the old angles.
    pub turned: bool,
    /// A singular pose was passed, where the mechanism could have gone on in another way: the part that closes its loop.
    pub passed: Option<&'static str>,
}

/// Smallest pivot of a solution without pivoting, over its diagonal entry before elimination: 1 is perfect, 0 singular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Health<S>(pub S);

impl<S: Scalar> Health<S> {
    /// Nothing could go wrong: no equation was solved.
    #[inline]
    #[must_use]
    pub fn perfect() -> Self {
        Self(S::lit(1.0))
    }

    /// Above [`Scalar::HEALTHY`] in every lane; false for NaN.
    #[inline]
    pub fn is_good(self) -> bool {
        S::all(S::lit(S::HEALTHY).lt(self.0))
    }

    /// The worse of two, lane by lane; `other` where it is NaN.
    #[inline]
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
}

/// Stored energy of a mechanism, and the power that flows in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<S> {
    /// Kinetic energy, J.
    pub kinetic: S,
    /// Potential energy of gravity, J.
    pub gravity: S,
    /// Power of all other forces and torques, springs and dampers included, W.
    pub power: S,
}

/// Largest residuals of the constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift<S> {
    /// Of position, in m or rad.
    pub phi: S,
    /// Of velocity, in m/s or rad/s.
    pub phi_dot: S,
}
