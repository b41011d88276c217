//! The linear solves of assembly and projection.

use super::independent::{Independent, moving_tolerance};
use super::{Absolute, fill};
use crate::fault::Fault;
use crate::scalar::Real;
use crate::vector::Vector;
use crate::workspace;

/// A step of assembly: the shortest dq with phi_q dq = r in which the coordinates with `free` = 0 stay, those with
/// `free` = 1 move; phi_q^+ r where the rank is not full. `None` if nothing finite comes out.
pub(super) fn assembly_step<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    free: &[S; NQ],
    r: &[S; NC],
) -> Option<[S; NQ]> {
    least_norm(m, t, q, free, r, S::RANK_TOLERANCE)
}

/// A step of projection: the dq with phi_q dq = r that is shortest in the metric of the masses, in the directions that
/// are not lost at a singular position. `None` if nothing finite comes out.
pub(super) fn projection_step<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    inverse_mass: &[S; NQ],
    r: &[S; NC],
) -> Option<[S; NQ]> {
    least_norm(m, t, q, inverse_mass, r, moving_tolerance())
}

/// dq = W^1/2 (phi_q W^1/2)^+ r with W = diag(w), without pivoting where that is healthy.
fn least_norm<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    w: &[S; NQ],
    r: &[S; NC],
    tolerance: S,
) -> Option<[S; NQ]> {
    without_pivoting(m, t, q, w, r).or_else(|| match workspace::refusal::<S, NQ, NC>() {
        Some(_) => None,
        None => by_rank(m, (t, q), w, r, tolerance),
    })
}

/// The fault of a pose at which there was no step because a solution by rank is refused; none if it is not, or if nothing
/// asks for one.
#[cold]
pub(super) fn refused<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    (t, q): (S, &[S; NQ]),
    w: &[S; NQ],
) -> Option<Fault> {
    let cause = workspace::refusal::<S, NQ, NC>()?;
    let healthy = without_pivoting(m, t, q, w, &[S::lit(0.0); NC]).is_some();
    (!healthy).then_some(Fault::new(t.to_f64(), cause))
}

/// As [`without_pivoting`], with as many independent rows as there are. It stores the one matrix of phi_q, for which healthy steps must not
/// pay.
#[cold]
#[inline(never)]
pub(super) fn by_rank<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    at: (S, &[S; NQ]),
    w: &[S; NQ],
    r: &[S; NC],
    tolerance: S,
) -> Option<[S; NQ]> {
    let mut rows = [[S::lit(0.0); NQ]; NC];
    let mut sides = (*r).map(|r| [r]);
    let roots = Vector::map(w, S::sqrt);
    fill(m, at, &roots, &mut rows);
    let y = Independent::of(&mut rows, &mut sides, tolerance)?.nearest();
    finite(Vector::from_fn(|i| roots[i] * y[i]))
}

/// The straight-line solution, if it is healthy.
pub(super) fn without_pivoting<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    w: &[S; NQ],
    r: &[S; NC],
) -> Option<[S; NQ]> {
    let mut dq = [S::lit(0.0); NQ];
    let health = m.min_norm(t, q, w, r, &mut dq);
    if health.is_good() { finite(dq) } else { None }
}

fn finite<S: Real, const N: usize>(v: [S; N]) -> Option<[S; N]> {
    v.iter().all(|s| s.is_finite()).then_some(v)
}
