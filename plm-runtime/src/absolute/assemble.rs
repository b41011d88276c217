//! Assembly: a start position and velocity that the joints allow.
//!
//! The Planar Mechanical Library's manual, 4.4: generalised Newton iteration q <- q - phi_q^+ phi in SI units with unit
//! weights, full steps and a new Jacobian each time, from the start values as they are. A lock q_i = q_i0 is an extra
//! row, which is the same as removing the column. Velocities take one such solve.

use super::Absolute;
use super::assembly::{Assembly, Found, Status};
use super::branch;
use super::change_point::moves;
use super::damped::Measure;
use super::disagree::disagreement;
use super::far::{far, look_nearer};
use super::lack::lack;
use super::newton::{assembly_step, refused};
use super::placed::bring_nearer;
use super::project::{derive, descend};
use super::redundancy::{Dependencies, beside};
use super::renew::open;
use super::scale::Scale;
use super::search::search;
use crate::fault::{Cause, Fault, Names};
use crate::linalg::largest;
use crate::scalar::Real;
use crate::start::{Start, freedoms, values};
use crate::vector::Vector;

/// Makes the cause of a fault of redundant locks.
type LockCause = fn(usize, Names, Names) -> Cause;
const POSITION: LockCause = |count, locks, joints| Cause::Redundant { count, locks, joints };
const VELOCITY: LockCause = |count, locks, joints| Cause::VelocityRedundant { count, locks, joints };

/// Newton steps after which the joints do not close any more.
const ITERATIONS: u32 = 100;
/// Damped steps to a pose without locks, and the part of the violation that each takes away.
const UNLOCKED: (u32, f64) = (60, 1e-3);

/// Finds the position and velocity at the time `t` that the joints allow and that is reached from the start values with
/// the shortest steps; where those reach none, the nearest of the poses that a search about the start values finds.
///
/// Joints that repeat each other are accepted and flagged. Locks that repeat joints or other locks are not.
///
/// # Errors
/// [`Cause::NotFinite`], [`Cause::Redundant`], [`Cause::Open`], [`Cause::Disagree`], [`Cause::OtherBranch`], [`Cause::VelocityRedundant`], [`Cause::NoMotion`],
/// [`Cause::VelocityOpen`]; the part is the joint that stays open, where all others are closed. [`Cause::Workspace`].
pub fn assemble<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
) -> Result<Assembly<S, NQ, NC>, Fault> {
    let start = m.start_position();
    let free = freedoms(&start);
    let pose = close(m, t, &start, &free)?;
    let mut pose = branch::find(m, t, pose, (&start, &free))?;
    derive(&mut pose.q, |q| m.phi(t, q), |q, r| assembly_step(m, t, q, &free, r));
    let refined = m.refine(t, &pose.q);
    let q = refined.map_or(pose.q, |(q, _)| q);
    let here = Dependencies::at(m, t, &q, &free).ok_or_else(|| undecided(m, (t, &q), &free))?;
    reject_locks(m, t, &q, &free, &here, POSITION)?;
    let v = refined.map_or_else(|| start_velocity(m, t, &q), |(_, v)| Ok(v))?;
    let layout = m.layout();
    let neighbour = neighbour(m, t, &q, &here);
    if here.of_joints > neighbour.of_joints && !moves(m, t, (&q, &v)) {
        let flat = (0..NC).rev().find(|row| here.rows.get(*row) == Some(&true)).unwrap_or_default();
        return Err(Fault::of_part(t.to_f64(), layout.part(flat), Cause::NoMotion));
    }
    let locks = start.iter().filter(|s| s.locked).count();
    let (coordinates, joint_rows) = (layout.coordinates.len(), layout.rows.len());
    let (rank, rows) = (here.free_rank + locks, joint_rows + locks);
    let status = match () {
        () if neighbour.of_joints > 0 => Status::Redundant,
        () if rows == coordinates => Status::Sufficient,
        () => Status::Insufficient,
    };
    Ok(Assembly {
        q,
        v,
        moved: Vector::from_fn(|i| q[i] - start[i].value),
        locked: start.map(|s| s.locked),
        redundant: neighbour.rows,
        rank,
        rows,
        locks,
        freedom: coordinates as i32 - joint_rows as i32,
        status,
        singular: neighbour.of_joints < here.of_joints || here.of_locks > 0,
        far: if m.branch(0).is_none() { far(m, t, (&start, &free), &q) } else { None },
        found: pose.found,
        iterations: pose.iterations,
        gap: largest(&pose.phi),
        layout,
    })
}

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

/// Closes the joints from the start values.
fn close<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    start: &[Start<S>; NQ],
    free: &[S; NQ],
) -> Result<Pose<S, NQ, NC>, Fault> {
    let q0 = values(start);
    check_finite(m, t, &q0)?;
    let mut pose = newton(m, t, &q0, free);
    if pose.is_closed(m) {
        bring_nearer(m, t, &mut pose, (&q0, free));
        look_nearer(m, t, &mut pose, (start, free));
        return Ok(pose);
    }
    // Lengths that repeat each other disagree wherever the search looks.
    if let Some(fault) = disagreement(m, t, &pose.q) {
        return Err(fault);
    }
    // Too many locks are a likelier mistake than joints that do not fit. A pose that closes without locks shows it.
    if let Some(unlocked) = unlocked(m, t, start, free)
        && let Some(there) = Dependencies::at(m, t, &unlocked, free)
    {
        reject_locks(m, t, &unlocked, free, &there, POSITION)?;
    }
    searched(m, t, (start, free)).map_err(|nearest| lack(m, (t, nearest), free, &nearest))
}

/// A closed pose with nothing locked. `None` if nothing is locked, or if no such pose is near the start: a distant one says nothing about
/// the locks.
#[cold]
#[inline(never)]
fn unlocked<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    start: &[Start<S>; NQ],
    free: &[S; NQ],
) -> Option<[S; NQ]> {
    if free.iter().all(|free| *free > S::ZERO) {
        return None;
    }
    let (mut q, free) = (values(start), [S::lit(1.0); NQ]);
    let mut pose = newton(m, t, &q, &free);
    if !pose.is_closed(m) {
        Measure::new(m, &free).descend(m, t, &mut q, UNLOCKED);
        pose = newton(m, t, &q, &free);
    }
    (pose.is_closed(m) && far(m, t, (start, &free), &pose.q).is_none()).then_some(pose.q)
}

/// The pose that a search about the start values finds, or the one at which the joints are open least.
#[cold]
#[inline(never)]
fn searched<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
) -> Result<Pose<S, NQ, NC>, [S; NQ]> {
    let mut pose = search(m, t, (start, free), |q| branch::missed(m, q))?;
    bring_nearer(m, t, &mut pose, (&values(start), free));
    Ok(pose)
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

/// The start velocity, corrected as little as possible; locked velocities are unchanged.
fn start_velocity<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
) -> Result<[S; NQ], Fault> {
    let start = m.start_velocity(q);
    let free = freedoms(&start);
    let mut v = values(&start);
    check_finite(m, t, &v)?;
    let here = Dependencies::at(m, t, q, &free).ok_or_else(|| undecided(m, (t, q), &free))?;
    reject_locks(m, t, q, &free, &here, VELOCITY)?;
    let scale = Scale::of_velocity(m, q, &v);
    let measure = (S::EPSILON, |r: &[S; NC]| scale.worst(m, r));
    let r = descend(measure, &mut v, |v| m.phi_dot(t, q, v), |_, r| assembly_step(m, t, q, &free, r));
    if Scale::of_velocity(m, q, &v).is_closed(m, &r) {
        derive(&mut v, |v| m.phi_dot(t, q, v), |_, r| assembly_step(m, t, q, &free, r));
        return Ok(v);
    }
    let open = || open(t, &r, m.layout(), |gap| Cause::VelocityOpen { gap });
    Err(refused(m, (t, q), &free).unwrap_or_else(open))
}

/// An error if locks are redundant here and beside this position (at a dead point they only seem to be).
fn reject_locks<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    free: &[S; NQ],
    here: &Dependencies<NQ, NC>,
    cause: LockCause,
) -> Result<(), Fault> {
    if here.of_locks == 0 {
        return Ok(());
    }
    let neighbour = beside(q, free, m.length());
    let beside =
        Dependencies::at(m, t, &neighbour, free).ok_or_else(|| undecided(m, (t, &neighbour), free))?;
    let count = here.of_locks.min(beside.of_locks);
    if count == 0 {
        return Ok(());
    }
    // A pose of zeros may have extra dependences; a neighbouring pose shows the usual ones.
    let found = if beside.of_locks < here.of_locks { &beside } else { here };
    let locks = Names::marked(m.layout().coordinates, &found.locks);
    let joints = Names::marked(m.layout().parts, &found.ties);
    Err(Fault::new(t.to_f64(), cause(count, locks, joints)))
}

/// Dependencies among joints at a neighbouring closed position: those that do not come from this position alone.
fn neighbour<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    here: &Dependencies<NQ, NC>,
) -> Dependencies<NQ, NC> {
    if here.of_joints == 0 {
        return *here;
    }
    let free = [S::lit(1.0); NQ];
    let pose = newton(m, t, &beside(q, &free, m.length()), &free);
    if !pose.is_closed(m) {
        return *here;
    }
    Dependencies::at(m, t, &pose.q, &free).unwrap_or(*here)
}

fn check_finite<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    values: &[S; NQ],
) -> Result<(), Fault> {
    match m.layout().coordinates.iter().zip(values).find(|(_, value)| !value.is_finite()) {
        Some((name, _)) => Err(Fault::of_part(t.to_f64(), name, Cause::NotFinite)),
        None => Ok(()),
    }
}

/// Why dependencies are not known at a pose.
fn undecided<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    at: (S, &[S; NQ]),
    free: &[S; NQ],
) -> Fault {
    refused(m, at, free).unwrap_or(Fault::new(at.0.to_f64(), Cause::Singular { rows: NC }))
}
