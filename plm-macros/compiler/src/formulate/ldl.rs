//! Symbolic sparse `L D L^T` of a symmetric positive definite matrix.
//!
//! ```text
//! (1)  d_p = s_pp,   l_ip = s_ip / d_p,   s_ij <- s_ij - l_ip s_jp     for rows i, j below the pivot p
//! (2)  L b = rhs
//! (3)  L^T x = D^-1 b
//! ```
//!
//! Each entry becomes a named atom, so that nothing is ever expanded and the operations stay those of the numeric
//! algorithm (I. S. Duff, A. M. Erisman, J. K. Reid, Direct Methods for Sparse Matrices, 1986, chapter 10).

use crate::collect::MapEach;
use crate::sorted::{SortedMap, SortedSet};

use plm_cas::Expr;

use super::order::minimum_degree;

/// A symmetric matrix by its lower entries, `(row, column)` with `row >= column`; what is absent is zero.
pub(crate) type Symmetric = SortedMap<(usize, usize), Expr>;

/// The factors, and what was computed on the way.
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
    let mut near = vec![SortedSet::new(); n];
    for &(i, j) in matrix.keys().filter(|(i, j)| i != j) {
        near[i].insert(j);
        near[j].insert(i);
    }
    let mut work = Elimination { s: matrix.clone(), trace: Vec::new() };
    let mut columns = Vec::with_capacity(n);
    let mut reciprocals = vec![Expr::ONE; n];
    let mut worst: Option<Expr> = None;
    for (pivot, below) in minimum_degree(near) {
        let (before, now) = (matrix[&(pivot, pivot)], work.s[&(pivot, pivot)]);
        let d = work.named(now, format!("d_{pivot}"));
        let mut reciprocal = work.named(1 / d, format!("r_{pivot}"));
        if now != before {
            let mut growth = (before * reciprocal).abs();
            if let Some(most) = most {
                growth = work.named(growth, format!("growth_{pivot}"));
                let depends = most.less(growth);
                let [kept, of_kept] =
                    [reciprocal, growth].map_each(|value| depends.select(Expr::ZERO, value));
                reciprocal = work.named(kept, format!("kept_{pivot}"));
                growth = of_kept;
            }
            // A pivot of zero stands for good: `max` gives its second argument where one of both is NaN, as growths of
            // later pivots may be.
            worst = Some(worst.map_or(growth, |worst| growth.max(worst)));
        }
        columns.push((pivot, work.eliminate(pivot, reciprocal, &below)));
        reciprocals[pivot] = reciprocal;
    }
    let health = worst.map_or(Expr::ONE, Expr::recip);
    Factor { columns, reciprocals, trace: work.trace, health }
}

/// The matrix while it is being eliminated.
struct Elimination {
    s: Symmetric,
    trace: Vec<Expr>,
}

impl Elimination {
    /// (1) for one pivot, from `1 / d_p`; returns the column of L below it.
    fn eliminate(&mut self, p: usize, reciprocal: Expr, below: &[usize]) -> Vec<(usize, Expr)> {
        let lower = |i: usize, j: usize| (i.max(j), i.min(j));
        let mut s_p = Vec::with_capacity(below.len());
        let mut l_p = Vec::with_capacity(below.len());
        for &i in below {
            let s_ip = self.named(self.s[&lower(i, p)], format!("g_{i}_{p}"));
            s_p.push((i, s_ip));
            l_p.push((i, self.named(s_ip * reciprocal, format!("l_{i}_{p}"))));
        }
        for (k, &(i, l_ip)) in l_p.iter().enumerate() {
            for &(j, s_jp) in &s_p[..=k] {
                let s_ij = self.s.or_insert(lower(i, j), Expr::ZERO);
                *s_ij -= l_ip * s_jp;
            }
        }
        l_p
    }

    fn named(&mut self, value: Expr, name: String) -> Expr {
        let atom = value.named(name);
        self.trace.push(atom);
        atom
    }
}

impl Factor {
    /// Solves `L D L^T x = rhs`; `names` are those of the solution. Returns it and every step on the way.
    pub(crate) fn solve(&self, rhs: &[Expr], names: &[String]) -> (Vec<Expr>, Vec<Expr>) {
        let mut trace = Vec::new();
        let mut b = rhs.to_vec();
        for &(p, ref l_p) in &self.columns {
            b[p] = b[p].named(format!("b_{p}"));
            trace.push(b[p]);
            for &(i, l_ip) in l_p {
                b[i] = b[i] - l_ip * b[p]; // (2)
            }
        }
        let mut x = b.clone();
        for &(p, ref l_p) in self.columns.iter().rev() {
            let from_d = b[p] * self.reciprocals[p];
            let from_l: Expr = l_p.iter().map(|&(i, l_ip)| l_ip * x[i]).sum();
            x[p] = (from_d - from_l).named(&names[p]); // (3)
            trace.push(x[p]);
        }
        (x, trace)
    }
}

#[cfg(test)]
mod tests {
    use plm_cas::{Expr, Number};

    use super::{Symmetric, factorise};
    use crate::numeric::value;

    /// The solution of a symmetric system by its lower entries, and Health.
    fn solved(lower: &[(usize, usize, i64)], rhs: &[i64], most: Option<f64>) -> (Vec<f64>, f64) {
        let matrix: Symmetric = lower.iter().map(|&(i, j, entry)| ((i, j), Expr::from(entry))).collect();
        let factor = factorise(rhs.len(), &matrix, most.map(|most| Number::from_f64(most).into()));
        let rhs: Vec<Expr> = rhs.iter().map(|&of| Expr::from(of)).collect();
        let names: Vec<String> = (0..rhs.len()).map(|k| format!("x_{k}")).collect();
        let (x, _) = factor.solve(&rhs, &names);
        (x.iter().map(|&x| value(x, &[])).collect(), value(factor.health, &[]))
    }

    /// A ring of four, so that there is fill: the right-hand side is the matrix times (1, 2, 3, 4).
    #[test]
    fn a_ring_is_solved() {
        let ring =
            [(0, 0, 4), (1, 1, 4), (2, 2, 4), (3, 3, 4), (1, 0, -1), (2, 1, -1), (3, 2, -1), (3, 0, -1)];
        let (x, health) = solved(&ring, &[-2, 4, 6, 12], None);
        for (x, expected) in x.iter().zip([1.0, 2.0, 3.0, 4.0]) {
            assert!((x - expected).abs() < 1e-14, "{x} for {expected}");
        }
        // The pivots are 4, 15/4, 56/15 and 24/7: their product is the determinant of this circulant, 192.
        assert!((health - 24.0 / 7.0 / 4.0).abs() < 1e-15, "{health}");
    }

    /// Both rows say `x_0 + x_1 = 3`: the later one is left out, its unknown is zero.
    #[test]
    fn a_row_that_repeats_another_is_left_out() {
        let (x, health) = solved(&[(0, 0, 1), (1, 0, 1), (1, 1, 1)], &[3, 3], Some(1e12));
        assert_eq!(x, [3.0, 0.0]);
        assert!(health > 0.0, "{health}");
    }
}
