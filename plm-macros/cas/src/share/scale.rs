//! Coefficients before sums go into the sum where that costs nothing: `100*(2*a + 3*b)` is `200*a + 300*b`.

use super::rows::{Kind, Numbers, Rows, UNIT, base, divides};

/// Multiplies coefficients into sums that have no term without one, and that nobody else reads.
pub(super) fn distribute(rows: &mut Rows) {
    let uses = rows.uses();
    for row in 0..rows.len() {
        if rows.kind(row) != Kind::Sum {
            continue;
        }
        for i in 0..rows.items(row).len() {
            let item = rows.items(row)[i];
            if item.id as usize == UNIT || Numbers::is_unit(item.coefficient) {
                continue;
            }
            if let Some(sum) = sum_within(rows, item.id as usize, &uses) {
                multiply(rows, sum, item.coefficient);
                rows.items_mut(row)[i].coefficient = Numbers::ONE;
            }
        }
    }
}

/// The row itself, or a factor of it, that is a sum as described above.
fn sum_within(rows: &Rows, row: usize, uses: &[u32]) -> Option<usize> {
    let takes = |row: usize| {
        let is_free_sum = rows.kind(row) == Kind::Sum && uses[row] == 1 && !rows.named(row);
        let costs = |id: u32, coefficient: u32| id as usize != UNIT && Numbers::is_unit(coefficient);
        is_free_sum && !rows.items(row).iter().any(|item| costs(item.id, item.coefficient))
    };
    if takes(row) {
        return Some(row);
    }
    if rows.kind(row) != Kind::Product || uses[row] != 1 || rows.named(row) {
        return None;
    }
    rows.items(row)
        .iter()
        .find(|factor| !divides(factor.id) && takes(base(factor.id)))
        .map(|factor| base(factor.id))
}

fn multiply(rows: &mut Rows, sum: usize, coefficient: u32) {
    for i in 0..rows.items(sum).len() {
        let product = rows.numbers.product(coefficient, rows.items(sum)[i].coefficient);
        rows.items_mut(sum)[i].coefficient = product;
    }
}
