//! Rank, null space and pseudo-inverse of small dense matrices, by orthogonalisation of their rows.
//!
//! One-sided Jacobi rotations (M. R. Hestenes, Inversion of matrices by biorthogonalization and related results, J. Soc.
//! Indust. Appl. Math. 6, 1958; G. H. Golub, C. F. Van Loan, Matrix Computations, 8.6.3) turn the rows of A until
//! they are orthogonal: W A = S V^T, with orthogonal W and V and the singular values as the norms of the rows. It
//! works on arrays in place, needs no bidiagonalisation, and is accurate to small singular values (J. Demmel,
//! K. Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13, 1992).

use crate::scalar::Real;

/// Sweeps that are enough many times over: convergence is quadratic, six to ten are usual.
const SWEEPS: usize = 60;

/// The rotated rows S V^T of a matrix, and what was rotated with them.
#[derive(Clone, Copy, Debug)]
pub struct Rotated<S, const ROWS: usize, const COLUMNS: usize, const CARRIED: usize> {
    /// Orthogonal rows; their norms are the singular values, in no particular order.
    pub rows: [[S; COLUMNS]; ROWS],
    /// W times what was to be carried: W itself for the identity, W b for a right-hand side b.
    pub carried: [[S; CARRIED]; ROWS],
    /// The singular values.
    pub sigma: [S; ROWS],
}

/// Rotates `rows` until they are orthogonal, and `carried` along with them. `None` if an entry is not finite.
pub fn rotate<S: Real, const ROWS: usize, const COLUMNS: usize, const CARRIED: usize>(
    mut rows: [[S; COLUMNS]; ROWS],
    mut carried: [[S; CARRIED]; ROWS],
) -> Option<Rotated<S, ROWS, COLUMNS, CARRIED>> {
    let total = rows.iter().fold(S::lit(0.0), |sum, row| sum + dot(row, row));
    if !total.is_finite() {
        return None;
    }
    let precision = Precision::of::<ROWS, COLUMNS>(total);
    for _ in 0..SWEEPS {
        let mut orthogonal = true;
        for p in 0..ROWS {
            for q in p + 1..ROWS {
                if let Some(rotation) = precision.rotation(&rows[p], &rows[q]) {
                    rotation.apply(&mut rows, p, q);
                    rotation.apply(&mut carried, p, q);
                    orthogonal = false;
                }
            }
        }
        if orthogonal {
            let sigma = rows.map(|row| dot(&row, &row).sqrt());
            return Some(Rotated { rows, carried, sigma });
        }
    }
    None
}

impl<S: Real, const ROWS: usize, const COLUMNS: usize, const CARRIED: usize>
    Rotated<S, ROWS, COLUMNS, CARRIED>
{
    /// The fraction `relative` of the largest singular value.
    pub fn cut(&self, relative: S) -> S {
        relative * largest(&self.sigma)
    }

    /// Number of singular values above `cut`.
    pub fn rank(&self, cut: S) -> usize {
        self.range(cut).count()
    }

    /// The singular values above `cut`, with their rotated and carried rows.
    pub fn range(&self, cut: S) -> impl Iterator<Item = (S, &[S; COLUMNS], &[S; CARRIED])> {
        let rows = self.sigma.iter().zip(&self.rows).zip(&self.carried);
        rows.map(|((sigma, row), carried)| (*sigma, row, carried)).filter(move |(sigma, ..)| *sigma > cut)
    }

    /// What was carried by the rows of the other singular values: the left null space, if W was carried.
    pub fn null(&self, cut: S) -> impl Iterator<Item = &[S; CARRIED]> {
        let rows = self.sigma.iter().zip(&self.carried);
        rows.filter(move |(sigma, _)| **sigma <= cut).map(|(_, carried)| carried)
    }
}

/// x = A^+ b: of all x that minimise |A x - b| the shortest. `None` if A is not finite.
///
/// Singular values up to [`Real::RANK_TOLERANCE`] times the largest count as zero.
pub fn pseudo_solve<S: Real, const ROWS: usize, const COLUMNS: usize>(
    a: [[S; COLUMNS]; ROWS],
    b: &[S; ROWS],
) -> Option<[S; COLUMNS]> {
    let rotated = rotate(a, b.map(|b| [b]))?;
    let mut x = [S::lit(0.0); COLUMNS];
    for (sigma, row, [b]) in rotated.range(rotated.cut(S::RANK_TOLERANCE)) {
        // The row is sigma times the singular vector.
        let factor = *b / sigma / sigma;
        for (x, r) in x.iter_mut().zip(row) {
            *x = factor.mul_add(*r, *x);
        }
    }
    Some(x)
}

/// The identity.
pub fn identity<S: Real, const N: usize>() -> [[S; N]; N] {
    let mut one = [[S::lit(0.0); N]; N];
    for i in 0..N {
        one[i][i] = S::lit(1.0);
    }
    one
}

/// Inner product.
pub fn dot<S: Real, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    a.iter().zip(b).fold(S::lit(0.0), |sum, (a, b)| a.mul_add(*b, sum))
}

/// Largest absolute value; NaN if there is one; zero for an empty array.
pub fn largest<S: Real, const N: usize>(v: &[S; N]) -> S {
    v.iter().fold(S::lit(0.0), |largest, s| if s.abs() <= largest { largest } else { s.abs() })
}

/// What cannot be told from zero in a matrix of a given size.
struct Precision<S> {
    /// Cosine of the angle between rows that count as orthogonal.
    cosine: S,
    /// Square of the norm that rounding leaves of a row which depends on others: it has no direction.
    square: S,
}

impl<S: Real> Precision<S> {
    /// Of a matrix with the sum of squares `total`.
    fn of<const ROWS: usize, const COLUMNS: usize>(total: S) -> Self {
        let cosine = S::lit(COLUMNS.max(4) as f64).sqrt() * S::EPSILON;
        let noise = S::lit(ROWS.max(COLUMNS) as f64) * S::EPSILON;
        Self { cosine, square: noise * noise * total }
    }

    /// The rotation that makes two rows orthogonal; none if they are, or if one is nothing but rounding.
    fn rotation<const N: usize>(&self, p: &[S; N], q: &[S; N]) -> Option<Rotation<S>> {
        let (pp, qq, pq) = (dot(p, p), dot(q, q), dot(p, q));
        if pp.min(qq) <= self.square || pq.abs() <= self.cosine * (pp.sqrt() * qq.sqrt()) {
            return None;
        }
        // The smaller root of t^2 + 2 zeta t - 1 = 0 (Golub and Van Loan, 8.5.2).
        let one = S::lit(1.0);
        let zeta = (qq - pp) / (pq + pq);
        let root = zeta.abs() + (zeta * zeta + one).sqrt();
        let t = if zeta < S::lit(0.0) { -one / root } else { one / root };
        let cos = one / (t * t + one).sqrt();
        Some(Rotation { cos, sin: t * cos })
    }
}

/// A plane rotation.
struct Rotation<S> {
    cos: S,
    sin: S,
}

impl<S: Real> Rotation<S> {
    /// Rotates the rows `p` and `q`.
    fn apply<const ROWS: usize, const N: usize>(&self, rows: &mut [[S; N]; ROWS], p: usize, q: usize) {
        for j in 0..N {
            let (x, y) = (rows[p][j], rows[q][j]);
            rows[p][j] = self.cos * x - self.sin * y;
            rows[q][j] = self.sin * x + self.cos * y;
        }
    }
}
