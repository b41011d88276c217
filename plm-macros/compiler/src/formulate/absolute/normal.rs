//! The normal equations of the constraints under weights: `Y = phi_q W` and `S = phi_q W phi_q^T`.
//!
//! With `W = M^-1` they give the multipliers; with weights of assembly and projection the weighted minimum-norm solution
//! of `phi_q dq = r`:
//!
//! ```text
//! (1)  S mu = r
//! (2)  dq   = Y^T mu
//! ```
//!
//! (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, section 5.6.)

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::Expr;

use crate::derive::{Equations, SparseRow};
use crate::formulate::function::{Function, Place, Section, stored};
use crate::formulate::ldl::{Symmetric, factorise};

/// The normal equations of the constraints.
pub(super) struct Normal {
    /// `Y = phi_q W`, by rows.
    pub(super) y: Vec<SparseRow>,
    /// `S = Y phi_q^T`.
    pub(super) s: Symmetric,
}

impl Normal {
    /// Sets them up for weights by coordinate, the diagonal of `W`.
    pub(super) fn new(phi_q: &[SparseRow], weights: &[Expr]) -> Normal {
        let mut by_column: Vec<Vec<(usize, Expr)>> = vec![Vec::new(); weights.len()];
        let mut y: Vec<SparseRow> = Vec::with_capacity(phi_q.len());
        for (i, row) in phi_q.iter().enumerate() {
            let weighted =
                row.iter().map(|&(j, entry)| (j, (entry * weights[j]).named(format!("y_{i}_{j}"))));
            y.push(weighted.collect_vec());
            for &(j, entry) in row {
                by_column[j].push((i, entry));
            }
        }
        let mut terms: SortedMap<(usize, usize), Vec<Expr>> = SortedMap::new();
        for (i, row) in y.iter().enumerate() {
            for &(j, y_ij) in row {
                for &(k, entry) in by_column[j].iter().filter(|&&(k, _)| k <= i) {
                    terms.or_insert((i, k), Vec::new()).push(y_ij * entry);
                }
            }
        }
        let mut s: Symmetric = terms.into_iter().map(|(key, terms)| (key, terms.iter().sum())).collect();
        s.retain(|&(i, k), entry| i == k || !entry.is_zero());
        for i in 0..phi_q.len() {
            s.or_insert((i, i), Expr::ZERO);
        }
        Normal { y, s }
    }

    /// `Y^T lambda`, by coordinate.
    pub(super) fn transposed(&self, lambda: &[Expr], coordinates: usize) -> Vec<Expr> {
        let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); coordinates];
        for (row, &lambda_i) in self.y.iter().zip(lambda) {
            for &(j, y_ij) in row {
                terms[j].push(y_ij * lambda_i);
            }
        }
        terms.iter().map(|terms| terms.iter().sum()).collect_vec()
    }
}

/// The weighted minimum-norm step: of assembly with weights 0 and 1, of projection with weights 1 / mass.
pub(super) fn min_norm(equations: &Equations, weights: &[Expr], r: &[Expr], most_growth: Expr) -> Function {
    let normal = Normal::new(&equations.phi_q, weights);
    let factor = factorise(equations.phi.len(), &normal.s, Some(most_growth));
    let names: Vec<String> = (0..r.len()).map(|k| format!("mu_{k}")).collect_vec();
    let (mu, solution) = factor.solve(r, &names); // (1)
    let dq = normal.transposed(&mu, weights.len()); // (2)
    let mut results = stored("dq", dq.iter());
    results.push((Place::Value, factor.health));
    let sections = vec![
        Section::new("phi_q W phi_q^T = L D L^T", factor.trace),
        Section::new("(phi_q W phi_q^T) mu = r", solution),
    ];
    Function { sections, results }
}
