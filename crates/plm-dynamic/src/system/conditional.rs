//! Constraints with a condition that hold where a run begins: assembly closes them with the joints.

use plm_runtime::absolute::{self, Absolute, Branch, Layout};
use plm_runtime::contact::Contacts;
use plm_runtime::{Fault, Health, Real, Start};

use crate::contact::Conditional;
use crate::handle::{Dynamic, Frame, Held};

/// A mechanism whose rows are those of its joints, and after them constraints with a condition: those of the marked ones, of the others
/// zeros.
struct Joined<
    'a,
    S,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> {
    mechanism: &'a Dynamic<S, NQ, NC, N, L, H, R, P>,
    conditional: &'static Conditional,
    holds: [bool; R],
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// The constraints with a condition, by their numbers among these, that hold.
    pub(super) fn conditions_that_hold(&self, of: &Conditional, held: &Held<S, NQ, L, H, R>) -> [bool; R] {
        let mut holds = [false; R];
        for (holds, row) in holds.iter_mut().zip(&of.rows) {
            *holds = self.exists(held, *row);
        }
        holds
    }

    /// Position and velocity that the joints allow, and the marked constraints.
    pub(super) fn assembled_with(
        &self,
        t: S,
        (conditional, holds): (&'static Conditional, [bool; R]),
    ) -> Result<([S; NQ], [S; NQ]), Fault> {
        let joined = Joined { mechanism: self, conditional, holds };
        let assembly = absolute::assemble::<S, _, NQ, NC>(&joined, t)?;
        Ok((assembly.q, assembly.v))
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Joined<'_, S, NQ, NC, N, L, H, R, P>
{
    /// Writes residuals of the constraints after those of the joints.
    fn put(&self, code: &'static crate::code::Code, frame: &Frame<S, NQ, L, H, R>, residuals: &mut [S; NC]) {
        let joints = self.mechanism.model.lowered.rows.len();
        let mut own = [S::ZERO; R];
        self.mechanism.run(code, frame, [&mut own]);
        let held = own.into_iter().zip(self.holds).map(|(value, holds)| if holds { value } else { S::ZERO });
        for (residual, value) in residuals.iter_mut().skip(joints).zip(held) {
            *residual = value;
        }
    }
}

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Absolute<S, NQ, NC> for Joined<'_, S, NQ, NC, N, L, H, R, P>
{
    fn layout(&self) -> &'static Layout {
        &self.conditional.layout
    }

    fn phi(&self, t: S, q: &[S; NQ]) -> [S; NC] {
        let mut phi = self.mechanism.phi(t, q);
        self.put(&self.conditional.phi, &Frame::of_pose(t, q, &[]), &mut phi);
        phi
    }

    fn phi_dot(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> [S; NC] {
        let mut phi_dot = self.mechanism.phi_dot(t, q, v);
        self.put(&self.conditional.phi_dot, &Frame::of_pose(t, q, v), &mut phi_dot);
        phi_dot
    }

    fn phi_q(&self, t: S, q: &[S; NQ], each: &mut impl FnMut(usize, usize, S)) {
        self.mechanism.phi_q(t, q, each);
        let joints = self.mechanism.model.lowered.rows.len();
        let mut entries = vec![S::ZERO; self.conditional.places.len()];
        self.mechanism.run(&self.conditional.phi_q, &Frame::of_pose(t, q, &[]), [&mut entries]);
        for (&[row, column], entry) in self.conditional.places.iter().zip(entries) {
            if self.holds.get(row) == Some(&true) {
                each(joints + row, column, entry);
            }
        }
    }

    /// Rows that do not hold have no pivot: every step is by rank.
    fn min_norm(&self, _t: S, _q: &[S; NQ], _w: &[S; NQ], _r: &[S; NC], _dq: &mut [S; NQ]) -> Health<S> {
        Health(S::ZERO)
    }

    fn inverse_mass(&self) -> [S; NQ] {
        Absolute::<S, NQ, NC>::inverse_mass(self.mechanism)
    }

    fn start_position(&self) -> [Start<S>; NQ] {
        self.mechanism.start_position()
    }

    fn start_velocity(&self, q: &[S; NQ]) -> [Start<S>; NQ] {
        self.mechanism.start_velocity(q)
    }

    fn length(&self) -> S {
        Absolute::<S, NQ, NC>::length(self.mechanism)
    }

    fn branch(&self, index: usize) -> Option<Branch<S>> {
        self.mechanism.branch(index)
    }
}
