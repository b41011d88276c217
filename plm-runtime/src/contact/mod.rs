//! Friction and unilateral contact: set-valued laws, held over a step in modes and changed at events.
//!
//! A unilateral row has a gap z >= 0 and a push lambda >= 0, one of which is zero. A friction row has a rate, and a force within limits
//! against it. In given modes the rows that touch and stick are constraints, those that slip have known forces; so a step is smooth. At an
//! event impacts are solved, and the next modes follow from all inequalities (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with
//! Unilateral Contacts, 1996; V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008).
//!
//! A system has [`Contacts`], and its contracts call the functions of this module: [`rate`], [`guards`], [`guards_within`], [`switch`],
//! [`project`], [`drift`], [`begin`].

mod candidates;
mod event;
mod impact;
mod margins;
mod modes;
mod multipliers;
mod project;
mod rows;

pub use self::event::{Outcome, begin, guards, switch};
pub use self::impact::ImpactLaw;
pub use self::margins::{PER_ROW, guard_count};
pub use self::modes::{Mode, Modes};
pub use self::project::{drift, project};
pub use self::rows::{Friction, Law, Limit, Rows};
use crate::enclosure::Enclosed;
use crate::scalar::{Real, Scalar};
use crate::system::{Health, Rate};
use crate::vector::Vector;

/// Free accelerations and those of contact forces balance within so many roundings.
const BALANCE_ULPS: f64 = 32.0;

/// A system with `N` contact rows.
pub trait Contacts<const N: usize>: Rate<S: Real> {
    /// What a row says.
    fn law(&self, row: usize) -> Law<Self::S>;

    /// Gaps, rates, free accelerations, D and limits of all rows, in any numbers: time and state are given in them.
    fn rows<T: Scalar>(&self, t: T, u: &Self::U, x: &impl Fn(usize) -> T) -> Rows<T, N>;

    /// The rate of the state without contact forces.
    fn free_rate(&self, t: Self::S, u: &Self::U, x: &Self::X, dx: &mut Self::X) -> Health<Self::S>;

    /// What contact forces add to the rate: M^-1 W^T lambda in the places of the velocities, zero elsewhere.
    fn response(&self, t: Self::S, u: &Self::U, x: &Self::X, lambda: &[Self::S; N]) -> Self::X;

    /// The modes in the discrete state.
    fn modes(u: &Self::U) -> &Modes<Self::S, N>;

    /// The modes in the discrete state, to be changed.
    fn modes_mut(u: &mut Self::U) -> &mut Modes<Self::S, N>;

    /// The law of impact.
    fn impact_law(&self) -> ImpactLaw {
        ImpactLaw::default()
    }

    /// A length of the mechanism, m: tolerances of gaps are fractions of it.
    fn length(&self) -> Self::S {
        Self::S::lit(1.0)
    }

    /// The name of a row, for faults.
    fn row_name(&self, row: usize) -> &'static str {
        let _ = row;
        ""
    }
}

/// The rows at a state.
pub fn rows_at<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> Rows<M::S, N> {
    system.rows(t, u, &|i| x.at(i))
}

/// The multipliers at a state in the modes held: pushes and frictions, N or N m. Not a number where they are not unique.
pub fn reactions<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> [M::S; N] {
    lambda_of(&rows_at(system, t, u, x), M::modes(u))
}

/// The multipliers in the modes held; not a number where they are not unique.
fn lambda_of<S: Real, const N: usize>(rows: &Rows<S, N>, modes: &Modes<S, N>) -> [S; N] {
    let found = multipliers::multipliers(rows, &modes.of);
    found.map_or([S::lit(f64::NAN); N], |found| found.lambda)
}

/// The rate with the contact forces of the modes held, for [`Rate::rate`].
pub fn rate<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &M::X,
    dx: &mut M::X,
) -> Health<M::S> {
    let health = system.free_rate(t, u, x, dx);
    let response = system.response(t, u, x, &without_noise(system, t, u, x));
    *dx = dx.map2(&response, balanced);
    health
}

/// The multipliers, without those that are rounding of the others: lambda_i sqrt(D_ii) has the same unit in every row.
fn without_noise<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> [M::S; N] {
    let rows = rows_at(system, t, u, x);
    let lambda = lambda_of(&rows, M::modes(u));
    let sizes: [M::S; N] = core::array::from_fn(|i| lambda[i].abs() * rows.delassus[i][i].sqrt());
    let least = sizes.iter().fold(M::S::ZERO, |largest, size| largest.max(*size));
    let least = M::S::lit(BALANCE_ULPS) * M::S::EPSILON * least;
    core::array::from_fn(|i| if sizes[i] <= least { M::S::ZERO } else { lambda[i] })
}

/// The sum of two accelerations; zero where they balance but for rounding, so that what is held stays where it is.
fn balanced<S: Real>(free: S, response: S) -> S {
    let sum = free + response;
    if sum.abs() <= S::lit(BALANCE_ULPS) * S::EPSILON * response.abs() { S::ZERO } else { sum }
}

/// Guards over an interval, for [`Events::guards_within`](crate::Events::guards_within).
pub fn guards_within<M: Contacts<N>, const N: usize>(
    system: &M,
    t: Enclosed<M::S>,
    u: &M::U,
    x: &impl Fn(usize) -> Enclosed<M::S>,
    each: &mut impl FnMut(usize, Enclosed<M::S>),
) -> bool {
    let modes = M::modes(u);
    margins::margins(&system.rows(t, u, x), (modes, Enclosed::constant(modes.orientation)), each)
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
