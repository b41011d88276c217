//! The singular pose next to a state, and by how much the lengths miss it.
//!
//! At a singular pose a combination of constraint rows vanishes, `phi_q^T lambda = 0`. Such poses are where
//! `lambda^T phi`, on the poses that all other combinations of rows allow, has a critical point; its value there is the
//! difference of lengths by which the mechanism misses the pose (W. J. F. Govaerts, Numerical Methods for Bifurcations of
//! Dynamical Equilibria, SIAM 2000, 4.1 on the reduction to one equation). A sum of lengths that vanishes within the rounding
//! of its terms is zero: the mechanism comes to the pose itself, and this is known from its lengths alone, wherever on
//! its way it is asked for.

use super::ExtendedPrecision;
use super::combined::Combined;
use crate::absolute::{Absolute, phi_q_matrix};
use crate::double_double::DoubleDouble;
use crate::linalg::{add, diagonal, dot, largest, rotate};
use crate::scalar::{Real, Scalar};
use crate::tolerances::{CONVERGED, CRITICAL_STEPS, CURVED, DIFFERENCE, ROUNDED_LENGTH, SEARCHED, TOGETHER};
use crate::vector::Vector;
use crate::workspace;

/// A singular pose.
#[derive(Clone, Copy, Debug)]
pub(super) struct Critical<S, const NQ: usize, const NC: usize> {
    /// The pose.
    pub(super) q: [DoubleDouble<S>; NQ],
    /// Residuals there, m and rad; zero for redundant rows.
    pub(super) open: [DoubleDouble<S>; NC],
    /// The combination of rows that vanishes there, of residuals in m; its largest entry is 1.
    pub(super) combination: [S; NC],
    /// By how much joints are open, all together, m: the difference of lengths.
    pub(super) gap: S,
    /// Bound of the rounding error of `gap` due to that of the lengths, m.
    rounding: S,
}

impl<S: Real, const NQ: usize, const NC: usize> Critical<S, NQ, NC> {
    /// True if the lengths are those with which the mechanism reaches the pose.
    pub(super) fn is_reached(&self) -> bool {
        self.gap <= self.rounding
    }

    /// True if joints are open by at most so much there, m, beside the rounding of the lengths.
    pub(super) fn is_closed(&self, by: S) -> bool {
        self.gap <= self.rounding + by
    }
}

/// The constraints with all residuals in m: angles at the size of the mechanism, which positions are measured by.
pub(super) struct Rows<
    'm,
    M: ExtendedPrecision<NQ, NC, NX>,
    const NQ: usize,
    const NC: usize,
    const NX: usize,
> {
    pub(super) system: &'m M,
    extended: &'m M::Extended,
    length: M::S,
    /// False for redundant rows, which elimination leaves out, and for unused room.
    kept: [bool; NC],
}

impl<'m, M: ExtendedPrecision<NQ, NC, NX>, const NQ: usize, const NC: usize, const NX: usize>
    Rows<'m, M, NQ, NC, NX>
{
    /// Of a mechanism that is at the pose `q`; none where their matrices take more of the stack than is allowed.
    pub(super) fn at(
        system: &'m M,
        extended: &'m M::Extended,
        t: M::S,
        q: &[DoubleDouble<M::S>; NQ],
    ) -> Option<Self> {
        let room = workspace::of::<M::S, NQ, NC>() + size_of::<[[M::S; NQ]; NQ]>();
        if room > workspace::allowed() {
            return None;
        }
        let mut rows = Self::of(system, extended);
        rows.leave_out_repeated(t, q);
        Some(rows)
    }

    fn of(system: &'m M, extended: &'m M::Extended) -> Self {
        let rows = system.layout().rows.len();
        Self { system, extended, length: system.length(), kept: core::array::from_fn(|r| r < rows) }
    }

    /// Leaves out the rows that repeat others at the pose `q`: those that elimination leaves out there, of which a residual moves
    /// nothing. It is a call: a mechanism whose matrices have no room takes no stack for them.
    #[inline(never)]
    fn leave_out_repeated(&mut self, t: M::S, q: &[DoubleDouble<M::S>; NQ]) {
        let pose = Vector::from_fn(|i| q[i].rounded());
        let mut combined = Combined::nothing();
        let repeats = self.combined(t, &pose, &mut combined).is_some() && combined.repeats();
        if repeats {
            for k in 0..self.system.layout().rows.len() {
                let r = Vector::from_fn(|r| DoubleDouble::lit(if r == k { 1.0 } else { 0.0 }));
                let mut dq = [DoubleDouble::ZERO; NQ];
                self.extended.min_norm(DoubleDouble::of(t), q, &[DoubleDouble::lit(1.0); NQ], &r, &mut dq);
                self.kept[k] = largest(&dq) > DoubleDouble::ZERO;
            }
        }
    }

    /// The singular pose next to `q`; none where none is near.
    pub(super) fn critical(&self, t: M::S, q: &[DoubleDouble<M::S>; NQ]) -> Option<Critical<M::S, NQ, NC>> {
        [TOGETHER.get(), 1.0].into_iter().find_map(|together| self.newton(t, q, M::S::lit(together)))
    }

    /// The singular pose next to `q`, if the singular values up to `together` times the smallest vanish together with it.
    fn newton(
        &self,
        t: M::S,
        q: &[DoubleDouble<M::S>; NQ],
        together: M::S,
    ) -> Option<Critical<M::S, NQ, NC>> {
        let (mut q, mut way) = (*q, M::S::ZERO);
        for _ in 0..CRITICAL_STEPS {
            let dq = self.step(t, &q, together)?;
            let moved = largest(&dq);
            way = way + moved;
            // False for NaN.
            let near = way < SEARCHED.of::<M::S>();
            if !near {
                return None;
            }
            q = Vector::from_fn(|i| q[i] + DoubleDouble::of(self.column(i) * dq[i]));
            // The error of a Newton step is about the square of the next.
            if moved < M::S::EPSILON.sqrt() * CONVERGED.of::<M::S>() {
                return self.told(t, q, together);
            }
        }
        None
    }

    /// Are there rows that repeat others?
    pub(super) fn repeat(&self) -> bool {
        self.kept.iter().take(self.system.layout().rows.len()).any(|kept| !kept)
    }

    /// Coordinates of bodies; behind them is room.
    fn coordinates(&self) -> usize {
        self.system.layout().coordinates.len()
    }

    /// The unit of a coordinate.
    fn column(&self, i: usize) -> M::S {
        if i % 3 == 2 { M::S::lit(1.0) } else { self.length }
    }

    /// The unit of a row.
    fn row(&self, r: usize) -> M::S {
        if self.system.layout().is_angular(r) { self.length } else { M::S::lit(1.0) }
    }

    /// Residuals, m.
    fn phi(&self, t: M::S, q: &[DoubleDouble<M::S>; NQ]) -> [M::S; NC] {
        self.in_metres(&self.extended.phi(DoubleDouble::of(t), q))
    }

    /// Residuals in m.
    pub(super) fn in_metres(&self, open: &[DoubleDouble<M::S>; NC]) -> [M::S; NC] {
        Vector::from_fn(|r| self.row(r) * open[r].rounded())
    }

    /// Value of a row at a pose, m or rad: the sum that is compared with the prescribed value.
    pub(super) fn held_value(&self, t: M::S, q: &[M::S; NQ], row: usize) -> M::S {
        let mut value = M::S::ZERO;
        self.system.phi_q(t, q, &mut |r, i, entry| {
            value = if r == row { value + entry * q.at(i) } else { value };
        });
        value
    }

    /// Rates of the residuals of prescribed rows, at rest, m/s.
    pub(super) fn driven(&self, t: M::S, q: &[M::S; NQ]) -> [M::S; NC] {
        let rate = self.system.phi_dot(t, q, &[M::S::ZERO; NQ]);
        Vector::from_fn(|r| self.row(r) * rate[r])
    }

    /// `phi_q^T lambda`.
    fn gradient(&self, t: M::S, q: &[M::S; NQ], lambda: &[M::S; NC]) -> [M::S; NQ] {
        let mut gradient = [M::S::ZERO; NQ];
        self.system.phi_q(t, q, &mut |r, i, entry| {
            gradient.set(i, gradient.at(i) + lambda.at(r) * self.row(r) * self.column(i) * entry);
        });
        gradient
    }

    /// The derivative of that along a direction.
    #[inline(never)]
    fn bend(&self, t: M::S, q: &[M::S; NQ], lambda: &[M::S; NC], along: &[M::S; NQ]) -> [M::S; NQ] {
        let h = DIFFERENCE.of::<M::S>();
        let beside = |h: M::S| {
            let q = Vector::from_fn(|i| q[i] + h * self.column(i) * along[i]);
            self.gradient(t, &q, lambda)
        };
        let [ahead, behind] = [h, -h].map(beside);
        Vector::from_fn(|i| (ahead[i] - behind[i]) / (h + h))
    }

    /// The rows at a pose, combined.
    #[inline(never)]
    pub(super) fn combined(
        &self,
        t: M::S,
        q: &[M::S; NQ],
        combined: &mut Combined<M::S, NQ, NC>,
    ) -> Option<()> {
        phi_q_matrix(self.system, t, q, &mut combined.rows);
        for (r, row) in combined.rows.iter_mut().enumerate() {
            let unit = if self.kept[r] { self.row(r) } else { M::S::ZERO };
            *row = Vector::from_fn(|i| unit * self.column(i) * row[i]);
        }
        combined.kept = self.kept;
        diagonal(&mut combined.of);
        combined.sizes = rotate(&mut combined.rows, &mut combined.of)?.values;
        Some(())
    }

    /// A step of Newton's iteration towards the singular pose, in units of the coordinates.
    #[inline(never)]
    fn step(&self, t: M::S, at: &[DoubleDouble<M::S>; NQ], together: M::S) -> Option<[M::S; NQ]> {
        let q: [M::S; NQ] = Vector::from_fn(|i| at[i].rounded());
        let mut combined = Combined::nothing();
        self.combined(t, &q, &mut combined)?;
        combined.part(together);
        let r = self.phi(t, at);
        let mut dq = [M::S::ZERO; NQ];
        for (size, (of, row)) in combined.regular() {
            add(&mut dq, -dot(of, &r) / (size * size), row);
        }
        self.turn((t, &q), &combined, &mut dq)?;
        Some(dq)
    }

    /// Adds the part of a step in the directions that are left, in which the gradients of the combinations that vanish are to be zero:
    /// least squares, since there may be several.
    #[inline(never)]
    fn turn(
        &self,
        (t, q): (M::S, &[M::S; NQ]),
        combined: &Combined<M::S, NQ, NC>,
        dq: &mut [M::S; NQ],
    ) -> Option<()> {
        let mut normal = [[M::S::ZERO; NQ]; NQ];
        let mut sides = [[M::S::ZERO]; NQ];
        for (lambda, gradient) in combined.vanishing() {
            for (along, value) in (0..self.coordinates()).zip(gradient) {
                let bend = self.curvature((t, q), (combined, lambda), along);
                for ((row, side), entry) in normal.iter_mut().zip(&mut sides).zip(&bend) {
                    add(row, *entry, &bend);
                    side[0] = side[0] + *entry * *value;
                }
            }
        }
        let curvatures = rotate(&mut normal, &mut sides)?;
        let flat = curvatures.cut(CURVED.of::<M::S>());
        for ((size, row), [side]) in curvatures.values.iter().zip(&normal).zip(&sides) {
            if *size > flat {
                add(dq, -*side / (*size * *size), row);
            }
        }
        Some(())
    }

    /// A row of the second derivatives of `lambda^T phi` in the directions that the other combinations leave.
    #[inline(never)]
    fn curvature(
        &self,
        (t, q): (M::S, &[M::S; NQ]),
        (combined, lambda): (&Combined<M::S, NQ, NC>, &[M::S; NC]),
        row: usize,
    ) -> [M::S; NQ] {
        let mut along = [M::S::ZERO; NQ];
        along.set(row, M::S::lit(1.0));
        combined.leave(&mut along);
        let mut bend = self.bend(t, q, lambda, &along);
        combined.leave(&mut bend);
        bend
    }

    /// Do the combinations that vanish curve to one side alone, in all directions that are left? A loop then has no pose beyond.
    #[inline(never)]
    pub(super) fn is_definite(&self, t: M::S, critical: &Critical<M::S, NQ, NC>) -> bool {
        let q = critical.q.map(DoubleDouble::rounded);
        let mut combined = Combined::nothing();
        if self.combined(t, &q, &mut combined).is_none() {
            return false;
        }
        combined.part(TOGETHER.of::<M::S>());
        self.curves_to_one_side((t, &q), &combined, &critical.combination)
    }

    #[inline(never)]
    fn curves_to_one_side(
        &self,
        (t, q): (M::S, &[M::S; NQ]),
        combined: &Combined<M::S, NQ, NC>,
        lambda: &[M::S; NC],
    ) -> bool {
        let (mut hessian, mut nothing) = ([[M::S::ZERO; NQ]; NQ], [[M::S::ZERO]; NQ]);
        for (along, row) in hessian.iter_mut().enumerate().take(self.coordinates()) {
            *row = self.curvature((t, q), (combined, lambda), along);
        }
        let Some(curvatures) = rotate(&mut hessian, &mut nothing) else { return false };
        let flat = curvatures.cut(CURVED.of::<M::S>().sqrt());
        let [mut up, mut down] = [false; 2];
        for (_, row) in curvatures.values.iter().zip(&hessian).filter(|(size, _)| **size > flat) {
            let rises = dot(row, &self.bend(t, q, lambda, row)) > M::S::ZERO;
            (up, down) = (up || rises, down || !rises);
        }
        up != down
    }

    /// The singular pose at `q`, if combinations of rows vanish there: open joints, gap and its rounding.
    #[inline(never)]
    fn told(&self, t: M::S, q: [DoubleDouble<M::S>; NQ], together: M::S) -> Option<Critical<M::S, NQ, NC>> {
        let pose = q.map(DoubleDouble::rounded);
        let mut combined = Combined::nothing();
        self.combined(t, &pose, &mut combined)?;
        combined.part(together);
        if !combined.has_vanished() {
            return None;
        }
        let (rate, mut taken) = (self.driven(t, &pose), [M::S::ZERO; NC]);
        let mut weights = [M::S::ZERO; NC];
        for (lambda, _) in combined.vanishing() {
            weights = Vector::from_fn(|r| weights[r].max(lambda[r].abs()));
            if largest(&taken) <= M::S::ZERO || dot(lambda, &rate).abs() > dot(&taken, &rate).abs() {
                taken = *lambda;
            }
        }
        let (one, most) = (M::S::lit(1.0), largest(&taken));
        let combination = Vector::from_fn(|r| taken[r] / most);
        let all = largest(&weights);
        weights = Vector::from_fn(|r| weights[r] / all);
        let mut open = self.extended.phi(DoubleDouble::of(t), &q);
        for (open, _) in open.iter_mut().zip(&self.kept).filter(|(_, kept)| !**kept) {
            *open = DoubleDouble::ZERO;
        }
        let gap = self.in_metres(&open).iter().fold(M::S::ZERO, |gap, open| gap + open.abs());
        let terms = self.terms(t, &pose);
        let rounding = ROUNDED_LENGTH.of::<M::S>() * M::S::EPSILON * dot(&weights, &terms);
        // False for NaN.
        let known = most > M::S::ZERO && gap < self.length.max(one);
        known.then_some(Critical { q, open, combination, gap, rounding })
    }

    /// The lengths that each residual is a sum of, m: those that turn with bodies are its second derivatives by their angles; what
    /// is left of it belongs to the ground.
    #[inline(never)]
    fn terms(&self, t: M::S, q: &[M::S; NQ]) -> [M::S; NC] {
        let (mut terms, mut rest) = ([M::S::ZERO; NC], [M::S::ZERO; NC]);
        let layout = self.system.layout();
        self.system.phi_q(t, q, &mut |r, i, entry| {
            let of_place = i % 3 != 2;
            if of_place != layout.is_angular(r) {
                rest.set(r, rest.at(r) + self.row(r) * entry * q.at(i));
            }
        });
        let h = DIFFERENCE.of::<M::S>();
        for i in (0..self.coordinates()).filter(|i| i % 3 == 2) {
            let mut bends = [M::S::ZERO; NC];
            for h in [h, -h] {
                let mut beside = *q;
                beside.set(i, q.at(i) + h);
                self.system.phi_q(t, &beside, &mut |r, column, entry| {
                    let entry = if column == i { self.row(r) * entry / (h + h) } else { M::S::ZERO };
                    bends.set(r, bends.at(r) + entry);
                });
            }
            terms = Vector::from_fn(|r| terms[r] + bends[r].abs());
            rest = Vector::from_fn(|r| rest[r] - bends[r]);
        }
        Vector::from_fn(|r| terms[r] + rest[r].abs())
    }
}
