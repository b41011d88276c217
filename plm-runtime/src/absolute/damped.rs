//! Damped steps towards a closed pose, where Newton's full steps wander.
//!
//! K. Levenberg, A method for the solution of certain non-linear problems in least squares, Q. Appl. Math. 2, 1944, with the
//! damping of D. W. Marquardt, J. SIAM 11, 1963: `(A^T A + mu) d = A^T f`, whose solution is found by conjugate gradients
//! (M. R. Hestenes, E. Stiefel, J. Res. NBS 49, 1952), so that no matrix is stored. `A` is `phi_q` in numbers without unit: rows
//! and columns in m are measured by the mechanism's length, those in rad by the radian.

use super::Absolute;
use crate::linalg::largest;
use crate::scalar::Real;
use crate::vector::Vector;

/// Damping at the first step, in units of `A^T A`.
const DAMPING: f64 = 1e-2;
/// Damping with which nothing moves any more.
const MOST_DAMPING: f64 = 1e8;
/// Conjugate gradients end at this part of the first residual, squared.
const SOLVED: f64 = 1e-10;
/// A violation in numbers without unit: of each row its weight times `phi`.
pub(super) struct Measure<S, const NQ: usize, const NC: usize> {
    /// Of each coordinate what a unit of it is; 0 where it is locked.
    columns: [S; NQ],
    /// Of each row the weight.
    pub(super) rows: [S; NC],
    /// Evaluations of `phi_q`.
    pub(super) work: u32,
}

impl<S: Real, const NQ: usize, const NC: usize> Measure<S, NQ, NC> {
    pub(super) fn new<M: Absolute<S, NQ, NC>>(m: &M, free: &[S; NQ]) -> Self {
        let one = S::lit(1.0);
        let length = if m.length() > S::ZERO { m.length() } else { one };
        Self {
            columns: Vector::from_fn(|k| free.at(k) * if k % 3 == 2 { one } else { length }),
            rows: Vector::from_fn(|row| if m.layout().is_angular(row) { one } else { one / length }),
            work: 0,
        }
    }

    pub(super) fn violation<M: Absolute<S, NQ, NC>>(&self, m: &M, t: S, q: &[S; NQ]) -> [S; NC] {
        let phi = m.phi(t, q);
        Vector::from_fn(|i| self.rows.at(i) * phi.at(i))
    }

    /// The largest violation; NaN if there is one.
    pub(super) fn size<M: Absolute<S, NQ, NC>>(&self, m: &M, t: S, q: &[S; NQ]) -> S {
        largest(&self.violation(m, t, q))
    }

    /// `A p` and `A^T u`.
    #[inline(never)]
    fn products<M: Absolute<S, NQ, NC>>(
        &mut self,
        m: &M,
        (t, q): (S, &[S; NQ]),
        p: &[S; NQ],
        u: &[S; NC],
    ) -> ([S; NC], [S; NQ]) {
        let (mut forth, mut back) = ([S::ZERO; NC], [S::ZERO; NQ]);
        m.phi_q(t, q, &mut |row, column, entry| {
            let entry = self.rows.at(row) * entry * self.columns.at(column);
            forth.set(row, entry.mul_add(p.at(column), forth.at(row)));
            back.set(column, entry.mul_add(u.at(row), back.at(column)));
        });
        self.work += 1;
        (forth, back)
    }

    /// `phi_q d` of a displacement of the free coordinates alone.
    pub(super) fn opened<M: Absolute<S, NQ, NC>>(
        &mut self,
        m: &M,
        at: (S, &[S; NQ]),
        d: &[S; NQ],
    ) -> [S; NC] {
        let p = Vector::from_fn(|k| {
            if self.columns.at(k) > S::ZERO { d.at(k) / self.columns.at(k) } else { S::ZERO }
        });
        let (forth, _) = self.products(m, at, &p, &[S::ZERO; NC]);
        Vector::from_fn(|i| forth.at(i) / self.rows.at(i))
    }

    /// The damped step at a pose with a violation.
    fn step<M: Absolute<S, NQ, NC>>(&mut self, m: &M, at: (S, &[S; NQ]), f: &[S; NC], damping: S) -> [S; NQ] {
        let mut d = [S::ZERO; NQ];
        let (_, mut left) = self.products(m, at, &d, f);
        let (mut p, mut square) = (left, dot(&left, &left));
        let least = S::lit(SOLVED) * square;
        for _ in 0..2 * m.layout().coordinates.len() {
            let is_left = square > least;
            if !is_left {
                break;
            }
            let (forth, _) = self.products(m, at, &p, &[S::ZERO; NC]);
            let (_, back) = self.products(m, at, &p, &forth);
            let by = square / (dot(&forth, &forth) + damping * dot(&p, &p));
            d = Vector::from_fn(|k| by.mul_add(p.at(k), d.at(k)));
            left = Vector::from_fn(|k| left.at(k) - by * (back.at(k) + damping * p.at(k)));
            let before = square;
            square = dot(&left, &left);
            p = Vector::from_fn(|k| (square / before).mul_add(p.at(k), left.at(k)));
        }
        Vector::from_fn(|k| d.at(k) * self.columns.at(k))
    }

    /// Goes down to where the violation is smallest in the mean of squares, in at most so many steps; one that takes away less
    /// than this part of it is the last one.
    pub(super) fn descend<M: Absolute<S, NQ, NC>>(
        &mut self,
        m: &M,
        t: S,
        q: &mut [S; NQ],
        (steps, least): (u32, f64),
    ) {
        let mut f = self.violation(m, t, q);
        let mut damping = S::lit(DAMPING);
        for _ in 0..steps {
            let size = dot(&f, &f);
            if largest(&f) <= S::lit(16.0) * S::EPSILON || !size.is_finite() {
                return;
            }
            let d = self.step(m, (t, q), &f, damping);
            let next = Vector::from_fn(|k| q.at(k) - d.at(k));
            let after = self.violation(m, t, &next);
            let left = (dot(&after, &after) / size).sqrt();
            if left < S::lit(1.0) {
                (*q, f) = (next, after);
                damping = damping * S::lit(if left < S::lit(0.5) { 0.1 } else { 0.5 });
                if left > S::lit(1.0 - least) {
                    return;
                }
            } else {
                damping = damping * S::lit(4.0);
                if damping > S::lit(MOST_DAMPING) {
                    return;
                }
            }
        }
    }
}

fn dot<S: Real, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    a.iter().zip(b).fold(S::ZERO, |sum, (a, b)| a.mul_add(*b, sum))
}
