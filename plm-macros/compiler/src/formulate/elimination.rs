//! The elimination of linearised equations as tables of numbers, for whoever writes them.

use crate::collect::PushAll;

use super::linearised::{Augmented, Part, Term};

/// Places of the entries and the order of elimination: numbers in rows, as the runtime's `compact` has them.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Five numbers of each term: coefficient, row, column, entry, part.
    pub terms: Vec<u32>,
    /// Seven of each pivot: row, entry, where its parts of `below` and `right` begin and end, where that of `targets` begins.
    pub pivots: Vec<u32>,
    /// Three of each entry below a pivot: row, entry, the entry across.
    pub below: Vec<u32>,
    /// Two of each entry right of a pivot: unknown, entry.
    pub right: Vec<u32>,
    /// Entries that elimination changes.
    pub targets: Vec<u32>,
}

impl Elimination {
    pub(crate) fn of(augmented: &Augmented) -> Elimination {
        let Augmented { terms, pattern, .. } = augmented;
        let place = |row: usize, column: usize| pattern.places.get(&(row, column)).map(|place| *place as u32);
        let mut tables = Elimination::default();
        for Term { coefficient, row, column, part } in terms {
            let entry = place(*row, *column).unwrap_or_default();
            let numbers = [*coefficient as u32, *row as u32, *column as u32, entry, number_of(*part)];
            tables.terms.extend_from_slice(&numbers);
        }
        let Elimination { pivots, below, right, targets, .. } = &mut tables;
        for pivot in &pattern.pivots {
            let row = pivot.row;
            let (first_below, first_right) = ((below.len() / 3) as u32, (right.len() / 2) as u32);
            let first_target = targets.len() as u32;
            for &lower in &pivot.below {
                let entry = place(lower, row).unwrap_or_default();
                below.extend_from_slice(&[lower as u32, entry, place(row, lower).unwrap_or(u32::MAX)]);
                targets.push_all(pivot.right.iter().filter_map(|&column| place(lower, column)));
            }
            for &column in &pivot.right {
                right.extend_from_slice(&[column as u32, place(row, column).unwrap_or_default()]);
            }
            let (last_below, last_right) = ((below.len() / 3) as u32, (right.len() / 2) as u32);
            let entry = place(row, row).unwrap_or_default();
            let ends = [first_below, last_below, first_right, last_right];
            pivots.extend_from_slice(&[row as u32, entry]);
            pivots.extend_from_slice(&ends);
            pivots.push(first_target);
        }
        tables
    }
}

fn number_of(part: Part) -> u32 {
    match part {
        Part::Value => 0,
        Part::Rate => 1,
        Part::Position => 2,
        Part::Velocity => 3,
        Part::Acceleration => 4,
    }
}
