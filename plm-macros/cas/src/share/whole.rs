//! Long sums that begin with another sum: `a + b + ... + y + z` reads `a + b + ... + y`.
//!
//! What is summed up step by step arrives flattened: n sums of up to n terms, whose pairs are of the order of n^3. Each
//! becomes its predecessor and what is new in it.

use super::rows::{Item, Kind, Rows};
use crate::hash::{Mixer, Table};

/// Shorter sums are left to [`pairs`](super::pairs), which find more in them.
const LONG: usize = 16;

/// Lets every long sum read the longest other one that it begins with.
pub(super) fn nest(rows: &mut Rows) {
    let mut sums: Vec<Sum> = Vec::new();
    for row in 0..rows.len() {
        if rows.kind(row) == Kind::Sum && rows.items(row).len() >= LONG {
            sums.push(Sum::of(rows, row));
        }
    }
    sums.sort_by_key(|sum| sum.items.len());
    let mut known = Table::new();
    for sum in &sums {
        known.push(prefixes(&sum.items)[sum.items.len() - 1]);
    }
    for (at, sum) in sums.iter().enumerate() {
        let hashes = prefixes(&sum.items);
        let longest = (LONG..sum.items.len()).rev().find_map(|len| {
            known.find(hashes[len - 1], |other| other < at && sums[other].items == sum.items[..len])
        });
        if let Some(other) = longest.map(|other| &sums[other]) {
            let coefficient = rows.numbers.quotient(sum.scale, other.scale);
            rows.replace_first(sum.row, other.items.len(), Item { id: other.row as u32, coefficient });
        }
    }
}

/// A long sum as it was.
struct Sum {
    row: usize,
    /// The coefficient of its first item.
    scale: u32,
    /// Its items with coefficients divided by that.
    items: Vec<Item>,
}

impl Sum {
    fn of(rows: &mut Rows, row: usize) -> Self {
        let mut items = rows.items(row).to_vec();
        let scale = items[0].coefficient;
        for item in &mut items {
            item.coefficient = rows.numbers.quotient(item.coefficient, scale);
        }
        Self { row, scale, items }
    }
}

/// The hash of each beginning of a sum.
fn prefixes(items: &[Item]) -> Vec<u32> {
    let mut mixer = Mixer::new(0);
    let hash = |item: &Item| {
        mixer.word(u64::from(item.id) << 32 | u64::from(item.coefficient));
        mixer.finish()
    };
    items.iter().map(hash).collect()
}
