//! Least weighted squares under equations that may depend on each other.

use crate::linalg::dot;
use crate::scalar::Real;

/// Equations that are not independent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Dependence<S> {
    /// The row depends on no unknown.
    Unmoved {
        /// Its number.
        row: usize,
    },
    /// The row follows from those before it, and contradicts them.
    Follows {
        /// Its number.
        row: usize,
        /// Its right-hand side, less that which follows.
        misses: S,
    },
}

/// The y with the least sum of weight y^2 for which rows y = right, by Gram and Schmidt's orthogonalisation of the rows: L Q = rows, twice, so
/// that rounding leaves nothing along the rows before (A. Björck, Numerical Methods for Least Squares Problems, 1996, 2.4.5).
///
/// Right-hand sides are sums of numbers of the given sizes; an entry far below the scale of its column is rounding.
pub(super) fn least_norm<S: Real, const ROWS: usize, const N: usize>(
    rows: &[[S; N]; ROWS],
    (right, sizes): (&[S; ROWS], &[S; ROWS]),
    (weights, scales): (&[S; N], &[S; N]),
) -> Result<[S; N], Dependence<S>> {
    let mut orthonormal = [[S::ZERO; N]; ROWS];
    let mut known = [S::ZERO; ROWS];
    let (mut rank, mut y) = (0, [S::ZERO; N]);
    for i in 0..ROWS {
        let is_rounding = |j: usize| rows[i][j].abs() <= S::RANK_TOLERANCE * scales[j];
        if (0..N).all(is_rounding) {
            return Err(Dependence::Unmoved { row: i });
        }
        let mut row = [S::ZERO; N];
        for j in 0..N {
            row[j] = rows[i][j] / weights[j].sqrt();
        }
        let size = dot(&row, &row).sqrt();
        let (mut left, mut size_of_left) = (right[i], right[i].abs() + sizes[i]);
        for k in (0..2).flat_map(|_| 0..rank) {
            let factor = dot(&orthonormal[k], &row);
            crate::linalg::add(&mut row, -factor, &orthonormal[k]);
            left = left - factor * known[k];
            size_of_left = size_of_left + (factor * known[k]).abs();
        }
        let norm = dot(&row, &row).sqrt();
        if norm > S::RANK_TOLERANCE * size {
            orthonormal[rank] = row.map(|entry| entry / norm);
            known[rank] = left / norm;
            rank += 1;
        } else if left.abs() > S::RANK_TOLERANCE * size_of_left {
            return Err(Dependence::Follows { row: i, misses: left });
        }
    }
    for (row, known) in orthonormal.iter().zip(known).take(rank) {
        crate::linalg::add(&mut y, known, row);
    }
    for (y, weight) in y.iter_mut().zip(weights) {
        *y = *y / weight.sqrt();
    }
    Ok(y)
}
