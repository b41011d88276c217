//! The state on the constraints that is nearest to a given one, to rounding.

use super::newton::without_pivoting;
use super::{Absolute, join, split};
use crate::linalg::largest;
use crate::scalar::Real;
use crate::tolerances::{CLOSED_EXACTLY, CLOSING_STEPS, DISAGREEMENT};
use crate::vector::Vector;

/// Leads a state [q, v, first-order states] onto phi = 0 and phi_q v = nu by the shortest way in the metric of the masses;
/// false where no way is found.
///
/// It is for numbers of twice the precision: their elimination leaves out by itself what depends on other rows
/// ([`Scalar::MOST_GROWTH`](crate::Scalar::MOST_GROWTH)), so that nothing is left to be solved by rank.
pub(crate) fn nearest<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize, const NX: usize>(
    m: &M,
    t: S,
    x: &mut [S; NX],
) -> bool {
    let w = m.inverse_mass();
    let (mut q, mut v) = split(x);
    let led = close(m, t, &mut q, &w) && lead(m, (t, &q), &mut v, &w);
    if led {
        join(&q, &v, x);
    }
    led
}

/// Leads a pose onto phi = 0 by the shortest way in the metric W^-1; false where no way is found. A weight of 0 keeps a coordinate
/// as it is.
pub(crate) fn close<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &mut [S; NQ],
    w: &[S; NQ],
) -> bool {
    let size = m.length().max(largest(q));
    let (closed, disagree) =
        (CLOSED_EXACTLY.of::<S>() * S::EPSILON * size, DISAGREEMENT.of::<S>() * m.length());
    let mut before = S::INFINITY;
    for _ in 0..CLOSING_STEPS {
        let r = m.phi(t, q);
        let gap = largest(&r);
        if gap <= closed || (gap <= disagree && S::lit(2.0) * gap > before) {
            return true;
        }
        let Some(dq) = without_pivoting(m, t, q, w, &r) else { return false };
        *q = Vector::from_fn(|i| q[i] - dq[i]);
        before = gap;
    }
    false
}

/// Leads a velocity at the pose `q` onto phi_q v = nu by the shortest way in the metric W^-1; false where no way is found.
pub(crate) fn lead<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    (t, q): (S, &[S; NQ]),
    v: &mut [S; NQ],
    w: &[S; NQ],
) -> bool {
    let r = m.phi_dot(t, q, v);
    let Some(dv) = without_pivoting(m, t, q, w, &r) else { return false };
    *v = Vector::from_fn(|i| v[i] - dv[i]);
    true
}

/// The smallest pivot of `phi_q W phi_q^T` at a pose over its diagonal entry, which vanishes where the rank drops.
///
/// `W` weighs lengths by the mechanism's and angles by a radian, so that geometry alone decides. In the metric of the masses a body
/// whose centre is far from its joint, over its radius of gyration, has small pivots at every pose but along an axis.
pub(crate) fn smallest_pivot<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
) -> S {
    let (area, one) = (m.length() * m.length(), S::lit(1.0));
    let weights = Vector::from_fn(|i| if i % 3 == 2 { one } else { area });
    let mut dq = [S::ZERO; NQ];
    m.min_norm(t, q, &weights, &[S::ZERO; NC], &mut dq).0
}

/// The part whose constraint takes the longest way to close by a unit: near a singular pose, one of those that are flat.
pub fn flat_part<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
) -> &'static str {
    let (mut longest, mut part) = (S::ZERO, "");
    for (row, name) in m.layout().parts.iter().enumerate() {
        let r = Vector::from_fn(|j| if j == row { S::lit(1.0) } else { S::ZERO });
        let mut dq = [S::ZERO; NQ];
        m.min_norm(t, q, &[S::lit(1.0); NQ], &r, &mut dq);
        // NaN counts as infinitely long.
        let way = largest(&dq);
        let is_shorter = way <= longest;
        if !is_shorter {
            (longest, part) = (way, name);
        }
    }
    part
}
