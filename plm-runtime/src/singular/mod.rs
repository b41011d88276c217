//! Near-singular poses: how a mechanism goes on if its own coordinates are not regular.
//!
//! If every chart of a mechanism is poor, the constraints alone determine how it moves. It goes on in absolute coordinates, with every
//! state projected onto the constraints before its rate is computed, in double-double numbers (`equations`): the rate is then a smooth
//! function of the state however near a singular pose is.
//!
//! The distance to it follows from the smallest pivot of `phi_q M^-1 phi_q^T`. Along the motion that is `c + k (s - s0)^2` (`distance`):
//!
//! * Away from zero, the pose is passed by: steps follow the turn, which takes place over a length of `sqrt(c / k)`.
//! * Where `c` vanishes, the rank of `phi_q` does too (A. Mueller, Higher derivatives of the kinematic mapping and some
//!   applications, Mech. Mach. Theory 76, 2014, on the branches that meet there). The motion through it is analytic; a step by
//!   collocation leads over the pose, with nodes on both sides of it (`crossing`).
//!
//! The lengths decide if `c` vanishes (`critical`): the singular pose is the critical point of a combination of constraints, and its value
//! there the difference of lengths by which it is missed. Within their rounding the joints are closed to the pose (`meeting`); else it is
//! passed by. If a row prescribes a motion, that value changes with the time, and at its zero the motion ends (`lock`). If no such pose is
//! found, the gap that the polynomial of a step over it leaves in the joints decides.

mod collocation;
mod combined;
mod conditioning;
mod coordinates;
mod critical;
mod crossing;
mod distance;
mod equations;
mod here;
mod limit;
mod lock;
mod meeting;
mod near_singular;
mod start;

pub use self::coordinates::{ByMechanism, Coordinates, InAbsolute, InCharts};
pub use self::near_singular::NearSingular;
pub use self::start::refine;

use crate::Absolute;
use crate::double_double::DoubleDouble;
use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::method::{Context, DenseOutput, ErrorControl, FixedLength, Length, Method};
pub use crate::protocol::{Nearness, Rescue};
use crate::scalar::Real;
use crate::system::{Drift, Step};

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

/// For mechanisms that have no singular poses.
#[derive(Clone, Copy, Debug)]
pub struct Never<M>(core::marker::PhantomData<M>);

impl<M: Mechanism> Rescue<M> for Never<M> {
    const POSSIBLE: bool = false;

    fn new() -> Self {
        Self(core::marker::PhantomData)
    }
    #[inline]
    fn holds(_context: &Context<'_, M>) -> bool {
        false
    }
    #[inline]
    fn nearness(_step: &Step<'_, M>, _length: Length) -> Nearness {
        Nearness::Regular
    }
    fn take(_context: &mut Context<'_, M>) -> bool {
        false
    }
    fn passed(&self) -> Option<&'static str> {
        None
    }
    fn followed(&self) -> Option<M::S> {
        None
    }
}

impl<M: Mechanism> Method<M> for Never<M> {
    fn advance(&mut self, _context: &mut Context<'_, M>) -> Result<(), Fault> {
        Ok(())
    }
    fn restart(&mut self) {}
    fn fresh(&self) -> Self {
        *self
    }
    fn drift_limit(&self, _system: &M) -> Drift<M::S> {
        Drift { phi: M::S::INFINITY, phi_dot: M::S::INFINITY }
    }
}

impl<M: Mechanism> DenseOutput<M> for Never<M> {}

impl<M: Mechanism> ErrorControl<M> for Never<M> {}

impl<M: Mechanism> FixedLength<M> for Never<M> {}

/// The largest number of a vector over its typical size.
fn size<S: Real, const N: usize>(numbers: &[S; N], typical: impl Fn(usize) -> S) -> S {
    let mut largest = S::ZERO;
    for (i, number) in numbers.iter().enumerate() {
        largest = largest.max((*number / typical(i)).abs());
    }
    largest
}
