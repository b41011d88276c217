//! Projection of a state onto position and velocity constraints.

use super::newton::{projection_step, refused};
use super::{Absolute, Layout, join, split};
use crate::fault::{Cause, Fault};
use crate::linalg::largest;
use crate::scalar::Real;
use crate::system::Drift;
use crate::tolerances::closed;
use crate::vector::Vector;

/// Newton steps and velocity corrections that are enough from any drift worth projecting.
pub(super) const ITERATIONS: u32 = 12;

/// Moves `q`, then `v`, onto phi = 0 and phi_q v = nu by the shortest way in the metric of the masses, so that no
/// motion is added (E. Eich, Convergence results for a coordinate projection method, SIAM J. Numer. Anal. 30, 1993).
///
/// Both residuals are brought down to rounding.
///
/// # Errors
/// [`Cause::Drift`] if they stay above 1e-10 of the mechanism's size (and speed), [`Cause::Workspace`].
pub fn project<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &mut [S; NQ],
    v: &mut [S; NQ],
) -> Result<(), Fault> {
    let w = m.inverse_mass();
    let length = m.length().max(largest(q));
    let phi = descend(rounding(length), q, |q| m.phi(t, q), |q, r| projection_step(m, t, q, &w, r));
    let speed = largest(v).max(S::lit(1.0)) * length.max(S::lit(1.0));
    let phi_dot = descend(rounding(speed), v, |v| m.phi_dot(t, q, v), |_, r| projection_step(m, t, q, &w, r));
    for (violation, size) in [(&phi, length), (&phi_dot, speed)] {
        if !is_closed(violation, size) {
            let part = widest(violation, m.layout());
            let (phi, phi_dot) = (largest(&phi).to_f64(), largest(&phi_dot).to_f64());
            let drift = Fault::of_part(t.to_f64(), part, Cause::Drift { phi, phi_dot });
            return Err(refused(m, (t, q), &w).unwrap_or(drift));
        }
    }
    Ok(())
}

/// [`project`] for a state [q, v, first-order states].
///
/// # Errors
/// As [`project`].
pub fn project_state<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize, const NX: usize>(
    m: &M,
    t: S,
    x: &mut [S; NX],
) -> Result<(), Fault> {
    let (mut q, mut v) = split(x);
    project(m, t, &mut q, &mut v)?;
    join(&q, &v, x);
    Ok(())
}

/// Largest residuals of a state [q, v, first-order states].
#[inline]
pub fn drift<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize, const NX: usize>(
    m: &M,
    t: S,
    x: &[S; NX],
) -> Drift<S> {
    let (q, v) = split(x);
    opening(m, t, &q, &v)
}

/// Largest residuals of a pose and velocity.
#[inline]
pub fn opening<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    v: &[S; NQ],
) -> Drift<S> {
    Drift { phi: largest(&m.phi(t, q)), phi_dot: largest(&m.phi_dot(t, q, v)) }
}

/// Gives `row` the residuals of position, then those of velocity, of a state [q, v, first-order states].
pub fn residuals<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize, const NX: usize>(
    m: &M,
    t: S,
    x: &[S; NX],
    row: &mut impl FnMut(S),
) {
    let (q, v) = split(x);
    m.phi(t, &q).into_iter().chain(m.phi_dot(t, &q, &v)).for_each(row);
}

/// Residual of the force balance with the multipliers `lambda`: phi_q^T lambda - Q.
pub fn balance<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    lambda: &[S; NC],
    force: &[S; NQ],
) -> [S; NQ] {
    let mut left = force.map(|force| -force);
    m.phi_q(t, q, &mut |row, column, entry| {
        left.set(column, lambda.at(row).mul_add(entry, left.at(column)));
    });
    left
}

/// Is the violation small enough for joints of the given size (m, or m/s) to count as closed?
pub(super) fn is_closed<S: Real, const NC: usize>(violation: &[S; NC], size: S) -> bool {
    largest(violation) <= closed::<S>() * size.max(S::lit(1.0))
}

/// The name that belongs to the largest violation.
pub(super) fn widest<S: Real, const NC: usize>(violation: &[S; NC], layout: &Layout) -> &'static str {
    let mut widest = ("", S::lit(-1.0));
    for (r, name) in violation.iter().zip(layout.parts) {
        let size = if r.is_finite() { r.abs() } else { S::INFINITY };
        if size > widest.1 {
            widest = (name, size);
        }
    }
    widest.0
}

/// Bound below which residuals are rounding of numbers of the given size, and the measure of residuals.
fn rounding<S: Real, const NC: usize>(size: S) -> (S, impl Fn(&[S; NC]) -> S) {
    (S::EPSILON * size, |r: &[S; NC]| largest(r))
}

/// Corrects `u` until its violation is at most `least` in a measure, or falls no more. Returns it.
pub(super) fn descend<S: Real, const NQ: usize, const NC: usize>(
    (least, measure): (S, impl Fn(&[S; NC]) -> S),
    u: &mut [S; NQ],
    violation: impl Fn(&[S; NQ]) -> [S; NC],
    correction: impl Fn(&[S; NQ], &[S; NC]) -> Option<[S; NQ]>,
) -> [S; NC] {
    let mut r = violation(u);
    for _ in 0..ITERATIONS {
        if measure(&r) <= least {
            break;
        }
        let Some(du) = correction(u, &r) else { break };
        let mut next = *u;
        for i in 0..NQ {
            next[i] = next[i] - du[i];
        }
        let after = violation(&next);
        if measure(&after) < measure(&r) {
            (*u, r) = (next, after);
        } else {
            break;
        }
    }
    r
}

/// Gives `u`, whose violation is rounding, the derivatives of what corrections lead to: those of one more correction. A start that closes
/// as it is has seen none; what [`descend`] has seen leaves derivatives open by as much as the last correction. The values stay, to the bit.
pub(super) fn derive<S: Real, const NQ: usize, const NC: usize>(
    u: &mut [S; NQ],
    violation: impl Fn(&[S; NQ]) -> [S; NC],
    correction: impl Fn(&[S; NQ], &[S; NC]) -> Option<[S; NQ]>,
) {
    if S::HAS_DERIVATIVES
        && let Some(du) = correction(u, &violation(u))
    {
        for i in 0..NQ {
            u[i] = (u[i] - du[i]).with_plain(u[i].plain());
        }
    }
}
