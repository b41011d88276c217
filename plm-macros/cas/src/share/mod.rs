//! Common subexpressions of several expressions, computed once.
//!
//! Hash-consing shares equal nodes; flat sums and products hide what they share inside: `x + a - b` and `a - b`.
//! The pass works on flat rows of items (see `rows`) in steps, each of which lowers the count of operations:
//! coefficients go into sums; long sums read those that they begin with; pairs of terms, or of factors, that occur in several rows become rows of their own,
//! the most frequent first (M. A. Breuer, "Generation of optimal code for expressions via factorization", Comm. ACM
//! 12 (1969), 333-340); common factors leave the terms of a sum; a divisor of several quotients is inverted once.
//!
//! The result is in shared form: sums may stand in sums and products in products. Its values differ from those of
//! the input by rounding only. It is meant for a [`Tape`](crate::Tape); constructors that take it flatten it again.

mod factor;
mod pairs;
mod prefixes;
mod rebuild;
mod rows;
mod scale;

use crate::graph::Graph;
use crate::node::Expr;
use rows::{Item, Kind, Rows, base, divides, literal};

/// Rewrites `roots` so that they compute less: the same values, in the same order.
pub fn share(graph: &mut Graph, roots: &[Expr]) -> Vec<Expr> {
    let mut rows = Rows::load(graph, roots);
    scale::distribute(&mut rows);
    prefixes::nest(&mut rows);
    pairs::extract(&mut rows, Kind::Sum); // before factors leave: they would take shared terms apart
    factor::factor_sums(&mut rows);
    pairs::extract(&mut rows, Kind::Product);
    pairs::extract(&mut rows, Kind::Sum); // the sums that factors left behind
    invert_divisors(&mut rows);
    rows.inline_single_uses();
    rebuild::rebuild(graph, &rows)
}

/// A divisor of two or more quotients becomes a factor: one division and n products cost less than n divisions.
fn invert_divisors(rows: &mut Rows) {
    const WORTH_IT: u32 = 2;
    let mut quotients = vec![0_u32; rows.len()];
    let mut inverse_of: Vec<Option<usize>> = vec![None; rows.len()];
    let products: Vec<usize> = (0..rows.len()).filter(|&row| rows.kind(row) == Kind::Product).collect();
    for &row in &products {
        let items = rows.items(row);
        for i in 0..items.len() {
            if divides(items[i].id) && (i == 0 || items[i - 1].id != items[i].id) {
                quotients[base(items[i].id)] += 1;
                if items.len() == 1 {
                    inverse_of[base(items[i].id)] = Some(row);
                }
            }
        }
    }
    for &row in &products {
        for i in 0..rows.items(row).len() {
            let id = rows.items(row)[i].id;
            let divisor = base(id);
            if !divides(id) || quotients[divisor] < WORTH_IT || inverse_of[divisor] == Some(row) {
                continue;
            }
            let inverse = match inverse_of[divisor] {
                Some(known) => known,
                None => rows.push(Kind::Product, &[Item { id, coefficient: 0 }]),
            };
            inverse_of[divisor] = Some(inverse);
            rows.items_mut(row)[i].id = literal(inverse as u32, false);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `1/(x*y)` is not `x*y`, though only one product reads it.
    #[test]
    fn a_product_that_divides_keeps_its_row() {
        let mut graph = Graph::new();
        let symbols = ["a", "x", "y"].map(|name| graph.symbol(name));
        let mut rows = Rows::load(&graph, &symbols);
        let [a, x, y] = symbols.map(|symbol| rows.row_of(symbol) as u32);
        let item = |row: u32, divides: bool| Item { id: literal(row, divides), coefficient: 0 };
        let inner = rows.push(Kind::Product, &[item(x, false), item(y, false)]) as u32;
        for divides in [true, false] {
            let outer = rows.push(Kind::Product, &[item(a, false), item(inner, divides)]);
            rows.roots = vec![outer as u32];
            rows.inline_single_uses();
            let expected = if divides { 2 } else { 3 };
            assert_eq!(rows.items(outer).len(), expected, "{:?}", rows.items(outer));
            rows.items_mut(outer)[1] = item(a, false);
        }
    }
}
