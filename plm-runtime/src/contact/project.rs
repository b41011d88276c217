//! Projection onto constraint rows, for positions and velocities; a friction that sticks stays in its place.

use super::modes::{Change, Mode};
use super::multipliers::{Multipliers, multipliers};
use super::rows::{Friction, Limit, Rows, below, indices};
use super::{Contacts, Modal, moved};
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::Drift;
use crate::vector::Vector;

/// Most Newton steps for positions.
const MOST_STEPS: u32 = 4;
/// Drift of the joints that a step may leave, as a fraction of the typical coordinate and velocity; at least the resolution of the
/// scalar.
const DRIFT: f64 = 1e-10;

/// Removes the rates of constraint rows from the velocities; `rows` are those of the state.
pub(super) fn stop<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u, rows): (M::S, &M::U, &Rows<M::S, N>),
    x: &mut M::X,
) {
    if let Some(impulses) = held(rows, u.modes().of, rows.rate) {
        moved(system, (t, u), x, &impulses);
    }
}

/// Removes the rates of constraint rows from the velocities after an event, by impulses with their share of friction: such a rate comes
/// from flights that are ignored, under whose contact forces slipping rows have friction. `rows` are those of the state.
pub(super) fn end_flights<M: Contacts<N>, const N: usize>(
    system: &M,
    (t, u, rows): (M::S, &M::U, &Rows<M::S, N>),
    x: &mut M::X,
) {
    let modes = &u.modes().of;
    let Some(Multipliers { lambda, .. }) = multipliers(rows, modes) else { return };
    let mut problem = Rows { free: rows.rate, ..*rows };
    // The size of a reaction changes along the reaction.
    let directions = rows.directions(&lambda, |_| true);
    for row in 0..N {
        let Friction { lower, upper } = &mut problem.kinetic[row];
        for limit in [lower, upper] {
            *limit = Limit { by: rows.along(row, limit, &directions).by, ..Limit::none() };
        }
    }
    if let Some(impulses) = multipliers(&problem, modes) {
        moved(system, (t, u), x, &impulses.lambda);
    }
}

/// Rates of the rows after the gaps at rest have lost theirs; the present rates if these gaps depend on each other.
pub(super) fn after_flights<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    rests: impl Fn(usize) -> bool,
) -> [S; N] {
    let modes = core::array::from_fn(|i| if rests(i) { Mode::Closed } else { Mode::Open });
    let Some(taken) = held(rows, modes, rows.rate) else { return rows.rate };
    let left = Rows { free: rows.rate, ..*rows };
    core::array::from_fn(|i| left.acceleration(i, &taken))
}

/// Projects the joints, returns constraint rows to their places, and removes their rates from the velocities.
///
/// # Errors
/// Those of [`Contacts::project_joints`].
pub fn project<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &mut M::X,
) -> Result<(), Fault> {
    let mut steps = 0;
    loop {
        system.project_joints(t, u, x)?;
        if !u.modes().hold() {
            return Ok(());
        }
        let rows = system.rows_at(t, u, x);
        let away = away::<M, N>(&rows.gap, u);
        let are_near = away.iter().all(|z| z.abs() <= M::S::EPSILON * system.length());
        let multipliers =
            if are_near || steps == MOST_STEPS { None } else { held(&rows, u.modes().of, away) };
        let Some(multipliers) = multipliers else {
            stop(system, (t, u, &rows), x);
            return Ok(());
        };
        let response = system.response(t, u, x, &multipliers);
        for i in 0..M::NQ {
            x.set(i, x.at(i) + response.at(M::NQ + i));
        }
        steps += 1;
    }
}

/// Projects the joints if they have drifted, after a step that has returned the constraint rows itself.
///
/// # Errors
/// Those of [`Contacts::project_joints`].
pub(super) fn joints_after_step<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &mut M::X,
) -> Result<(), Fault> {
    let drift = system.drift_of_joints(t, u, x);
    let (typical, tolerance) = (system.typical(), M::S::lit(DRIFT).max(M::S::lit(64.0) * M::S::EPSILON));
    let largest = |from: usize| (from..from + M::NQ).fold(M::S::ZERO, |size, i| typical.at(i).max(size));
    // False for NaN.
    let is_near = drift.phi <= tolerance * largest(0) && drift.phi_dot <= tolerance * largest(M::NQ);
    if is_near { Ok(()) } else { system.project_joints(t, u, x) }
}

/// Drift of the joints, and of the constraint rows from their places: the larger of both.
pub fn drift<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> Drift<M::S> {
    let joints = system.drift_of_joints(t, u, x);
    if !u.modes().hold() {
        return joints;
    }
    let rows = system.kinematics_at(t, u, x);
    let away = away::<M, N>(&rows.gap, u);
    let largest = |least: M::S, numbers: &[M::S; N]| numbers.iter().fold(least, |sum, z| sum.max(z.abs()));
    let rate: [M::S; N] =
        Vector::from_fn(|i| if u.modes().of[i].holds() { rows.rate[i] } else { M::S::ZERO });
    Drift { phi: largest(joints.phi, &away), phi_dot: largest(joints.phi_dot, &rate) }
}

/// Gives `row` the displacement and the rate of each constraint row, for [`Linear::held_rows`](crate::Linear::held_rows). Frictions that
/// stick are left out if their modes change where the state is set.
pub fn held_rows<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &M::X,
    row: &mut impl FnMut(M::S),
) {
    let rows = system.kinematics_at(t, u, x);
    let away = away::<M, N>(&rows.gap, u);
    let is_let_go = |mode: Mode| mode == Mode::Sticks && u.modes().change == Change::WhereSet;
    let holds = |i: &usize| u.modes().of[*i].holds() && !is_let_go(u.modes().of[*i]);
    for i in indices::<N>().filter(holds).map(below::<N>) {
        row(away[i]);
        row(rows.rate[i]);
    }
}

/// Displacements of the constraint rows from their places.
fn away<M: Contacts<N>, const N: usize>(gap: &[M::S; N], u: &M::U) -> [M::S; N] {
    let modes = u.modes();
    core::array::from_fn(|i| match modes.of[i] {
        Mode::Closed => gap[i],
        Mode::Sticks => gap[i] - modes.place[i],
        _ => M::S::ZERO,
    })
}

/// Multipliers that remove `away` from the constraint rows, by those rows alone.
fn held<S: Real, const N: usize>(rows: &Rows<S, N>, modes: [Mode; N], away: [S; N]) -> Option<[S; N]> {
    let only = modes.map(|mode| if mode.holds() { mode } else { Mode::Open });
    let problem = Rows { free: away, ..*rows };
    multipliers(&problem, &only).map(|found| found.lambda)
}
