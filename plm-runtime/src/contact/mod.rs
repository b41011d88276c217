//! Friction and unilateral contact: set-valued laws, in modes that are constant during a step and change at events.
//!
//! A unilateral row has a gap z >= 0 and a contact force lambda >= 0, one of which is zero. A friction row has a rate, and a force within
//! limits against it. In given modes the rows that touch and stick are constraints, and those that slip have known forces, so that a step
//! is smooth. At an event impacts are solved, and the next modes follow from all inequalities (F. Pfeiffer, Ch. Glocker, Multibody
//! Dynamics with Unilateral Contacts, 1996; V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008).
//!
//! A system implements [`Contacts`], and its contracts call the functions of this module: [`rate`], [`guards`], [`guards_within`],
//! [`switch`], [`switch_after`], [`state_was_set`], [`update`], [`update_after`], [`project`], [`drift`], [`begin`]. Steps of fixed length
//! without events are made by [`step`].

mod booked;
mod bounds;
mod candidates;
mod changed;
mod choose;
mod constants;
mod driven;
mod enclosed;
mod event;
mod flights;
mod guards;
mod held;
mod impact;
mod kinematics;
mod loads;
mod marginal;
mod margins;
mod modes;
mod multipliers;
mod outcome;
mod paradox;
mod pivots;
mod project;
#[cfg(test)]
mod random;
mod rows;
mod scales;
mod signs;
mod sliding;
mod status;
mod stepping;
mod strikes;
mod sunk;
mod walk;

pub use self::booked::{Booked, ImpactEnergy, Impulse};
pub use self::changed::state_was_set;
pub use self::constants::Constants;
pub use self::event::{begin, switch, switch_after, update, update_after};
pub use self::guards::{guards, guards_within, stay};
pub use self::held::{Held, Modal};
pub use self::impact::{Doubts, ImpactLaw};
pub use self::kinematics::Kinematics;
pub use self::loads::{Affine, Load};
pub use self::margins::{PER_ROW, guard_count};
pub use self::modes::{Change, Mode, Modes};
pub use self::outcome::Outcome;
pub use self::project::{drift, held_rows, project};
pub use self::rows::{Friction, Law, Limit, Rows};
pub use self::sliding::{slide, slipping};
pub use self::status::{Counts, Status};
pub use self::stepping::{
    Motion, Proposed, Solution, Stride, packed_steps, smooth_step, smooth_stride, step,
};
pub use self::sunk::appear;
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, Health, Rate, System};
use crate::vector::Vector;

/// Roundings within which free accelerations and those of contact forces balance.
const BALANCE_ULPS: f64 = 32.0;

/// A system with `N` contact rows. Its discrete state has their [`Modes`].
pub trait Contacts<const N: usize>: System<S: Real, U: Modal<<Self as Rate>::S, N>> {
    /// Law of a row.
    fn law(&self, row: usize) -> Law<Self::S>;

    /// Gaps, rates, free accelerations, D and limits of all rows, in any type of numbers: time and state are given in it, and `constant`
    /// converts a parameter or an input. Of the modes the rows read only the signs of reactions.
    fn rows<T: Scalar>(
        &self,
        t: T,
        u: &Self::U,
        x: &impl Fn(usize) -> T,
        constant: &impl Fn(Self::S) -> T,
    ) -> Rows<T, N>;

    /// True if a row exists. Otherwise its gap is open, and its friction off.
    fn exists(&self, u: &Self::U, row: usize) -> bool {
        let _ = (u, row);
        true
    }

    /// True if only contact forces bound a friction, so that it is off without them.
    fn is_bounded_by_pushes(&self, row: usize) -> bool {
        let _ = row;
        false
    }

    /// True if the bound of a friction may become negative with the state or the time. It is then checked within steps.
    fn bound_may_fall(&self, row: usize) -> bool {
        let _ = row;
        false
    }

    /// The rows in the numbers of the system.
    fn rows_at(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Rows<Self::S, N> {
        self.rows(t, u, &|i| x.at(i), &|number| number)
    }

    /// Quantities of the rows that need no forces, as [`rows`](Self::rows) gives them.
    fn kinematics<T: Scalar>(
        &self,
        t: T,
        u: &Self::U,
        x: &impl Fn(usize) -> T,
        constant: &impl Fn(Self::S) -> T,
    ) -> Kinematics<T, N> {
        Kinematics::of(&self.rows(t, u, x, constant))
    }

    /// Kinematics in the numbers of the system.
    fn kinematics_at(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Kinematics<Self::S, N> {
        Kinematics::of(&self.rows_at(t, u, x))
    }

    /// Sizes of the reactions along a line that bound rows, by the index of the reaction and with the sign of the present modes, if every
    /// row with a force slips. `None` if they have to come from [`rows`](Self::rows).
    fn sliding(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Option<[Self::S; N]> {
        let _ = (t, u, x);
        None
    }

    /// The rate of the state without contact forces.
    fn free_rate(&self, t: Self::S, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> Health<Self::S>;

    /// Change of the rate by contact forces: M^-1 W^T lambda in the places of the velocities, zero elsewhere.
    fn response(&self, t: Self::S, u: &Self::U, x: &Self::X, lambda: &[Self::S; N]) -> Self::X;

    /// Motion and rows at a state, for steps that need all of them.
    fn motion_at(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Motion<Self::S, Self::X, N> {
        let mut rate = *x;
        let health = self.free_rate(t, u, x, &mut rate);
        let one = |j: usize| Vector::from_fn(|i| Self::S::lit(if i == j { 1.0 } else { 0.0 }));
        let responses = core::array::from_fn(|j| self.response(t, u, x, &one(j)));
        Motion { rate, responses, rows: self.rows_at(t, u, x), health }
    }

    /// The rate with these multipliers, if it is not affine in them; otherwise `None`.
    fn rate_with_forces(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        lambda: &[Self::S; N],
    ) -> Option<Self::X> {
        let _ = (t, u, x, lambda);
        None
    }

    /// True if time alone moves rows, or joints that they read. Otherwise rates are zero where velocities are.
    fn moves_by_time(&self) -> bool {
        true
    }

    /// The law of impact.
    fn impact_law(&self) -> ImpactLaw {
        ImpactLaw::default()
    }

    /// A length of the mechanism, m; tolerances of gaps are fractions of it.
    fn length(&self) -> Self::S {
        Self::S::lit(1.0)
    }

    /// Projects the state onto the constraints of the joints, if there are any.
    ///
    /// # Errors
    /// When the projection does not converge.
    fn project_joints(&self, t: Self::S, u: &Self::U, x: &mut Self::X) -> Result<(), Fault> {
        let _ = (t, u, x);
        Ok(())
    }

    /// Violation of the constraints of the joints.
    fn drift_of_joints(&self, t: Self::S, u: &Self::U, x: &Self::X) -> Drift<Self::S> {
        let _ = (t, u, x);
        Drift { phi: Self::S::ZERO, phi_dot: Self::S::ZERO }
    }
}

/// True if steps decide the modes, so that rows have no events. Near singular poses, which steps leave to another method, rows have
/// events.
fn change_in_steps<M: Contacts<N>, const N: usize>(system: &M, u: &M::U) -> bool {
    u.modes().change == Change::InSteps && system.is_regular(u)
}

/// Multipliers at a state in the present modes: contact forces and frictions, N or N m. NaN if they are not unique.
pub fn reactions<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> [M::S; N] {
    lambda_of(&system.rows_at(t, u, x), u.modes())
}

/// Multipliers in the present modes; NaN if they are not unique.
fn lambda_of<T: Scalar, const N: usize>(rows: &Rows<T, N>, modes: &Modes<T, N>) -> [T; N] {
    let found = multipliers::multipliers_of_rate(rows, &modes.of);
    found.map_or([T::lit(f64::NAN); N], |found| found.lambda)
}

/// The rate with the contact forces of the present modes, for [`Rate::rate`].
pub fn rate<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &M::X,
    dx: &mut M::X,
) -> Health<M::S> {
    let health = system.free_rate(t, u, x, dx);
    let lambda = without_noise(&system.rows_at(t, u, x), u.modes());
    let response = |lambda: &[M::S; N]| system.response(t, u, x, lambda);
    dx.add([(M::S::lit(1.0), &response(&lambda))]);
    balance(dx, &lambda, response);
    health
}

/// The discrete state with the multipliers in the present modes, as a generated rate needs it. They are NaN if they are not unique.
#[must_use]
pub fn with_multipliers<T: Scalar, const N: usize>(rows: &Rows<T, N>, held: &Held<T, N>) -> Held<T, N> {
    Held { lambda: without_noise(rows, &held.modes), ..*held }
}

/// The multipliers, with those set to zero that are rounding of the others: lambda_i sqrt(D_ii) has one unit in all rows.
fn without_noise<T: Scalar, const N: usize>(rows: &Rows<T, N>, modes: &Modes<T, N>) -> [T; N] {
    // Forces of rows that slip follow from their limits.
    if !modes.hold() {
        return multipliers::sliding(rows, &modes.of).unwrap_or_else(|| lambda_of(rows, modes));
    }
    let lambda = lambda_of(rows, modes);
    let sizes: [T; N] = Vector::from_fn(|i| lambda[i].abs() * rows.delassus[i][i].sqrt());
    let largest = sizes.iter().fold(T::ZERO, |largest, size| largest.max(*size));
    let least = T::lit(BALANCE_ULPS * T::PRECISION) * largest;
    // NaN stays NaN.
    Vector::from_fn(|i| T::select(sizes[i].lt(least), lambda[i].as_zero(), lambda[i]))
}

/// Adds the contact forces to the rate without them, for a generated mechanism: `responses` has the change of the rate by each unit
/// multiplier. Accelerations that are rounding are set to zero, so that constraint rows stay where they are.
pub fn add_forces<T: Scalar, X: Vector<T>, const N: usize>(
    dx: &mut X,
    rows: &Rows<T, N>,
    held: &Held<T, N>,
    responses: &[X; N],
) {
    let lambda = without_noise(rows, &held.modes);
    *dx = dx.map2(&sum_of(responses, &lambda), |free, response| free + response);
    if held.modes.hold() {
        balance(dx, &lambda, |lambda| sum_of(responses, lambda));
    }
}

/// Response to these multipliers.
pub fn sum_of<T: Scalar, X: Vector<T>, const N: usize>(responses: &[X; N], lambda: &[T; N]) -> X {
    X::from_fn(|i| {
        let terms = responses.iter().zip(lambda);
        terms.fold(T::ZERO, |sum, (response, lambda)| response.at(i).mul_add(*lambda, sum))
    })
}

/// Sets accelerations to zero that are rounding in a rate which a generated mechanism has computed with these multipliers, so that
/// constraint rows stay where they are. `response` gives the change of the rate by multipliers.
pub fn settle<T: Scalar, X: Vector<T>, const N: usize>(
    dx: &mut X,
    held: &Held<T, N>,
    response: impl FnOnce(&[T; N]) -> X,
) {
    if held.modes.hold() {
        balance(dx, &held.lambda, response);
    }
}

/// Sets accelerations to zero that are rounding of the part which contact forces add. Forces may balance each other, so that their sum
/// does not tell their size; a sum with weights does.
fn balance<T: Scalar, X: Vector<T>, const N: usize>(
    dx: &mut X,
    lambda: &[T; N],
    response: impl FnOnce(&[T; N]) -> X,
) {
    let weighted = Vector::from_fn(|i| T::lit(1.0 + apart(i)) * lambda[i]);
    *dx = dx.map2(&response(&weighted), |sum, size| balanced(sum, size.abs()));
}

/// A number from 0 to 1, far from that of others: the fractions of multiples of the golden ratio lie far apart.
fn apart(number: usize) -> f64 {
    let multiple = number as f64 * 0.618_033_988_749_894_9;
    multiple - f64::from(multiple as u32)
}

/// An acceleration; zero if it is rounding of contact forces of this size.
fn balanced<T: Scalar>(sum: T, size: T) -> T {
    let none = T::lit(BALANCE_ULPS * T::PRECISION) * size;
    T::select(sum.abs().lt(none), sum.as_zero(), sum)
}

/// Adds the response to impulses to the velocities.
fn moved<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u): (M::S, &M::U),
    x: &mut M::X,
    impulses: &[M::S; N],
) {
    let response = system.response(t, u, x, impulses);
    x.add([(M::S::lit(1.0), &response)]);
}
