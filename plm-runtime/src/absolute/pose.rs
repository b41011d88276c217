//! Poses by Newton's iteration.

use super::Absolute;
use super::assembly::Found;
use super::newton::assembly_step;
use super::project::descend;
use super::scale::Scale;
use crate::linalg::largest;
use crate::scalar::Real;

/// Newton steps after which the joints do not close any more.
const ITERATIONS: u32 = 100;

/// Result of Newton's iteration.
#[derive(Clone, Copy)]
pub(super) struct Pose<S, const NQ: usize, const NC: usize> {
    pub(super) q: [S; NQ],
    pub(super) iterations: u32,
    pub(super) phi: [S; NC],
    pub(super) found: Found,
}

impl<S: Real, const NQ: usize, const NC: usize> Pose<S, NQ, NC> {
    pub(super) fn is_closed<M: Absolute<S, NQ, NC>>(&self, m: &M) -> bool {
        Scale::of_position(m, &self.q).is_closed(m, &self.phi)
    }
}

/// Full Newton steps until the joints are closed, then on to rounding; or until the steps vanish.
pub(super) fn newton<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q0: &[S; NQ],
    free: &[S; NQ],
) -> Pose<S, NQ, NC> {
    let mut pose = Pose { q: *q0, iterations: 0, phi: m.phi(t, q0), found: Found::FromStart };
    while pose.iterations < ITERATIONS && !pose.is_closed(m) {
        let Some(dq) = assembly_step(m, t, &pose.q, free, &pose.phi) else { return pose };
        for i in 0..NQ {
            pose.q[i] = pose.q[i] - dq[i];
        }
        pose.phi = m.phi(t, &pose.q);
        pose.iterations += 1;
        if largest(&dq) <= S::EPSILON * largest(&pose.q) {
            return pose;
        }
    }
    if pose.is_closed(m) {
        let scale = Scale::of_position(m, &pose.q);
        let measure = (S::EPSILON, |r: &[S; NC]| scale.worst(m, r));
        pose.phi = descend(measure, &mut pose.q, |q| m.phi(t, q), |q, r| assembly_step(m, t, q, free, r));
    }
    pose
}
