//! Which combinations of constraint rows are independent while the mechanism moves.

use crate::linalg::{dot, identity, largest, rotate};
use crate::scalar::Real;

/// The independent combinations of the rows of A = phi_q M^-1/2, orthogonal to each other, and how they are made.
///
/// Whether rows are independent is a matter of geometry: it is decided with every column of phi_q scaled to 1, so that
/// neither units nor masses have a say (a light link may carry a heavy body). What is a direction of the motion near a
/// change point is decided coarsely: the stages of a step are off the constraints by the square of the step, and
/// dividing that by a small singular value would throw the mechanism onto another branch. Without such a direction the
/// bodies go straight on, and the projection at the end of the step takes care of the rest.
pub(super) struct Independent<S, const NQ: usize, const NC: usize> {
    /// W A: orthogonal rows, zero where the row of W is in the left null space.
    rows: [[S; NQ]; NC],
    /// Squares of their norms.
    squares: [S; NC],
    /// W.
    combinations: [[S; NC]; NC],
}

impl<S: Real, const NQ: usize, const NC: usize> Independent<S, NQ, NC> {
    /// Of the rows `scaled` = A. `None` if they are not finite.
    pub(super) fn rows(scaled: &[[S; NQ]; NC]) -> Option<Self> {
        let norms = column_norms(scaled);
        // A column of nothing but rounding stays small.
        let least = S::lit(1e-6) * largest(&norms);
        let sizes = norms.map(|norm| if norm > least { norm } else { least.max(S::EPSILON) });
        let geometry = rotate(scaled.map(|row| each(&row, &sizes, |a, size| a / size)), identity())?;
        let cut = geometry.cut(Self::tolerance());
        let mut rows = geometry.rows;
        for (row, sigma) in rows.iter_mut().zip(&geometry.sigma) {
            *row = each(row, &sizes, |a, size| if *sigma > cut { a * size } else { S::lit(0.0) });
        }
        let mut combinations = geometry.carried;
        let squares = orthogonalise(&mut rows, &mut combinations);
        Some(Self { rows, squares, combinations })
    }

    /// Below this fraction of the largest a singular value of the scaled phi_q counts as zero.
    fn tolerance() -> S {
        S::lit(1e-4).max(S::RANK_TOLERANCE)
    }

    /// Number of independent rows.
    pub(super) fn rank(&self) -> usize {
        self.squares.iter().filter(|square| **square > S::lit(0.0)).count()
    }

    /// y and lambda with A y = b in the independent directions, A^T lambda = y, both of least norm.
    pub(super) fn solve(&self, b: &[S; NC]) -> ([S; NQ], [S; NC]) {
        let (mut y, mut lambda) = ([S::lit(0.0); NQ], [S::lit(0.0); NC]);
        for ((row, square), w) in self.rows.iter().zip(&self.squares).zip(&self.combinations) {
            if *square > S::lit(0.0) {
                let factor = dot(w, b) / *square;
                y = each(&y, row, |y, r| factor.mul_add(r, y));
                lambda = each(&lambda, w, |lambda, w| factor.mul_add(w, lambda));
            }
        }
        (y, lambda)
    }

    /// Rows that take part in a dependency: their multipliers are not determined.
    pub(super) fn dependent(&self) -> [bool; NC] {
        let mut dependent = [false; NC];
        for (combination, square) in self.combinations.iter().zip(&self.squares) {
            for (mark, entry) in dependent.iter_mut().zip(combination) {
                *mark |= *square <= S::lit(0.0) && entry.abs() > Self::tolerance();
            }
        }
        dependent
    }
}

/// Makes independent rows orthogonal, and carries `w` along; rows of zeros stay. Returns the squares of their norms.
///
/// Gram-Schmidt, twice for full precision (L. Giraud, J. Langou, M. Rozloznik, The loss of orthogonality in the
/// Gram-Schmidt orthogonalization process, Comput. Math. Appl. 50, 2005).
fn orthogonalise<S: Real, const NQ: usize, const NC: usize>(
    rows: &mut [[S; NQ]; NC],
    w: &mut [[S; NC]; NC],
) -> [S; NC] {
    let mut squares = [S::lit(0.0); NC];
    for k in 0..NC {
        for _ in 0..2 {
            for j in 0..k {
                if squares[j] > S::lit(0.0) {
                    let factor = dot(&rows[j], &rows[k]) / squares[j];
                    rows[k] = each(&rows[k], &rows[j], |to, from| to - factor * from);
                    w[k] = each(&w[k], &w[j], |to, from| to - factor * from);
                }
            }
        }
        squares[k] = dot(&rows[k], &rows[k]);
    }
    squares
}

fn column_norms<S: Real, const NQ: usize, const NC: usize>(a: &[[S; NQ]; NC]) -> [S; NQ] {
    let zero = [S::lit(0.0); NQ];
    a.iter().fold(zero, |sums, row| each(&sums, row, |sum, a| a.mul_add(a, sum))).map(S::sqrt)
}

fn each<S: Real, const N: usize>(a: &[S; N], b: &[S; N], f: impl Fn(S, S) -> S) -> [S; N] {
    core::array::from_fn(|i| f(a[i], b[i]))
}
