//! Constraints in absolute coordinates.

use plm_runtime::absolute::{Absolute, Branch, Layout};
use plm_runtime::{BodyStart, Health, Real, Start, Vector, singular};

use crate::handle::{Beside, Dynamic, Frame};

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Absolute<S, NQ, NC> for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    fn layout(&self) -> &'static Layout {
        &self.model.layout
    }

    fn phi(&self, t: S, q: &[S; NQ]) -> [S; NC] {
        let mut phi = [S::ZERO; NC];
        self.run(&self.model.absolute.phi, &Frame::of_pose(t, q, &[]), [&mut phi]);
        phi
    }

    fn phi_dot(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> [S; NC] {
        let mut phi_dot = [S::ZERO; NC];
        self.run(&self.model.absolute.phi_dot, &Frame::of_pose(t, q, v), [&mut phi_dot]);
        phi_dot
    }

    fn phi_q(&self, t: S, q: &[S; NQ], each: &mut impl FnMut(usize, usize, S)) {
        let places = &self.model.lowered.absolute.places;
        let mut entries = vec![S::ZERO; places.len()];
        self.run(&self.model.absolute.phi_q, &Frame::of_pose(t, q, &[]), [&mut entries]);
        for (&(row, column), entry) in places.iter().zip(entries) {
            each(row, column, entry);
        }
    }

    fn min_norm(&self, t: S, q: &[S; NQ], w: &[S; NQ], r: &[S; NC], dq: &mut [S; NQ]) -> Health<S> {
        let beside = Beside { weights: w, residuals: r, ..Beside::NONE };
        let frame = Frame { beside: Some(&beside), ..Frame::of_pose(t, q, &[]) };
        Health(self.run(&self.model.absolute.min_norm, &frame, [dq]))
    }

    fn inverse_mass(&self) -> [S; NQ] {
        let mut inverse_mass = [S::ZERO; NQ];
        self.run(&self.model.absolute.inverse_mass, &Frame::at(S::ZERO), [&mut inverse_mass]);
        inverse_mass
    }

    fn start_position(&self) -> [Start<S>; NQ] {
        self.starts_of(|body, centre, _| body.of_centre(centre))
    }

    fn start_velocity(&self, q: &[S; NQ]) -> [Start<S>; NQ] {
        self.starts_of(|body, centre, k| body.velocity_of_centre(centre, q.at(3 * k + 2)))
    }

    fn length(&self) -> S {
        S::lit(self.model.lowered.length)
    }

    fn refine(&self, t: S, q: &[S; NQ]) -> Option<([S; NQ], [S; NQ])> {
        let refines = self.model.lowered.may_be_singular;
        if refines { singular::refine::<Self, NQ, NC, N>(self, t, q) } else { None }
    }

    fn branch(&self, index: usize) -> Option<Branch<S>> {
        let branch = self.model.lowered.starts.branches.get(index)?;
        let count = self.model.lowered.starts.branches.len();
        let ends = self.values(S::ZERO, &self.model.start.ends, 8 * count);
        let end =
            |k: usize| [0, 1].map(|axis| ends.get(8 * index + 2 * k + axis).copied().unwrap_or(S::ZERO));
        let [first, second] = &branch.names;
        Some(Branch {
            part: &branch.part,
            bodies: branch.bodies,
            names: [first, second],
            ends: [[end(0), end(1)], [end(2), end(3)]],
            left: branch.left,
        })
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
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// Start values of the centres of gravity, body by body.
    fn starts_of(&self, of: impl Fn(BodyStart<S>, [S; 2], usize) -> [Start<S>; 3]) -> [Start<S>; NQ] {
        let count = self.model.lowered.bodies.len();
        let centres = self.values(S::ZERO, &self.model.start.centres, 2 * count);
        let mut all = [Start::free(S::ZERO); NQ];
        for (k, (starts, centre)) in
            all.as_chunks_mut::<3>().0.iter_mut().zip(centres.as_chunks::<2>().0).enumerate()
        {
            *starts = of(self.starts.body(k), *centre, k);
        }
        all
    }
}
