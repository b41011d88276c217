//! Redundant joints whose lengths contradict each other.

use super::Absolute;
use super::newton::by_rank;
use super::project::widest;
use super::redundancy::{Dependencies, beside};
use crate::fault::{Cause, Fault, Names};
use crate::linalg::largest;
use crate::scalar::Real;
use crate::tolerances::{NEIGHBOUR_STEPS, OPEN_BY_ROUNDING, REPEATS, dependent};
use crate::vector::Vector;
use crate::workspace;

/// The fault of lengths that repeat each other and disagree, if that is why joints do not close at a pose: nearby as well, where
/// no pose singles itself out, constraint rows all but depend on others and stay open by little when those are closed.
#[cold]
#[inline(never)]
pub(crate) fn disagreement<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
) -> Option<Fault> {
    if workspace::refusal::<S, NQ, NC>().is_some() {
        return None;
    }
    let (free, nearly) = ([S::lit(1.0); NQ], dependent());
    let mut q = beside(q, &free, m.length());
    for _ in 0..NEIGHBOUR_STEPS {
        let dq = by_rank(m, (t, &q), &free, &m.phi(t, &q), nearly)?;
        q = Vector::from_fn(|i| q[i] - dq[i]);
    }
    let phi = m.phi(t, &q);
    let (gap, size) = (largest(&phi), m.length().max(largest(&q)));
    if !(gap > OPEN_BY_ROUNDING.of::<S>() * S::EPSILON * size && gap < REPEATS.of::<S>() * m.length()) {
        return None;
    }
    let there = Dependencies::by_rank(m, (t, &q), &free, nearly).filter(|there| there.of_joints > 0)?;
    let joints = Names::marked(m.layout().parts, &there.rows);
    let part = widest(&phi, m.layout());
    Some(Fault::of_part(t.to_f64(), part, Cause::Disagree { gap: gap.to_f64(), joints }))
}
