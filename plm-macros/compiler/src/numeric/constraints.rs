//! The constraints as numeric functions of the pose, and Newton's iteration that closes them.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Tape, algebra};

use super::pseudo_inverse;
use super::rank::{Rank, Row, rank, rank_within};
use super::scene::Scene;
use crate::evaluated::run;
use crate::formulate::Function;

/// Newton steps before assembly is given up; a start in reach needs four to eight.
const MOST_STEPS: usize = 100;
/// Below this ratio of pivots the straight-line step is replaced by the rank-revealing one.
const HEALTHY: f64 = 1e-6;

/// The constraints of a scene.
pub(super) struct Constraints<'a> {
    pub(super) scene: &'a Scene<'a>,
    phi: Tape,
    phi_q: Tape,
    phi_dot: Tape,
    min_norm: Tape,
}

/// Result of an iteration that closes the joints. Its pose need not be closed.
#[derive(Clone)]
pub(super) struct Closed {
    /// The pose, m and rad.
    pub(super) q: Vec<f64>,
    /// The constraints there, m and rad.
    pub(super) phi: Vec<f64>,
    /// How many steps were taken.
    pub(super) steps: usize,
}

impl<'a> Constraints<'a> {
    pub(super) fn new(scene: &'a Scene<'a>) -> Constraints<'a> {
        let tape = |function: &Function| algebra::tape(&function.values());
        let absolute = scene.absolute;
        Constraints {
            scene,
            phi: tape(&absolute.phi),
            phi_q: tape(&absolute.phi_q),
            phi_dot: tape(&absolute.phi_dot),
            min_norm: tape(&absolute.min_norm),
        }
    }

    /// `phi` at a pose.
    pub(super) fn phi(&self, q: &[f64]) -> Vec<f64> {
        run(&self.phi, &self.scene.at(q))
    }

    /// `phi_q v - nu` at a pose.
    pub(super) fn phi_dot(&self, q: &[f64], v: &[f64]) -> Vec<f64> {
        run(&self.phi_dot, &self.scene.moving(q, v))
    }

    /// `phi_q` at a pose, by rows.
    pub(super) fn phi_q(&self, q: &[f64]) -> Vec<Row> {
        let mut entries = run(&self.phi_q, &self.scene.at(q)).into_iter();
        let rows = self.scene.equations.phi_q.iter();
        rows.map(|row| row.iter().map(|&(j, _)| j).zip(entries.by_ref()).collect_vec()).collect_vec()
    }

    /// Rank of `phi_q` and, after it, a row for each locked coordinate.
    pub(super) fn rank(&self, q: &[f64], locked: &[bool]) -> Rank {
        rank(&self.with_locks(q, locked))
    }

    /// Rank where dependence is judged by another share.
    pub(super) fn rank_within(&self, q: &[f64], locked: &[bool], tolerance: f64) -> Rank {
        rank_within(&self.with_locks(q, locked), tolerance)
    }

    fn with_locks(&self, q: &[f64], locked: &[bool]) -> Vec<Row> {
        let mut rows = self.phi_q(q);
        rows.push_all(locked.iter().enumerate().filter(|(_, lock)| **lock).map(|(k, _)| vec![(k, 1.0)]));
        rows
    }

    /// Newton's steps from a pose, `q <- q - pinv(phi_q) phi`, until `phi` is within its limits, which depend on the pose.
    pub(super) fn close(&self, q: Vec<f64>, locked: &[bool], limits: impl Fn(&[f64]) -> Vec<f64>) -> Closed {
        let mut now = Closed { phi: self.phi(&q), q, steps: 0 };
        let mut best = now.clone();
        while !are_closed(&now.phi, &limits(&now.q)) && now.steps < MOST_STEPS {
            let step = self.step(&now.q, locked, &now.phi);
            if !step.iter().all(|dq| dq.is_finite()) {
                break;
            }
            for (coordinate, dq) in now.q.iter_mut().zip(step) {
                *coordinate -= dq;
            }
            now.phi = self.phi(&now.q);
            now.steps += 1;
            if largest(&now.phi) < largest(&best.phi) {
                best = now.clone();
            }
        }
        // Joints that do not fit make the steps wander; the pose that is told is the one that fits best.
        if largest(&best.phi) < largest(&now.phi) { Closed { steps: now.steps, ..best } } else { now }
    }

    /// The minimum-norm `dq` with `phi_q dq = r` at a pose that leaves what is locked alone.
    pub(super) fn step(&self, q: &[f64], locked: &[bool], r: &[f64]) -> Vec<f64> {
        let mut values = self.scene.at(q);
        let weights = locked.iter().map(|&lock| if lock { 0.0 } else { 1.0 });
        let absolute = self.scene.absolute;
        values.push_all(absolute.weights.iter().copied().zip(weights));
        values.push_all(absolute.r.iter().copied().zip(r.iter().copied()));
        let mut step = run(&self.min_norm, &values);
        match step.pop() {
            Some(health) if health > HEALTHY && step.iter().all(|dq| dq.is_finite()) => step,
            _ => self.step_by_rank(q, locked, r),
        }
    }

    /// The minimum-norm `dq` where rows depend on each other: by singular values.
    fn step_by_rank(&self, q: &[f64], locked: &[bool], r: &[f64]) -> Vec<f64> {
        let dense = self.phi_q(q).into_iter().map(|row| {
            let mut full = vec![0.0; q.len()];
            for (j, entry) in row {
                full[j] = if locked[j] { 0.0 } else { entry };
            }
            full
        });
        let mut step = pseudo_inverse::solve(dense.collect_vec(), r.to_vec());
        step.resize(q.len(), 0.0);
        step
    }
}

/// Is every row within its limit?
pub(super) fn are_closed(phi: &[f64], limits: &[f64]) -> bool {
    phi.iter().zip(limits).all(|(phi, limit)| phi.abs() <= *limit)
}

/// Largest magnitude; infinite if a value is not a number.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, v| if v.is_nan() { f64::INFINITY } else { v.abs().max(largest) })
}
