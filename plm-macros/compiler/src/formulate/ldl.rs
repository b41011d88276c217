//! Symbolic sparse `L D L^T` of a symmetric positive definite matrix.
//!
//! Each entry becomes a named atom, so that nothing is ever expanded and the operations stay those of the numeric
//! algorithm (I. S. Duff, A. M. Erisman, J. K. Reid, Direct Methods for Sparse Matrices, 1986, chapter 10).

use std::collections::{BTreeMap, BTreeSet};

use plm_cas::{Expr, algebra};

use super::order::minimum_degree;

/// A symmetric matrix by its lower entries, `(row, column)` with `row >= column`; what is absent is zero.
pub(crate) type Symmetric = BTreeMap<(usize, usize), Expr>;

/// The factors, and what was computed on the way.
#[derive(Debug)]
pub(crate) struct Factor {
    /// Pivots in the order of elimination: row, column of L below it as (row, entry).
    columns: Vec<(usize, Vec<(usize, Expr)>)>,
    /// `1 / d` by row.
    reciprocals: Vec<Expr>,
    /// Every entry in the order of computation.
    pub(crate) trace: Vec<Expr>,
    /// The smallest ratio of a pivot to the diagonal entry that it came from; 1 when nothing cancels.
    pub(crate) health: Expr,
}

/// Factorises `matrix` of size `n`; every diagonal entry must be present. A row whose diagonal entry over its pivot is above
/// `most`, if that is given, depends on rows before it and is left out: its reciprocal is zero.
pub(crate) fn factorise(n: usize, matrix: &Symmetric, most: Option<Expr>) -> Factor {
    let mut near = vec![BTreeSet::new(); n];
    for &(i, j) in matrix.keys().filter(|(i, j)| i != j) {
        near[i].insert(j);
        near[j].insert(i);
    }
    let mut work = Elimination { entries: matrix.clone(), trace: Vec::new() };
    let mut columns = Vec::with_capacity(n);
    let mut reciprocals = vec![Expr::ONE; n];
    let mut worst: Option<Expr> = None;
    for (pivot, below) in minimum_degree(near) {
        let (before, now) = (matrix[&(pivot, pivot)], work.entries[&(pivot, pivot)]);
        let mut reciprocal = work.reciprocal(pivot);
        if now != before {
            let mut growth = growth(before, reciprocal);
            if let Some(most) = most {
                [reciprocal, growth] = work.kept(pivot, most, [reciprocal, growth]);
            }
            // A pivot of zero stands for good: `max` gives its second argument where one of both is NaN, as growths of
            // later pivots may be.
            worst = Some(worst.map_or(growth, |worst| growth.max(worst)));
        }
        let column = work.eliminate(pivot, reciprocal, &below);
        reciprocals[pivot] = reciprocal;
        columns.push((pivot, column));
    }
    let one = Expr::ONE;
    let health = worst.map_or(one, |worst| one / worst);
    Factor { columns, reciprocals, trace: work.trace, health }
}

/// The matrix while it is being eliminated.
struct Elimination {
    entries: Symmetric,
    trace: Vec<Expr>,
}

impl Elimination {
    /// `1 / d`.
    fn reciprocal(&mut self, pivot: usize) -> Expr {
        let d = self.define(&format!("d_{pivot}"), self.entries[&(pivot, pivot)]);
        let one = Expr::ONE;
        let inverse = one / d;
        self.define(&format!("r_{pivot}"), inverse)
    }

    /// The reciprocal of a pivot and its growth; zeros if that is above `most`.
    fn kept(&mut self, pivot: usize, most: Expr, [reciprocal, growth]: [Expr; 2]) -> [Expr; 2] {
        let growth = self.define(&format!("growth_{pivot}"), growth);
        let (depends, zero) = (most.less(growth), Expr::ZERO);
        let [reciprocal, growth] = [reciprocal, growth].map(|value| depends.select(zero, value));
        [self.define(&format!("kept_{pivot}"), reciprocal), growth]
    }

    /// Eliminates one row; returns the column of L below it.
    fn eliminate(&mut self, pivot: usize, reciprocal: Expr, rows: &[usize]) -> Vec<(usize, Expr)> {
        let mut column = Vec::with_capacity(rows.len());
        let mut below = Vec::with_capacity(rows.len());
        for &row in rows {
            let key = (row.max(pivot), row.min(pivot));
            let entry = self.define(&format!("g_{row}_{pivot}"), self.entries[&key]);
            let scaled = entry * reciprocal;
            below.push((row, entry));
            column.push((row, self.define(&format!("l_{row}_{pivot}"), scaled)));
        }
        for (k, &(row, factor)) in column.iter().enumerate() {
            for &(other, entry) in &below[..=k] {
                self.update((row.max(other), row.min(other)), factor, entry);
            }
        }
        column
    }

    /// `entries[key] -= factor * entry`.
    fn update(&mut self, key: (usize, usize), factor: Expr, entry: Expr) {
        let product = factor * entry;
        let old = self.entries.get(&key).copied().unwrap_or(Expr::ZERO);
        let new = old - product;
        self.entries.insert(key, new);
    }

    fn define(&mut self, name: &str, value: Expr) -> Expr {
        let atom = value.named(name);
        self.trace.push(atom);
        atom
    }
}

impl Factor {
    /// Solves `L D L^T lambda = rhs`; `names` are those of the solution. Returns it and every step on the way.
    pub(crate) fn solve(&self, rhs: &[Expr], names: &[String]) -> (Vec<Expr>, Vec<Expr>) {
        let mut trace = Vec::new();
        let mut b = rhs.to_vec();
        for &(pivot, ref column) in &self.columns {
            b[pivot] = b[pivot].named(format!("b_{pivot}"));
            trace.push(b[pivot]);
            for &(row, factor) in column {
                let product = factor * b[pivot];
                b[row] -= product;
            }
        }
        let mut solution = b.clone();
        for &(pivot, ref column) in self.columns.iter().rev() {
            let mut terms = vec![b[pivot] * self.reciprocals[pivot]];
            for &(row, factor) in column {
                let product = factor * solution[row];
                terms.push(-product);
            }
            let value = algebra::sum(&terms);
            solution[pivot] = value.named(&names[pivot]);
            trace.push(solution[pivot]);
        }
        (solution, trace)
    }
}

/// `|diagonal / pivot|`.
fn growth(diagonal: Expr, reciprocal: Expr) -> Expr {
    let growth = diagonal * reciprocal;
    growth.abs()
}
