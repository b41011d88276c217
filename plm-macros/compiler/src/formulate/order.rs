//! The order of elimination of a sparse symmetric matrix.

use crate::collect::CollectVec;
use crate::sorted::SortedSet;

/// A row to eliminate and the rows that it still meets then, ascending: the rows of its column of L.
pub(crate) type Pivot = (usize, Vec<usize>);

/// Minimum degree: eliminates the row with the fewest neighbours first, the lowest index among equals.
///
/// `neighbours[i]` holds the rows that share an entry with row `i`; fill is followed. Along a chain the fill is none and the operations
/// grow linearly (W. F. Tinney, J. W. Walker, Direct solutions of sparse network equations by optimally ordered
/// triangular factorization, Proc. IEEE 55, 1967, scheme 2).
pub(crate) fn minimum_degree(neighbours: Vec<SortedSet<usize>>) -> impl Iterator<Item = Pivot> {
    let after = vec![SortedSet::new(); neighbours.len()];
    minimum_degree_after(neighbours, after)
}

/// Minimum degree where row `i` has to wait until those of `after[i]` are eliminated, all of which are its neighbours and wait for
/// nothing.
fn minimum_degree_after(
    mut neighbours: Vec<SortedSet<usize>>,
    mut after: Vec<SortedSet<usize>>,
) -> impl Iterator<Item = Pivot> {
    let free = after.iter().enumerate().filter(|(_, after)| after.is_empty());
    let mut waiting: SortedSet<(usize, usize)> = free.map(|(row, _)| (neighbours[row].len(), row)).collect();
    std::iter::from_fn(move || {
        let (_, row) = waiting.pop_first()?;
        let near: Vec<usize> = std::mem::take(&mut neighbours[row]).into_iter().collect_vec();
        for &other in &near {
            waiting.remove(&(neighbours[other].len(), other));
            neighbours[other].remove(&row);
            after[other].remove(&row);
            neighbours[other].extend(near.iter().copied().filter(|&third| third != other));
            if after[other].is_empty() {
                waiting.insert((neighbours[other].len(), other));
            }
        }
        Some((row, near))
    })
}

/// Minimum degree of the symmetric pattern that holds these entries, (row, column) of `count`; rows from `first` on after all
/// that they meet.
pub(crate) fn minimum_degree_of(
    count: usize,
    first: usize,
    entries: impl Iterator<Item = (usize, usize)>,
) -> Vec<usize> {
    let mut near = vec![SortedSet::new(); count];
    for (row, column) in entries.filter(|(row, column)| row != column) {
        near[row].insert(column);
        near[column].insert(row);
    }
    let after = near.iter().enumerate();
    let after =
        after.map(|(row, near)| if row < first { SortedSet::new() } else { near.clone() }).collect_vec();
    minimum_degree_after(near, after).map(|(pivot, _)| pivot).collect_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(n: usize, edges: &[(usize, usize)]) -> Vec<SortedSet<usize>> {
        let mut near = vec![SortedSet::new(); n];
        for &(a, b) in edges {
            near[a].insert(b);
            near[b].insert(a);
        }
        near
    }

    #[test]
    fn leaves_of_a_star_go_before_its_centre() {
        let mut order = minimum_degree(graph(5, &[(2, 0), (2, 1), (2, 3), (2, 4)]));
        assert!(order.position(|pivot| pivot.0 == 2) >= Some(3));
    }

    #[test]
    fn every_row_is_eliminated_once() {
        let order = minimum_degree(graph(6, &[(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)]));
        let mut rows: Vec<usize> = order.map(|pivot| pivot.0).collect();
        rows.sort_unstable();
        assert_eq!(rows, [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn fill_of_a_ring_is_followed() {
        let order: Vec<Pivot> = minimum_degree(graph(4, &[(0, 1), (1, 2), (2, 3), (3, 0)])).collect();
        assert_eq!(order, [(0, vec![1, 3]), (1, vec![2, 3]), (2, vec![3]), (3, vec![])]);
    }
}
