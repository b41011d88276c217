//! Prefixes of long sums: `a + b + ... + y + z` reads `a + b + ... + y`.
//!
//! Sums that grow step by step arrive flattened: n sums of up to n terms, whose pairs are of the order of n^3. Each
//! becomes its predecessor and what is new in it.

use super::rows::{Item, Kind, Rows, UNIT};
use crate::hash::{Mixer, Table};
use crate::number::Number;

/// Shorter sums are left to [`pairs`](super::pairs), which find more in them.
const LONG: usize = 16;

/// Lets every long sum read the longest other one that it begins with, but for their constants.
pub(super) fn nest(rows: &mut Rows) {
    let mut sums: Vec<Sum> = Vec::new();
    for row in 0..rows.len() {
        if rows.kind(row) == Kind::Sum && rows.items(row).len() > LONG {
            sums.extend(Sum::of(rows, row));
        }
    }
    sums.sort_by_key(|sum| sum.terms.len());
    let mut known = Table::new();
    for sum in &sums {
        known.push(prefixes(&sum.terms)[sum.terms.len() - 1]);
    }
    for (at, sum) in sums.iter().enumerate() {
        let hashes = prefixes(&sum.terms);
        let longest = (LONG..sum.terms.len()).rev().find_map(|len| {
            known.find(hashes[len - 1], |other| other < at && sums[other].terms == sum.terms[..len])
        });
        if let Some(other) = longest {
            sum.read(&sums[other], rows);
        }
    }
}

/// A long sum as it was.
struct Sum {
    row: usize,
    constant: Number,
    /// The coefficient of its first term.
    scale: u32,
    /// Its terms with coefficients divided by that.
    terms: Vec<Item>,
}

impl Sum {
    /// None where its coefficients have no quotients.
    fn of(rows: &mut Rows, row: usize) -> Option<Self> {
        let mut terms = rows.items(row).to_vec();
        let mut constant = Number::ZERO;
        if terms[0].id as usize == UNIT {
            constant = rows.numbers.get(terms.remove(0).coefficient);
        }
        let scale = terms[0].coefficient;
        for term in &mut terms {
            term.coefficient = rows.numbers.ratio(term.coefficient, scale)?;
        }
        Some(Self { row, constant, scale, terms })
    }

    /// Becomes a sum that this one begins with, and what is new.
    fn read(&self, other: &Self, rows: &mut Rows) {
        let coefficient = rows.numbers.quotient(self.scale, other.scale);
        let constant = self.constant + -(rows.numbers.get(coefficient) * other.constant);
        let mut items = Vec::new();
        if !constant.is_zero() {
            items.push(Item { id: UNIT as u32, coefficient: rows.numbers.id(constant) });
        }
        for term in &self.terms[other.terms.len()..] {
            items.push(Item { coefficient: rows.numbers.product(term.coefficient, self.scale), ..*term });
        }
        items.push(Item { id: other.row as u32, coefficient });
        items.sort_unstable();
        rows.shrink(self.row, &items);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::Graph;

    /// Up to its scale, and whatever the constants are.
    #[test]
    fn a_long_sum_reads_the_longest_that_it_begins_with() {
        let mut graph = Graph::new();
        let symbols: Vec<_> = (0..LONG + 4).map(|k| graph.symbol(&format!("x{k}"))).collect();
        let mut sum = |len: usize, scale: i64| {
            let (constant, scale) = (Number::from_int(len as i64), Number::from_int(scale));
            let terms: Vec<_> = symbols[..len].iter().map(|&symbol| (scale, symbol)).collect();
            graph.linear(constant, &terms)
        };
        let sums = [sum(LONG + 1, 1), sum(LONG + 3, 2), sum(LONG + 4, 3)];
        let mut rows = Rows::load(&graph, &sums);
        nest(&mut rows);
        let [shortest, middle, longest] = sums.map(|sum| rows.row_of(sum));
        assert_eq!(rows.items(shortest).len(), LONG + 2);
        let number = |num, den| Number::rational(num, den).unwrap_or(Number::ZERO);
        let new = |k: usize, coefficient| (rows.row_of(symbols[LONG + k]), number(coefficient, 1));
        // The constants are 17, 19 and 20 less what is read: 19 - 2*17, 20 - 3/2*19.
        let second = vec![(UNIT, number(-15, 1)), new(1, 2), new(2, 2), (shortest, number(2, 1))];
        let third = vec![(UNIT, number(-17, 2)), new(3, 3), (middle, number(3, 2))];
        for (row, mut expected) in [(middle, second), (longest, third)] {
            let item = |item: &Item| (item.id as usize, rows.numbers.get(item.coefficient));
            let mut found: Vec<_> = rows.items(row).iter().map(item).collect();
            found.sort_by_key(|item| item.0);
            expected.sort_by_key(|item| item.0);
            assert_eq!(found, expected);
        }
    }
}
