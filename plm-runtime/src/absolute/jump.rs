//! Rows whose two sides differ at the boundary of a condition in them: their value would have to jump.

use super::Absolute;
use super::scale::Scale;
use crate::fault::{Cause, Fault};
use crate::scalar::Real;

/// A jump below this part of the size of the scene, or of its speed, is the error with which the boundary was located.
const FOUND: f64 = 1e-6;
/// A step that failed this near before a boundary, in s and as a part of the time, counts as failed at the boundary.
const NEAR: f64 = 1e-6;

/// A row at the boundary of a condition in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<S> {
    /// The row's index.
    pub row: usize,
    /// The value of phi on one side less that on the other, its first and its second derivative along the motion; what
    /// vanishes on the boundary, and its derivative.
    pub terms: [S; 5],
    /// True if its condition changes now; false if the boundary is only checked for being near.
    pub changes: bool,
}

/// The first jump of a place, or else of a speed, among crossings at the pose `q` and velocity `v`.
///
/// A method without dense output steps past a boundary, so that differences are taken back to it to first order.
#[cold]
pub fn jump<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (q, v): (&[S; NQ], &[S; NQ]),
    crossings: impl Iterator<Item = Crossing<S>>,
) -> Option<Fault> {
    let found = S::lit(FOUND).max(S::RANK_TOLERANCE);
    let (place, speed) = (Scale::of_position(m, q), Scale::of_velocity(m, q, v));
    let near = S::lit(NEAR) * (S::lit(1.0) + t.abs());
    let mut of_speed = None;
    for Crossing { row, terms: [gap, rate, bend, distance, along], changes } in crossings {
        let since = distance / along;
        let since = if since.is_finite() { since } else { S::lit(0.0) };
        let angular = m.layout().is_angular(row);
        if !changes && since.abs() > near {
            continue;
        }
        let fault = |by: S, speed: bool| {
            let part = m.layout().rows.get(row).copied().unwrap_or_default();
            Some(Fault::of_part(t.to_f64(), part, Cause::Jump { by: by.to_f64(), angular, speed }))
        };
        let (gap, rate) = ((gap - rate * since).abs(), (rate - bend * since).abs());
        if gap > found * place.size(angular) {
            return fault(gap, false);
        }
        if of_speed.is_none() && rate > found * speed.size(angular) {
            of_speed = fault(rate, true);
        }
    }
    of_speed
}
