//! Rows that hold, at position and velocity level: a friction that sticks stays in its place.

use super::multipliers::multipliers;
use super::rows::Rows;
use super::{Contacts, modes::Mode, moved, rows_at};
use crate::scalar::{Real, Scalar};
use crate::system::Drift;
use crate::vector::Vector;

/// Newton's steps for positions.
const MOST_STEPS: u32 = 4;

/// Takes the rates of rows that hold out of the velocities.
pub(super) fn stop<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &mut M::X) {
    let rows = rows_at(system, t, u, x);
    if let Some(impulses) = held(&rows, M::modes(u).of, rows.rate) {
        moved(system, (t, u), x, &impulses);
    }
}

/// Leads rows that hold back to their places, and takes their rates out of the velocities.
pub fn project<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &mut M::X) {
    for _ in 0..MOST_STEPS {
        let rows = rows_at(system, t, u, x);
        let away = away::<M, N>(system, &rows, u);
        if away.iter().all(|z| z.abs() <= M::S::EPSILON * system.length()) {
            break;
        }
        let Some(multipliers) = held(&rows, M::modes(u).of, away) else { break };
        let response = system.response(t, u, x, &multipliers);
        for i in 0..M::NQ {
            x.set(i, x.at(i) + response.at(M::NQ + i));
        }
    }
    stop(system, t, u, x);
}

/// How far the rows that hold are from their places.
pub fn drift<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> Drift<M::S> {
    let rows = rows_at(system, t, u, x);
    let away = away::<M, N>(system, &rows, u);
    let largest = |numbers: &[M::S; N]| numbers.iter().fold(M::S::ZERO, |sum, z| sum.max(z.abs()));
    let rate: [M::S; N] =
        core::array::from_fn(|i| if M::modes(u).of[i].holds() { rows.rate[i] } else { M::S::ZERO });
    Drift { phi: largest(&away), phi_dot: largest(&rate) }
}

/// Displacements of the rows that hold.
fn away<M: Contacts<N>, const N: usize>(system: &M, rows: &Rows<M::S, N>, u: &M::U) -> [M::S; N] {
    let modes = M::modes(u);
    core::array::from_fn(|i| match modes.of[i] {
        Mode::Closed if system.law(i).is_unilateral() => rows.gap[i],
        Mode::Sticks => rows.gap[i] - modes.place[i],
        _ => M::S::ZERO,
    })
}

/// Multipliers that take `away` out of the rows that hold, by those rows alone.
fn held<S: Real, const N: usize>(rows: &Rows<S, N>, modes: [Mode; N], away: [S; N]) -> Option<[S; N]> {
    let only = modes.map(|mode| if mode.holds() { mode } else { Mode::Open });
    let problem = Rows { free: away, ..*rows };
    multipliers(&problem, &only).map(|found| found.lambda)
}
