//! Numbers that are given: whether all are finite, and decompositions that end where some are not.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

/// Iterations after which a decomposition has no end: those that converge need a few for each singular value.
pub(crate) const ITERATIONS: usize = 10_000;

/// Singular values with their vectors; none where an entry is no number, with which nalgebra's iteration does not end.
pub(crate) fn decomposed(matrix: DMatrix<f64>) -> Option<SVD<f64, Dyn, Dyn>> {
    let is_finite = matrix.iter().all(|entry| entry.is_finite());
    if is_finite { matrix.try_svd(true, true, f64::EPSILON, ITERATIONS) } else { None }
}

/// Singular values; none where an entry is no number.
pub(crate) fn singular_values(matrix: DMatrix<f64>) -> Option<DVector<f64>> {
    decomposed(matrix).map(|svd| svd.singular_values)
}

/// The number of singular values above a tolerance; 0 where an entry is no number.
pub(crate) fn rank(matrix: DMatrix<f64>, tolerance: f64) -> usize {
    singular_values(matrix).map_or(0, |values| values.iter().filter(|value| **value > tolerance).count())
}

/// The number of the first of some that has a coordinate that is no finite number.
pub(crate) fn first_without<const N: usize>(mut all: impl Iterator<Item = [f64; N]>) -> Option<usize> {
    all.position(|numbers| numbers.iter().any(|number| !number.is_finite()))
}
