//! Small dense matrices: rank and null space by orthogonalisation of their rows, elimination for implicit methods.
//!
//! One-sided Jacobi rotations (M. R. Hestenes, Inversion of matrices by biorthogonalization and related results, J. Soc.
//! Indust. Appl. Math. 6, 1958; G. H. Golub, C. F. Van Loan, Matrix Computations, 8.6.3) turn the rows of A until
//! they are orthogonal: W A = S V^T, with orthogonal W and V and the singular values as the norms of the rows. It
//! works on arrays in place, needs no bidiagonalisation, and is accurate to small singular values (J. Demmel,
//! K. Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13, 1992).

mod complex;
pub mod lu;
mod mixed;
mod resolvent;
pub mod sparse;

pub use complex::{Both, Complex, Entry};
pub use lu::Lu;
pub use mixed::Mixed;
pub use resolvent::{Dense, Derivatives, Resolvent};
pub use sparse::{Below, Eliminated, Part, Pattern, Patterned, Pivot, Sparse, Term};

use crate::scalar::Real;

/// Sweeps that are enough many times over: convergence is quadratic, six to ten are usual.
const SWEEPS: usize = 60;

/// Rotates `rows` until they are orthogonal, and `carried` along with them: what was A becomes S V^T, what was B becomes
/// W B. Returns the singular values, the norms of the rows, in no particular order; `None` if an entry is not finite.
///
/// It works in place: matrices of large mechanisms fit on a stack once, not several times. Rows and columns of zeros after the last one
/// that has a number are room, and cost nothing.
pub fn rotate<S: Real, const ROWS: usize, const COLUMNS: usize, const CARRIED: usize>(
    rows: &mut [[S; COLUMNS]; ROWS],
    carried: &mut [[S; CARRIED]; ROWS],
) -> Option<Singular<S, ROWS>> {
    let mut values = [S::lit(0.0); ROWS];
    let [matrix, carried] =
        [Rows::of(rows.as_flattened_mut(), COLUMNS), Rows::of(carried.as_flattened_mut(), CARRIED)];
    orthogonalise(matrix, carried, &mut values).then_some(Singular { values })
}

/// [`rotate`] for all sizes of matrices; false if an entry is not finite. In builds with debug assertions a crate has its own copy: of what
/// is never inlined an optimised one would take that of an unoptimised one.
#[cfg_attr(not(debug_assertions), inline(never))]
fn orthogonalise<S: Real>(mut rows: Rows<'_, S>, mut carried: Rows<'_, S>, values: &mut [S]) -> bool {
    let total = (0..values.len()).fold(S::lit(0.0), |sum, k| sum + rows.product(k, k));
    if !total.is_finite() {
        return false;
    }
    let precision = Precision::of(&rows, total);
    let count = rows.filled();
    for _ in 0..SWEEPS {
        let mut orthogonal = true;
        for p in 0..count {
            for q in p + 1..count {
                if let Some(rotation) = precision.rotation(&rows, p, q) {
                    rotation.apply(&mut rows, p, q);
                    rotation.apply(&mut carried, p, q);
                    orthogonal = false;
                }
            }
        }
        if orthogonal {
            for (k, value) in values.iter_mut().enumerate() {
                *value = rows.product(k, k).sqrt();
            }
            return true;
        }
    }
    false
}

/// A matrix by its rows, whatever its size.
struct Rows<'a, S> {
    numbers: &'a mut [S],
    /// Room for columns.
    stride: usize,
    /// Columns up to the last one that is not zero; of numbers with derivatives all.
    width: usize,
}

impl<'a, S: Real> Rows<'a, S> {
    fn of(numbers: &'a mut [S], stride: usize) -> Self {
        // A number with derivatives may be zero by its value alone.
        let width = if S::HAS_DERIVATIVES {
            stride
        } else {
            let widths = numbers.chunks(stride.max(1)).filter_map(|row| row.iter().rposition(is_filled));
            widths.max().map_or(0, |last| last + 1)
        };
        Self { numbers, stride, width }
    }

    /// Rows up to the last one that is not zero.
    fn filled(&self) -> usize {
        self.numbers.iter().rposition(is_filled).map_or(0, |last| last / self.stride.max(1) + 1)
    }

    fn row(&self, k: usize) -> &[S] {
        self.numbers.get(k * self.stride..).and_then(|rest| rest.get(..self.width)).unwrap_or_default()
    }

    /// Inner product of two rows.
    fn product(&self, p: usize, q: usize) -> S {
        let (p, q) = (self.row(p), self.row(q));
        let count = p.len().min(q.len());
        let (mut sum, mut j) = (S::lit(0.0), 0);
        while j < count {
            sum = p[j].mul_add(q[j], sum);
            j += 1;
        }
        sum
    }

    /// Two rows, the first before the other.
    fn pair(&mut self, p: usize, q: usize) -> Option<(&mut [S], &mut [S])> {
        let (before, from) = self.numbers.split_at_mut_checked(q * self.stride)?;
        Some((before.get_mut(p * self.stride..)?.get_mut(..self.width)?, from.get_mut(..self.width)?))
    }
}

fn is_filled<S: Real>(number: &S) -> bool {
    *number != S::lit(0.0)
}

/// The singular values of a matrix.
#[derive(Clone, Copy, Debug)]
pub struct Singular<S, const ROWS: usize> {
    /// One for each row, in no particular order.
    pub values: [S; ROWS],
}

impl<S: Real, const ROWS: usize> Singular<S, ROWS> {
    /// The fraction `relative` of the largest.
    pub fn cut(&self, relative: S) -> S {
        relative * largest(&self.values)
    }

    /// How many are above `cut`.
    pub fn rank(&self, cut: S) -> usize {
        self.values.iter().filter(|value| **value > cut).count()
    }
}

/// The identity.
pub fn identity<S: Real, const N: usize>() -> [[S; N]; N] {
    let mut one = [[S::lit(0.0); N]; N];
    diagonal(&mut one);
    one
}

/// Makes a matrix of zeros the identity.
pub fn diagonal<S: Real, const N: usize>(zeros: &mut [[S; N]; N]) {
    for i in 0..N {
        zeros[i][i] = S::lit(1.0);
    }
}

// The loops that most of the work is in count by themselves: without optimisation iterators take several times as long.

/// `to + factor * from`, in place.
pub fn add<S: Real, const N: usize>(to: &mut [S; N], factor: S, from: &[S; N]) {
    let mut i = 0;
    while i < N {
        to[i] = factor.mul_add(from[i], to[i]);
        i += 1;
    }
}

/// Inner product.
pub fn dot<S: Real, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    let (mut sum, mut i) = (S::lit(0.0), 0);
    while i < N {
        sum = a[i].mul_add(b[i], sum);
        i += 1;
    }
    sum
}

/// Largest absolute value; NaN if there is one; zero for an empty array.
pub fn largest<S: Real, const N: usize>(v: &[S; N]) -> S {
    v.iter().fold(S::lit(0.0), |largest, s| if s.abs() <= largest { largest } else { s.abs() })
}

/// Thresholds of rounding for a matrix of a given size.
struct Precision<S> {
    /// Cosine of the angle between rows that count as orthogonal.
    cosine: S,
    /// Square of the norm that rounding leaves of a row which depends on others: it has no direction.
    square: S,
}

impl<S: Real> Precision<S> {
    /// Of a matrix with the sum of squares `total`. Rows and columns of zeros are room, and do not count.
    fn of(matrix: &Rows<'_, S>, total: S) -> Self {
        let all = || matrix.numbers.chunks(matrix.stride.max(1));
        let rows = all().filter(|row| row.iter().any(is_filled)).count();
        let is_column = |column: &usize| all().any(|row| row.get(*column).is_some_and(is_filled));
        let columns = (0..matrix.width).filter(is_column).count();
        let cosine = S::lit(columns.max(4) as f64).sqrt() * S::EPSILON;
        let noise = S::lit(rows.max(columns) as f64) * S::EPSILON;
        Self { cosine, square: noise * noise * total }
    }

    /// The rotation that makes two rows orthogonal; none if they are, or if one is nothing but rounding.
    fn rotation(&self, rows: &Rows<'_, S>, p: usize, q: usize) -> Option<Rotation<S>> {
        let (pp, qq, pq) = (rows.product(p, p), rows.product(q, q), rows.product(p, q));
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
    /// Rotates the rows `p` and `q`, `p` before `q`.
    fn apply(&self, rows: &mut Rows<'_, S>, p: usize, q: usize) {
        let Some((p, q)) = rows.pair(p, q) else { return };
        let count = p.len().min(q.len());
        let mut j = 0;
        while j < count {
            let (x, y) = (p[j], q[j]);
            p[j] = self.cos * x - self.sin * y;
            q[j] = self.sin * x + self.cos * y;
            j += 1;
        }
    }
}
