//! Contract of mechanisms with singular poses: their equations in numbers of twice the precision, and their coordinates.

use crate::Absolute;
use crate::double_double::DoubleDouble;
use crate::mechanism::Mechanism;
use crate::system::Step;

/// The equations of a mechanism in absolute coordinates, in numbers of twice the precision; implemented by generated code.
///
/// `NX` numbers are a state [q, v, first-order states].
pub trait ExtendedPrecision<const NQ: usize, const NC: usize, const NX: usize>:
    Mechanism + Absolute<Self::S, NQ, NC>
{
    /// The mechanism in those numbers.
    type Extended: Absolute<DoubleDouble<Self::S>, NQ, NC>;
    /// Inputs in those numbers.
    type Inputs;
    /// Coordinates of a state: those of a chart, or absolute ones.
    type Coordinates: Coordinates<Self, NQ, NC, NX>;

    /// The mechanism.
    fn extended(&self) -> Self::Extended;

    /// The mechanism and what it holds over a step.
    fn extended_with_inputs(&self, held: &Self::U) -> (Self::Extended, Self::Inputs);

    /// The rate `dx` of a state that satisfies the constraints; not finite where the equations have no solution.
    fn accelerate(
        extended: &Self::Extended,
        t: DoubleDouble<Self::S>,
        u: &Self::Inputs,
        x: &[DoubleDouble<Self::S>; NX],
        dx: &mut [DoubleDouble<Self::S>; NX],
    );

    /// The mechanism has charts, which say themselves whether they are regular.
    #[inline]
    fn is_charted(&self) -> bool {
        Self::Coordinates::is_charted(self)
    }

    /// Has it singular poses at all? A tree of joints has none.
    #[inline]
    fn may_be_singular(&self) -> bool {
        true
    }

    /// The length of a step as a part of the turn next to a flat pose, [`charts::crossed`](crate::charts::crossed).
    #[inline]
    fn crossed(step: &Step<'_, Self>) -> Self::S {
        Self::Coordinates::crossed(step)
    }

    /// True if the mechanism is without a chart.
    #[inline]
    fn is_near(held: &Self::U) -> bool {
        Self::Coordinates::is_near(held)
    }

    /// The state in absolute coordinates.
    fn full(&self, t: Self::S, held: &Self::U, x: &Self::X) -> [Self::S; NX] {
        Self::Coordinates::full(self, t, held, x)
    }

    /// Stores a state in absolute coordinates, without a chart.
    fn hold(&self, held: &mut Self::U, x: &mut Self::X, full: &[Self::S; NX]) {
        Self::Coordinates::hold(self, held, x, full);
    }

    /// The part that closes the loop which is nearest to flat at a state in absolute coordinates.
    fn flat_part(&self, t: Self::S, full: &[Self::S; NX]) -> &'static str {
        Self::Coordinates::flat_part(self, t, full)
    }
}

/// Coordinates of a mechanism that has singular poses: a type without values, chosen with the formulation.
pub trait Coordinates<M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize> {
    /// As [`ExtendedPrecision::is_charted`].
    fn is_charted(system: &M) -> bool;

    /// As [`ExtendedPrecision::crossed`].
    fn crossed(step: &Step<'_, M>) -> M::S;

    /// As [`ExtendedPrecision::is_near`].
    fn is_near(held: &M::U) -> bool;

    /// As [`ExtendedPrecision::full`].
    fn full(system: &M, t: M::S, held: &M::U, x: &M::X) -> [M::S; NX];

    /// As [`ExtendedPrecision::hold`].
    fn hold(system: &M, held: &mut M::U, x: &mut M::X, full: &[M::S; NX]);

    /// As [`ExtendedPrecision::flat_part`].
    fn flat_part(system: &M, t: M::S, full: &[M::S; NX]) -> &'static str;
}
