//! Constraints with a condition that holds at the start: assembly closes them with the joints.

use super::{Absolute, Branch, Layout, assemble};
use crate::fault::Fault;
use crate::scalar::Real;
use crate::start::Start;
use crate::system::Health;

/// `K` constraints beside those of the joints, each of which holds at a start or does not; implemented by generated code.
pub trait Conditional<S: Real, const NQ: usize, const NC: usize, const K: usize>:
    Absolute<S, NQ, NC>
{
    /// The rows of the joints, and after them these.
    fn layout_with_conditional(&self) -> &'static Layout;

    /// Their residuals of position, m or rad.
    fn conditional(&self, t: S, q: &[S; NQ]) -> [S; K];

    /// Their residuals of velocity, m/s or rad/s.
    fn conditional_dot(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> [S; K];

    /// Their Jacobian, as [`Absolute::phi_q`] has that of the joints.
    fn conditional_q(&self, t: S, q: &[S; NQ], each: &mut impl FnMut(usize, usize, S));
}

/// The `NC` constraints of the joints, and after them the `K` conditional ones, of which `holds` marks those in force; `ALL` is the sum of
/// both numbers. Rows that are not in force are zero everywhere.
struct Joined<'a, M, const NC: usize, const K: usize, const ALL: usize> {
    mechanism: &'a M,
    holds: [bool; K],
}

/// Position and velocity at the time `t` that satisfy the joints and those conditional constraints that are marked in `holds`; reached from
/// the start values as by [`assemble`]. `ALL` is `NC + K`.
///
/// # Errors
/// Those of [`assemble`].
pub fn assemble_held<
    S: Real,
    M: Conditional<S, NQ, NC, K>,
    const NQ: usize,
    const NC: usize,
    const K: usize,
    const ALL: usize,
>(
    mechanism: &M,
    t: S,
    holds: [bool; K],
) -> Result<([S; NQ], [S; NQ]), Fault> {
    let joined: Joined<'_, M, NC, K, ALL> = Joined { mechanism, holds };
    let assembly = assemble::<S, _, NQ, ALL>(&joined, t)?;
    Ok((assembly.q, assembly.v))
}

impl<M, const NC: usize, const K: usize, const ALL: usize> Joined<'_, M, NC, K, ALL> {
    /// Residuals of the joints, and after them those of the conditional constraints, zero if these are not in force.
    fn residuals<S: Real>(&self, joints: &[S; NC], others: &[S; K]) -> [S; ALL] {
        let held: [S; K] = core::array::from_fn(|k| if self.holds[k] { others[k] } else { S::ZERO });
        let all = joints.iter().chain(&held);
        let mut residuals = [S::ZERO; ALL];
        for (residual, value) in residuals.iter_mut().zip(all) {
            *residual = *value;
        }
        residuals
    }
}

impl<S, M, const NQ: usize, const NC: usize, const K: usize, const ALL: usize> Absolute<S, NQ, ALL>
    for Joined<'_, M, NC, K, ALL>
where
    S: Real,
    M: Conditional<S, NQ, NC, K>,
{
    fn layout(&self) -> &'static Layout {
        self.mechanism.layout_with_conditional()
    }

    fn phi(&self, t: S, q: &[S; NQ]) -> [S; ALL] {
        self.residuals(&self.mechanism.phi(t, q), &self.mechanism.conditional(t, q))
    }

    fn phi_dot(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> [S; ALL] {
        self.residuals(&self.mechanism.phi_dot(t, q, v), &self.mechanism.conditional_dot(t, q, v))
    }

    fn phi_q(&self, t: S, q: &[S; NQ], each: &mut impl FnMut(usize, usize, S)) {
        self.mechanism.phi_q(t, q, each);
        self.mechanism.conditional_q(t, q, &mut |row, column, entry| {
            if self.holds.get(row) == Some(&true) {
                each(NC + row, column, entry);
            }
        });
    }

    /// Rows that are not in force have no pivot: every step is by rank.
    fn min_norm(&self, _t: S, _q: &[S; NQ], _w: &[S; NQ], _r: &[S; ALL], _dq: &mut [S; NQ]) -> Health<S> {
        Health(S::ZERO)
    }

    fn inverse_mass(&self) -> [S; NQ] {
        self.mechanism.inverse_mass()
    }

    fn start_position(&self) -> [Start<S>; NQ] {
        self.mechanism.start_position()
    }

    fn start_velocity(&self, q: &[S; NQ]) -> [Start<S>; NQ] {
        self.mechanism.start_velocity(q)
    }

    fn length(&self) -> S {
        self.mechanism.length()
    }

    fn branch(&self, index: usize) -> Option<Branch<S>> {
        self.mechanism.branch(index)
    }
}
