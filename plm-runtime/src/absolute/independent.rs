//! Solutions by rank: which combinations of constraint rows are independent, and the least-norm solution from these.

use crate::linalg::{add, dot, largest, rotate};
use crate::scalar::Real;
use crate::tolerances::dependent;
use crate::vector::Vector;

/// Below this fraction of the largest a singular value counts as zero while the mechanism moves.
///
/// The stages of a step are off the constraints by the square of the step, and dividing that by a small singular value
/// near a change point would throw the mechanism onto another branch. Without that direction the bodies go straight on,
/// and the projection at the end of the step takes care of the rest.
pub(super) fn moving_tolerance<S: Real>() -> S {
    dependent()
}

/// The independent combinations of the rows of A = phi_q W^1/2, orthogonal to each other, with the same combinations of `beside`:
/// right-hand sides, or the identity, which becomes W with W A in the place of A.
///
/// The independence of rows is a matter of geometry: it is decided with every column scaled to 1, so that neither units nor the metric W
/// matter (a light link may carry a heavy body, a mechanism may be small).
///
/// It works in the place of A: large mechanisms have no room on a stack for a second matrix.
pub(super) struct Independent<'a, S, const NQ: usize, const NC: usize, const BESIDE: usize> {
    /// Orthogonal rows, zero where a combination of rows vanishes.
    rows: &'a mut [[S; NQ]; NC],
    /// Squares of their norms.
    squares: [S; NC],
    /// Right-hand sides of the rows, or the identity.
    beside: &'a mut [[S; BESIDE]; NC],
}

impl<'a, S: Real, const NQ: usize, const NC: usize, const BESIDE: usize> Independent<'a, S, NQ, NC, BESIDE> {
    /// Of A, where singular values up to `tolerance` times the largest count as zero. `None` if A is not finite.
    pub(super) fn of(
        a: &'a mut [[S; NQ]; NC],
        beside: &'a mut [[S; BESIDE]; NC],
        tolerance: S,
    ) -> Option<Self> {
        let mut found = Self { rows: a, squares: [S::lit(0.0); NC], beside };
        found.find(tolerance).then_some(found)
    }

    fn find(&mut self, tolerance: S) -> bool {
        let sizes = column_sizes(self.rows);
        for row in &mut *self.rows {
            each(row, &sizes, |a, size| a / size);
        }
        let Some(geometry) = rotate(self.rows, self.beside) else { return false };
        let cut = geometry.cut(tolerance);
        for (row, sigma) in self.rows.iter_mut().zip(&geometry.values) {
            each(row, &sizes, |a, size| if *sigma > cut { a * size } else { S::lit(0.0) });
        }
        self.orthogonalise();
        true
    }

    /// Makes the independent rows orthogonal; rows of zeros stay.
    ///
    /// Gram-Schmidt, twice for full precision (L. Giraud, J. Langou, M. Rozloznik, The loss of orthogonality in the
    /// Gram-Schmidt orthogonalization process, Comput. Math. Appl. 50, 2005).
    fn orthogonalise(&mut self) {
        for k in 0..NC {
            let (mut row, mut combination) = (self.rows[k], self.beside[k]);
            for _ in 0..2 {
                for j in 0..k {
                    if self.squares[j] > S::lit(0.0) {
                        let factor = -(dot(&self.rows[j], &row) / self.squares[j]);
                        add(&mut row, factor, &self.rows[j]);
                        add(&mut combination, factor, &self.beside[j]);
                    }
                }
            }
            self.squares[k] = dot(&row, &row);
            (self.rows[k], self.beside[k]) = (row, combination);
        }
    }

    /// Number of independent rows.
    pub(super) fn rank(&self) -> usize {
        self.squares.iter().filter(|square| **square > S::lit(0.0)).count()
    }
}

impl<S: Real, const NQ: usize, const NC: usize> Independent<'_, S, NQ, NC, 1> {
    /// y = A^+ b, where b is what stands beside A: A y = b in the independent directions, of least norm.
    pub(super) fn nearest(&self) -> [S; NQ] {
        let mut y = [S::lit(0.0); NQ];
        for ((row, square), [b]) in self.rows.iter().zip(&self.squares).zip(&*self.beside) {
            if *square > S::lit(0.0) {
                add(&mut y, *b / *square, row);
            }
        }
        y
    }
}

impl<S: Real, const NQ: usize, const NC: usize> Independent<'_, S, NQ, NC, NC> {
    /// y = A^+ b and lambda = (A^T)^+ y: A y = b in the independent directions, A^T lambda = y, both of least norm.
    pub(super) fn solve(&self, b: &[S; NC]) -> ([S; NQ], [S; NC]) {
        let (mut y, mut lambda) = ([S::lit(0.0); NQ], [S::lit(0.0); NC]);
        for ((row, square), w) in self.rows.iter().zip(&self.squares).zip(&*self.beside) {
            if *square > S::lit(0.0) {
                let factor = dot(w, b) / *square;
                add(&mut y, factor, row);
                add(&mut lambda, factor, w);
            }
        }
        (y, lambda)
    }

    /// Rows that take part in a dependency: their multipliers are not determined.
    pub(super) fn dependent(&self) -> [bool; NC] {
        let mut dependent = [false; NC];
        for (combination, square) in self.beside.iter().zip(&self.squares) {
            for (mark, entry) in dependent.iter_mut().zip(combination) {
                *mark |= *square <= S::lit(0.0) && entry.abs() > moving_tolerance();
            }
        }
        dependent
    }
}

/// Norms of the columns; those of nothing but rounding count as larger, so that they stay small.
pub(super) fn column_sizes<S: Real, const NQ: usize, const NC: usize>(a: &[[S; NQ]; NC]) -> [S; NQ] {
    let mut sizes = [S::lit(0.0); NQ];
    for row in a {
        each(&mut sizes, row, |sum, a| a.mul_add(a, sum));
    }
    let sizes = Vector::map(&sizes, S::sqrt);
    let least = (S::lit(1e-6) * largest(&sizes)).max(S::EPSILON);
    Vector::map(&sizes, |size| size.max(least))
}

/// `f` of each entry and the one beside it, in place.
pub(super) fn each<S: Real, const N: usize>(a: &mut [S; N], b: &[S; N], f: impl Fn(S, S) -> S) {
    for (a, b) in a.iter_mut().zip(b) {
        *a = f(*a, *b);
    }
}

/// Multiplies the columns of a matrix by `weights`.
pub(super) fn scale_columns<S: Real, const NQ: usize, const NC: usize>(
    a: &mut [[S; NQ]; NC],
    weights: &[S; NQ],
) {
    for row in a {
        each(row, weights, |entry, weight| entry * weight);
    }
}
