//! The pattern of an elimination without pivoting, in a given order, for the runtime to follow.

use crate::collect::CollectVec;
use crate::sorted::{SortedMap, SortedSet};

/// Entries of a sparse matrix, and what every pivot meets (I. S. Duff, A. M. Erisman, J. K. Reid, Direct Methods for
/// Sparse Matrices, 1986, chapter 9: symbolic factorisation).
#[derive(Default)]
pub(crate) struct Pattern {
    /// Place of each entry, fill included, by row and column.
    pub(crate) places: SortedMap<(usize, usize), usize>,
    /// The pivots in the order of elimination.
    pub(crate) pivots: Vec<Pivot>,
}

/// A pivot when its turn comes.
pub(crate) struct Pivot {
    /// Its row, and its column.
    pub(crate) row: usize,
    /// The rows below it that hold its column, ascending.
    pub(crate) below: Vec<usize>,
    /// The columns right of it that its row holds, ascending.
    pub(crate) right: Vec<usize>,
}

impl Pattern {
    /// Eliminates the diagonal in the order given; `held` are the entries before, (row, column).
    pub(crate) fn new(order: &[usize], held: impl IntoIterator<Item = (usize, usize)>) -> Pattern {
        let mut rows = vec![SortedSet::new(); order.len()];
        let mut columns = vec![SortedSet::new(); order.len()];
        for (row, column) in held {
            rows[row].insert(column);
            columns[column].insert(row);
        }
        let mut pattern = Pattern::default();
        let mut places = Vec::new();
        for &pivot in order {
            let mut right = std::mem::take(&mut rows[pivot]);
            let mut below = std::mem::take(&mut columns[pivot]);
            right.remove(&pivot);
            below.remove(&pivot);
            for &column in &right {
                columns[column].remove(&pivot);
                columns[column].extend(below.iter().copied());
            }
            for &row in &below {
                rows[row].remove(&pivot);
                rows[row].extend(right.iter().copied());
            }
            let own =
                below.iter().map(|&row| (row, pivot)).chain(right.iter().map(|&column| (pivot, column)));
            for key in std::iter::once((pivot, pivot)).chain(own) {
                places.push((key, places.len()));
            }
            let (below, right) = (below.into_iter().collect_vec(), right.into_iter().collect_vec());
            pattern.pivots.push(Pivot { row: pivot, below, right });
        }
        pattern.places = SortedMap::of(places);
        pattern
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fill_is_followed_and_a_good_order_has_none() {
        let arrow = || (0..5).flat_map(|k| [(k, k), (0, k), (k, 0)]);
        assert_eq!(Pattern::new(&[4, 3, 2, 1, 0], arrow()).places.len(), 13);
        assert_eq!(Pattern::new(&[0, 1, 2, 3, 4], arrow()).places.len(), 25);
    }

    #[test]
    fn rows_and_columns_may_differ() {
        // Row 1 holds column 0, not the other way round.
        let pattern = Pattern::new(&[0, 1, 2], [(0, 0), (1, 1), (2, 2), (1, 0), (0, 2)]);
        assert_eq!(pattern.pivots[0].below, [1]);
        assert_eq!(pattern.pivots[0].right, [2]);
        assert_eq!(pattern.pivots[1].right, [2], "fill");
        assert_eq!(pattern.places.len(), 6);
    }
}
