//! Assembly of a running mechanism whose parameters were changed.

use super::assemble::{Pose, newton};
use super::damped::Measure;
use super::lack::lack;
use super::newton::{assembly_step, refused};
use super::project::{derive, descend, widest};
use super::scale::Scale;
use super::search::{nearest_turns, unwind};
use super::{Absolute, Layout};
use crate::fault::{Cause, Fault};
use crate::linalg::largest;
use crate::scalar::Real;
use crate::vector::Vector;

/// Damped steps where Newton's do not close the joints, and the part of the violation that each takes away.
const STEPS: (u32, f64) = (100, 1e-6);

/// Closes the joints from the present pose as the start, with nothing locked, and gives the velocities that the joints
/// allow nearest to the present ones. A closed pose is unchanged, to the bit.
///
/// # Errors
/// [`Cause::NotFinite`], [`Cause::Open`], [`Cause::VelocityOpen`]; the part is the joint that stays open, where all others are closed.
/// [`Cause::Workspace`].
pub fn renew<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &mut [S; NQ],
    v: &mut [S; NQ],
) -> Result<(), Fault> {
    if !(q.is_finite() && v.is_finite()) {
        begin_elsewhere(m, q, v);
    }
    let free = [S::lit(1.0); NQ];
    let is_closed = |q: &[S; NQ], r: &[S; NC]| Scale::of_position(m, q).is_closed(m, r);
    let phi = m.phi(t, q);
    if !is_closed(q, &phi) {
        let mut pose = newton(m, t, q, &free);
        if !is_closed(&pose.q, &pose.phi) {
            pose = damped(m, t, q, &free)?;
        }
        // Springs and conditions read angles including whole revolutions.
        unwind(m, t, &mut pose, (q, &free), &nearest_turns);
        *q = pose.q;
    }
    allow(m, t, q, v, &free)
}

/// Changes velocities to the nearest ones that the joints allow, in the metric of `1/weights`; one with the weight 0 stays.
///
/// # Errors
/// [`Cause::VelocityOpen`], [`Cause::Workspace`].
pub(crate) fn allow<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    v: &mut [S; NQ],
    weights: &[S; NQ],
) -> Result<(), Fault> {
    let scale = Scale::of_velocity(m, q, v);
    let phi_dot = m.phi_dot(t, q, v);
    if !scale.is_closed(m, &phi_dot) {
        let (least, worst) = (S::EPSILON, |r: &[S; NC]| scale.worst(m, r));
        let left =
            descend((least, worst), v, |v| m.phi_dot(t, q, v), |_, r| assembly_step(m, t, q, weights, r));
        if !scale.is_closed(m, &left) {
            let open = || open(t, &left, m.layout(), |gap| Cause::VelocityOpen { gap });
            return Err(refused(m, (t, q), weights).unwrap_or_else(open));
        }
    }
    derive(v, |v| m.phi_dot(t, q, v), |_, r| assembly_step(m, t, q, weights, r));
    Ok(())
}

/// Puts the declared start, at rest, in the places of bodies whose pose is not known: loops that are followed in closed form have
/// none where their lengths do not reach.
#[cold]
#[inline(never)]
fn begin_elsewhere<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    q: &mut [S; NQ],
    v: &mut [S; NQ],
) {
    for (k, start) in m.start_position().iter().enumerate() {
        if !q.at(k).is_finite() {
            q.set(k, start.value);
        }
        if !v.at(k).is_finite() {
            v.set(k, S::ZERO);
        }
    }
}

/// The closed pose to which damped steps lead from one whose joints are open. No other start is tried: a run goes on beside
/// where it is, or not at all.
#[cold]
#[inline(never)]
fn damped<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    from: &[S; NQ],
    free: &[S; NQ],
) -> Result<Pose<S, NQ, NC>, Fault> {
    let mut q = *from;
    Measure::new(m, free).descend(m, t, &mut q, STEPS);
    let pose = newton(m, t, &q, free);
    if pose.is_closed(m) { Ok(pose) } else { Err(lack(m, (t, q), free, from)) }
}

/// The fault of joints that stay open by a violation.
pub(super) fn open<S: Real, const NC: usize>(
    t: S,
    violation: &[S; NC],
    layout: &Layout,
    cause: impl Fn(f64) -> Cause,
) -> Fault {
    let finite = violation.iter().all(|r| r.is_finite());
    let cause = if finite { cause(largest(violation).to_f64()) } else { Cause::NotFinite };
    Fault::of_part(t.to_f64(), widest(violation, layout), cause)
}
