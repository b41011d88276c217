//! The contract between generated equations of motion and the methods that integrate them, in four parts.

mod computation;
mod constraints;
mod events;
mod labels;
mod quantities;
mod rate;
mod values;

pub use computation::Computation;
pub use constraints::Constraints;
pub use events::Events;
pub use labels::{LabelTable, Labels, PartNames};
pub use quantities::{Drift, Energy, Health, Updated};
pub use rate::{OneStep, Rate, WholeStep, rate_aside};
pub use values::Question;
pub(crate) use values::{value, values};

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
