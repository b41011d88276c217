//! Assembly of a running mechanism whose parameters were changed.

use super::Absolute;
use super::assemble::newton;
use super::newton::{assembly_step, refused};
use super::scale::Scale;
use super::settle::{descend, widest};
use crate::fault::{Cause, Fault};
use crate::linalg::largest;
use crate::scalar::Real;

/// Closes the joints from the present pose as the start, with nothing locked, and gives the velocities that the joints
/// allow nearest to the present ones. What is closed already stays as it is, to the bit.
///
/// # Errors
/// [`Cause::NotFinite`], [`Cause::Open`], [`Cause::VelocityOpen`]; the part is the joint that stays open widest.
/// [`Cause::Workspace`].
pub fn renew<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &mut [S; NQ],
    v: &mut [S; NQ],
) -> Result<(), Fault> {
    let free = [S::lit(1.0); NQ];
    let is_closed = |q: &[S; NQ], r: &[S; NC]| Scale::of_position(m, q).is_closed::<M, NQ, NC>(r);
    let phi = m.phi(t, q);
    if !is_closed(q, &phi) {
        let pose = newton(m, t, q, &free);
        if !is_closed(&pose.q, &pose.phi) {
            let open = || open(t, &phi, &M::PARTS, |gap| Cause::Open { gap });
            return Err(refused(m, (t, &pose.q), &free).unwrap_or_else(open));
        }
        *q = pose.q;
    }
    let scale = Scale::of_velocity(m, q, v);
    let phi_dot = m.phi_dot(t, q, v);
    if !scale.is_closed::<M, NQ, NC>(&phi_dot) {
        let (least, worst) = (S::EPSILON, |r: &[S; NC]| scale.worst::<M, NQ, NC>(r));
        let left =
            descend((least, worst), v, |v| m.phi_dot(t, q, v), |_, r| assembly_step(m, t, q, &free, r));
        if !scale.is_closed::<M, NQ, NC>(&left) {
            let open = || open(t, &left, &M::PARTS, |gap| Cause::VelocityOpen { gap });
            return Err(refused(m, (t, q), &free).unwrap_or_else(open));
        }
    }
    Ok(())
}

/// The fault of joints that stay open by a violation.
pub(super) fn open<S: Real, const NC: usize>(
    t: S,
    violation: &[S; NC],
    parts: &[&'static str; NC],
    cause: impl Fn(f64) -> Cause,
) -> Fault {
    let finite = violation.iter().all(|r| r.is_finite());
    let cause = if finite { cause(largest(violation).to_f64()) } else { Cause::NotFinite };
    Fault::of_part(t.to_f64(), widest(violation, parts), cause)
}
