//! Least squares of least norm, and what they leave free, by singular values.

use nalgebra::{DMatrix, DVector};

/// Singular values below this fraction of the largest count as zero.
const RELATIVE: f64 = 1e-11;
/// Singular values below this count as zero in any case: unknowns and rows are scaled to be about one.
const ABSOLUTE: f64 = 1e-12;
/// A decomposition gives the matrix back to this fraction of its largest singular value.
const EXACT: f64 = 1e-13;
/// Columns are orthogonal where their product is below this fraction of their lengths.
const ORTHOGONAL: f64 = 16.0 * f64::EPSILON;
/// Iterations of a decomposition at most; some for each value do.
const ITERATIONS: usize = 10_000;
/// Sweeps over all pairs of columns at most; some ten do.
const MOST_SWEEPS: u32 = 60;

/// A matrix by its singular values, A = U S V^T.
pub(super) struct Ranked {
    rows: usize,
    u: DMatrix<f64>,
    s: DVector<f64>,
    v: DMatrix<f64>,
    rank: usize,
}

impl Ranked {
    /// None if an entry is not finite.
    pub(super) fn new(matrix: &DMatrix<f64>) -> Option<Self> {
        let (rows, columns) = matrix.shape();
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        if rows == 0 || columns == 0 {
            let (u, s) = (DMatrix::zeros(rows, columns), DVector::zeros(columns));
            return Some(Self { rows, u, s, v: DMatrix::identity(columns, columns), rank: 0 });
        }
        // Rows of zeros: singular vectors of all directions come out, not only of as many as there are rows.
        let tall = matrix.clone().resize(rows.max(columns), columns, 0.0);
        let (u, s, v) = by_library(&tall).unwrap_or_else(|| by_rotations(tall));
        let cut = (RELATIVE * s.max()).max(ABSOLUTE);
        let rank = s.iter().filter(|value| **value > cut).count();
        Some(Self { rows, u, s, v, rank })
    }

    /// The shortest of all x that come nearest to A x = b.
    pub(super) fn solve(&self, b: &DVector<f64>) -> DVector<f64> {
        let mut x = DVector::zeros(self.v.nrows());
        for k in 0..self.rank {
            let along = self.u.column(k).rows(0, self.rows).dot(b) / self.s[k];
            x.axpy(along, &self.v.column(k), 1.0);
        }
        x
    }

    /// Solves for several right-hand sides in columns.
    pub(super) fn solve_all(&self, b: &DMatrix<f64>) -> DMatrix<f64> {
        let mut x = DMatrix::zeros(self.v.nrows(), b.ncols());
        for k in 0..b.ncols() {
            x.set_column(k, &self.solve(&b.column(k).into_owned()));
        }
        x
    }

    /// Orthonormal columns z with A z = 0.
    pub(super) fn null_space(&self) -> DMatrix<f64> {
        self.v.columns(self.rank, self.v.ncols() - self.rank).into_owned()
    }
}

/// U, the singular values from the largest on, and V, by nalgebra; none where their product is not the matrix. Its last step for two
/// values that are nearly equal can lose half of the digits and more.
fn by_library(matrix: &DMatrix<f64>) -> Option<(DMatrix<f64>, DVector<f64>, DMatrix<f64>)> {
    let mut svd = matrix.clone().try_svd(true, true, f64::EPSILON, ITERATIONS)?;
    svd.sort_by_singular_values();
    let (u, s, v_t) = (svd.u?, svd.singular_values, svd.v_t?);
    let off = (&u * DMatrix::from_diagonal(&s) * &v_t - matrix).amax();
    (off <= EXACT * s.max()).then(|| (u, s, v_t.transpose()))
}

/// Singular values and vectors by rotations of two columns each, until all are orthogonal but for rounding (M. R. Hestenes, J. SIAM 6, 1958; G. H. Golub,
/// C. F. Van Loan, Matrix Computations, 4th ed., 8.6.3).
fn by_rotations(mut a: DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>, DMatrix<f64>) {
    let count = a.ncols();
    let mut v = DMatrix::identity(count, count);
    for _ in 0..MOST_SWEEPS {
        let mut any = false;
        for (p, q) in (0..count).flat_map(|p| (p + 1..count).map(move |q| (p, q))) {
            let [pp, qq] = [p, q].map(|k| a.column(k).norm_squared());
            let pq = a.column(p).dot(&a.column(q));
            if pq.abs() <= ORTHOGONAL * (pp * qq).sqrt() {
                continue;
            }
            any = true;
            let half = (qq - pp) / (2.0 * pq);
            let tan = half.signum() / (half.abs() + half.hypot(1.0));
            let cos = 1.0 / tan.hypot(1.0);
            for columns in [&mut a, &mut v] {
                let [first, second] = [p, q].map(|k| columns.column(k).into_owned());
                columns.set_column(p, &(cos * &first - cos * tan * &second));
                columns.set_column(q, &(cos * tan * first + cos * second));
            }
        }
        if !any {
            break;
        }
    }
    let sizes: Vec<f64> = a.column_iter().map(|column| column.norm()).collect();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|one, other| sizes[*other].total_cmp(&sizes[*one]));
    let unit = |k: usize| if sizes[k] > 0.0 { a.column(k) / sizes[k] } else { a.column(k).into_owned() };
    let columns = |of: &dyn Fn(usize) -> DVector<f64>| {
        let columns: Vec<_> = order.iter().map(|k| of(*k)).collect();
        DMatrix::from_columns(&columns)
    };
    let s = DVector::from_fn(count, |k, _| sizes[order[k]]);
    (columns(&unit), s, columns(&|k| v.column(k).into_owned()))
}

/// Orthonormal columns z with A z = 0.
pub(super) fn null_space(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    Some(Ranked::new(matrix)?.null_space())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{DMatrix, DVector, Ranked};

    /// Two singular values are equal, and nalgebra's decomposition is off by 7 %.
    #[test]
    fn equal_singular_values_are_told_as_well_as_others() {
        let (sin, cos) = 25_f64.to_radians().sin_cos();
        let matrix = DMatrix::from_row_slice(3, 3, &[-1.0, 0.0, -1.0, 0.0, -1.0, 0.0, cos, -sin, -cos]);
        let ranked = Ranked::new(&matrix).unwrap();
        let known = DVector::from_row_slice(&[0.3, -2.0, 0.7]);
        assert!((ranked.solve(&(&matrix * &known)) - known).amax() < 1e-14);
        assert_eq!(ranked.null_space().ncols(), 0);
        let mut wide = matrix.clone().insert_column(1, 0.0);
        wide.column_mut(1).copy_from(&matrix.column(0));
        let left = Ranked::new(&wide).unwrap().null_space();
        assert_eq!(left.ncols(), 1);
        assert!((wide * left).amax() < 1e-15);
    }
}
