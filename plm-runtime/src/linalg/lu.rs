//! Gaussian elimination with partial pivoting.

use super::complex::Entry;
use crate::scalar::Real;

/// P A = L U of the leading rows and columns of a square array (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th
/// ed., algorithm 3.4.1).
#[derive(Clone, Copy, Debug)]
pub struct Lu<T, const N: usize> {
    /// L below the diagonal, U above, the reciprocals of the pivots on it.
    pub(super) rows: [[T; N]; N],
    /// The row that step k brought to place k.
    pivots: [usize; N],
    order: usize,
}

impl<T, const N: usize> Lu<T, N> {
    /// Of the first `order` rows and columns; none if a column has no pivot: zeros only, or NaN.
    pub fn new<S: Real>(rows: [[T; N]; N], order: usize) -> Option<Self>
    where
        T: Entry<S>,
    {
        let mut lu = Self { rows, ..Self::room() };
        lu.decompose(order).then_some(lu)
    }

    /// Room for a decomposition.
    pub(super) fn room<S: Real>() -> Self
    where
        T: Entry<S>,
    {
        Self { rows: [[T::real(S::ZERO); N]; N], pivots: [0; N], order: 0 }
    }

    /// Decomposes the matrix that stands in the rows, in its place; false as [`new`](Self::new) gives none.
    pub(super) fn decompose<S: Real>(&mut self, order: usize) -> bool
    where
        T: Entry<S>,
    {
        self.order = order.min(N);
        decompose(&mut self.rows, &mut self.pivots, self.order)
    }

    /// Solves A y = b in place; entries beyond the order are not read.
    pub fn solve<S: Real>(&self, b: &mut [T; N])
    where
        T: Entry<S>,
    {
        solve(&self.rows, &self.pivots, self.order, b);
    }
}

/// Decomposes the leading `order` rows and columns of a matrix in its place, of which there are so many; false if a column has no pivot.
#[inline]
#[must_use]
pub fn decompose<S: Real, T: Entry<S>, const N: usize>(
    rows: &mut [[T; N]],
    pivots: &mut [usize],
    order: usize,
) -> bool {
    let order = order.min(N).min(rows.len());
    for (k, own) in pivots.iter_mut().enumerate().take(order) {
        let Some(pivot) = largest_below(rows, k, order) else { return false };
        *own = pivot;
        swap(rows, k, pivot);
        let mut row = rows[k];
        row[k] = row[k].reciprocal();
        rows[k] = row;
        for below in rows.iter_mut().take(order).skip(k + 1) {
            let factor = below[k] * row[k];
            below[k] = factor;
            for (entry, above) in below.iter_mut().zip(&row).take(order).skip(k + 1) {
                *entry = entry.less_product(factor, *above);
            }
        }
    }
    true
}

/// Solves A y = b in place, with what [`decompose`] has made; entries beyond the order are not read.
#[inline]
pub fn solve<S: Real, T: Entry<S>, const N: usize>(
    rows: &[[T; N]],
    pivots: &[usize],
    order: usize,
    b: &mut [T; N],
) {
    let order = order.min(N).min(rows.len());
    for (k, pivot) in pivots.iter().enumerate().take(order) {
        swap(b, k, *pivot);
    }
    for k in 1..order {
        let known = b.iter().zip(&rows[k]).take(k);
        b[k] = known.fold(b[k], |rest, (y, factor)| rest.less_product(*factor, *y));
    }
    for k in (0..order).rev() {
        let row = &rows[k];
        let known = b.iter().zip(row).take(order).skip(k + 1);
        b[k] = known.fold(b[k], |rest, (y, factor)| rest.less_product(*factor, *y)) * row[k];
    }
}

/// The row from `k` on that has the largest entry in column `k`; none if that is zero or not finite.
fn largest_below<S: Real, T: Entry<S>, const N: usize>(
    rows: &[[T; N]],
    k: usize,
    order: usize,
) -> Option<usize> {
    let mut found = (None, S::ZERO);
    for (i, row) in rows.iter().enumerate().take(order).skip(k) {
        let size = row.get(k)?.size();
        if !size.is_finite() {
            return None;
        }
        if size > found.1 {
            found = (Some(i), size);
        }
    }
    found.0
}

/// Exchanges two entries; nothing happens beyond the end.
fn swap<T: Copy>(entries: &mut [T], a: usize, b: usize) {
    if let (Some(first), Some(second)) = (entries.get(a).copied(), entries.get(b).copied()) {
        if let Some(place) = entries.get_mut(a) {
            *place = second;
        }
        if let Some(place) = entries.get_mut(b) {
            *place = first;
        }
    }
}
