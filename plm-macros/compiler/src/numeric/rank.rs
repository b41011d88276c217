//! Rank of a sparse matrix, and which rows depend on which.

use crate::collect::CollectVec;

/// A sparse row: (column, entry), columns ascending.
pub(crate) type Row = Vec<(usize, f64)>;

/// A row whose entries fall below this share of what they were made from is taken as zero.
const TOLERANCE: f64 = 1e-9;

/// Result of elimination.
#[derive(Debug, PartialEq)]
pub(crate) struct Rank {
    /// For every dependent row, the rows (itself included, ascending) whose combination vanishes.
    pub(crate) dependent: Vec<(usize, Vec<usize>)>,
    /// The independent rows, ascending.
    pub(crate) independent: Vec<usize>,
}

impl Rank {
    /// Rank without what is said of rows from this one on.
    pub(crate) fn of_rows(mut self, rows: usize) -> Rank {
        self.dependent.retain(|(row, _)| *row < rows);
        self
    }

    /// Number of independent rows.
    pub(crate) fn value(&self) -> usize {
        self.independent.len()
    }
}

/// Eliminates row by row with the largest entry as pivot (column pivoting), and keeps the combination that made each row.
///
/// Rows that come later are the ones reported as dependent, so locks belong after joints.
pub(crate) fn rank(rows: &[Row]) -> Rank {
    rank_within(rows, TOLERANCE)
}

/// Rank where a row whose entries fall below another share is taken as zero.
pub(super) fn rank_within(rows: &[Row], tolerance: f64) -> Rank {
    let mut reduced: Vec<Reduced> = Vec::new();
    let mut result = Rank { dependent: Vec::new(), independent: Vec::new() };
    for (index, row) in rows.iter().enumerate() {
        let mut current =
            Reduced { pivot: 0, entries: row.clone(), made_of: vec![(index, 1.0)], scale: size(row) };
        for earlier in &reduced {
            current.subtract(earlier);
        }
        match current.entries.iter().copied().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())) {
            Some((column, largest)) if largest.abs() > tolerance * current.scale => {
                current.pivot = column;
                result.independent.push(index);
                reduced.push(current);
            }
            _ => {
                let members = current.made_of.iter().filter(|(_, weight)| weight.abs() > tolerance);
                result.dependent.push((index, members.map(|&(row, _)| row).collect_vec()));
            }
        }
    }
    result
}

/// A row after elimination.
struct Reduced {
    pivot: usize,
    entries: Row,
    /// The combination of original rows that it is.
    made_of: Row,
    /// Largest entry that took part.
    scale: f64,
}

impl Reduced {
    /// Clears the pivot column of `earlier`.
    fn subtract(&mut self, earlier: &Reduced) {
        let entry = |row: &Row| row.binary_search_by_key(&earlier.pivot, |e| e.0).map_or(0.0, |k| row[k].1);
        let here = entry(&self.entries);
        if here == 0.0 {
            return;
        }
        let factor = here / entry(&earlier.entries);
        self.scale = self.scale.max(factor.abs() * size(&earlier.entries));
        self.entries = combined(&self.entries, &earlier.entries, factor);
        self.entries.retain(|e| e.0 != earlier.pivot);
        self.made_of = combined(&self.made_of, &earlier.made_of, factor);
    }
}

/// Largest magnitude of a row.
fn size(row: &Row) -> f64 {
    row.iter().fold(0.0, |largest, e| largest.max(e.1.abs()))
}

/// `a - factor b` of two sorted sparse rows.
fn combined(a: &Row, b: &Row, factor: f64) -> Row {
    let mut sum = Row::with_capacity(a.len() + b.len());
    let (mut i, mut k) = (0, 0);
    while i < a.len() || k < b.len() {
        let left = a.get(i).map_or(usize::MAX, |e| e.0);
        let right = b.get(k).map_or(usize::MAX, |e| e.0);
        let column = left.min(right);
        let mut value = 0.0;
        if left == column {
            value += a[i].1;
            i += 1;
        }
        if right == column {
            value -= factor * b[k].1;
            k += 1;
        }
        sum.push((column, value));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_repeated_row_depends_on_the_first() {
        let rows = [vec![(0, 1.0), (2, -3.0)], vec![(1, 2.0)], vec![(0, 2.0), (2, -6.0)]];
        let found = rank(&rows);
        assert_eq!(found, Rank { dependent: vec![(2, vec![0, 2])], independent: vec![0, 1] });
    }

    #[test]
    fn locks_of_all_coordinates_of_a_pendulum_leave_two_redundant_rows() {
        // x - cos, y - sin of a pendulum at 45 deg, then locks of angle, x and y.
        let h = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
        let rows =
            [vec![(0, 1.0), (2, h)], vec![(1, 1.0), (2, -h)], vec![(2, 1.0)], vec![(0, 1.0)], vec![(1, 1.0)]];
        let found = rank(&rows);
        assert_eq!(found.value(), 3);
        assert_eq!(found.dependent, [(3, vec![0, 2, 3]), (4, vec![1, 2, 4])]);
    }

    /// Two directions that differ by so many radians; a few thousand roundings are no difference.
    #[test]
    fn rows_that_are_nearly_alike_are_two_until_rounding() {
        for (angle, expected) in [(1e-2, 2), (1e-4, 2), (1e-6, 2), (1e-8, 2), (1e-12, 1), (1e-14, 1)] {
            let rows = [vec![(0, 0.6), (1, 0.8)], vec![(0, 0.6 - 0.8 * angle), (1, 0.8 + 0.6 * angle)]];
            assert_eq!(rank(&rows).value(), expected, "{angle:e} rad");
        }
    }

    #[test]
    fn an_empty_matrix_has_rank_zero() {
        assert_eq!(rank(&[]).value(), 0);
        assert_eq!(rank(&[vec![]]).dependent, [(0, vec![0])]);
    }
}
