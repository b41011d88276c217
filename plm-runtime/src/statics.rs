//! A mechanism at rest: what must vanish at an equilibrium, in absolute coordinates for every formulation.

use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::start::StartValues;
use crate::system::Rate;
use crate::vector::Vector;

/// The equations of a mechanism as they are before it is solved for accelerations; implemented by generated code.
pub trait Statics: Mechanism {
    /// A state in absolute coordinates: [q, v, first-order states], SI units, one after the other; unused room at the
    /// end is zero.
    type Full: Vector<<Self as Rate>::S>;
    /// A number for each constraint row.
    type Rows: Vector<<Self as Rate>::S>;
    /// The start values.
    type Starts: StartValues<<Self as Rate>::S>;

    /// Name of each coordinate, as `arm.x`, `arm.angle`: three for each body.
    const COORDINATES: &'static [&'static str];
    /// Name of each constraint row, as `shoulder.x`.
    const ROWS: &'static [&'static str];
    /// Name of each first-order state, and its SI unit.
    const STATES: &'static [(&'static str, &'static str)];

    /// Name of each coordinate: [`COORDINATES`](Self::COORDINATES), or those of a mechanism whose type has none, as one from text.
    #[inline]
    fn coordinate_names(&self) -> &'static [&'static str] {
        Self::COORDINATES
    }

    /// Name of each constraint row.
    #[inline]
    fn row_names(&self) -> &'static [&'static str] {
        Self::ROWS
    }

    /// Name of each first-order state, and its SI unit.
    #[inline]
    fn state_names(&self) -> &'static [(&'static str, &'static str)] {
        Self::STATES
    }

    /// The state of a moment in absolute coordinates, angles including all revolutions.
    fn full(state: &Self::State) -> Self::Full;

    /// Gives `each` in turn: the forces phi_q^T lambda - Q (N, N, N m per body), phi, phi_q v - nu, and the rates of the
    /// first-order states; then the displacements of rows of contact, whose forces are the multipliers in `held`, and the largest force of
    /// each to either side. Accelerations are taken as zero if forces or rates read them. The angles of `x` include all
    /// revolutions, so that `u` counts none.
    fn equations(
        &self,
        t: Self::S,
        held: &Self::U,
        x: &Self::Full,
        lambda: &Self::Rows,
        each: &mut impl FnMut(Self::S),
    );

    /// The multipliers of rows of contact in the discrete state: contact forces and frictions, N or N m.
    fn multipliers(held: &mut Self::U) -> &mut [Self::S] {
        let _ = held;
        &mut []
    }

    /// The assembled state at the time `t` as of [`start_state`](Mechanism::start_state), with the inputs of `held` in place of
    /// those that are declared.
    ///
    /// # Errors
    /// As those of [`start_state`](Mechanism::start_state).
    fn start_with_inputs(&self, t: Self::S, held: &Self::U) -> Result<(Self::U, Self::X), Fault>;

    /// Discrete state before assembly: the inputs as declared, every condition on one side, no revolutions, the first chart without
    /// continuation data. A saved run is read into it.
    fn unstarted(&self) -> Self::U;

    /// The start values as they are set: those of each body (x, y, angle, vx, vy, omega), then first-order states.
    fn starts_mut(&mut self) -> &mut Self::Starts;

    /// The start values as declared, those that read parameters with the parameters as they are; where none does, as they are
    /// set.
    fn declared_starts(&self) -> Self::Starts {
        let mut own = *self;
        *own.starts_mut()
    }

    /// Start values that lead to a state; locks stay as they are set.
    fn starts_at(&self, x: &Self::Full) -> Self::Starts;

    /// Size of the mechanism, m.
    fn size(&self) -> Self::S;
}
