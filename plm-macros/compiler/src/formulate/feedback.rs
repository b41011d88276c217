//! The signals of forces that read accelerations and multipliers.
//!
//! With `s = s_0 + S s`, `s_0` being the signals of the motion without feedback and column j of `S` those of a unit of signal
//! j alone, `(I - S) s = s_0`: a bordered solution of the linear system with its factors as they are
//! (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, section 2.1.4, Sherman-Morrison-Woodbury).

use plm_cas::{Expr, Graph};

/// The signals, and how far the smallest pivot is from having cancelled.
pub(super) struct Solved {
    pub(super) signals: Vec<Expr>,
    pub(super) health: Expr,
    /// Every step on the way.
    pub(super) trace: Vec<Expr>,
}

/// Solves `(I - S) s = s_0` by elimination; `unit[j]` is column j of `S`.
pub(super) fn solve(free: &[Expr], unit: &[Vec<Expr>], graph: &mut Graph) -> Solved {
    let n = free.len();
    let one = graph.one();
    let mut trace = Vec::new();
    let mut matrix: Vec<Vec<Expr>> = Vec::with_capacity(n);
    for i in 0..n {
        let row = (0..n).map(|j| {
            let identity = if i == j { one } else { graph.zero() };
            let entry = graph.sub(identity, unit[j][i]);
            graph.define(&format!("loop_{i}_{j}"), entry)
        });
        matrix.push(row.collect());
        trace.extend(&matrix[i]);
    }
    let mut s = free.to_vec();
    let mut health = one;
    for k in 0..n {
        let pivot = matrix[k][k];
        let (size, gain) = (graph.abs(pivot), graph.abs(unit[k][k]));
        let range = graph.add(one, gain);
        let ratio = graph.div(size, range);
        health = graph.min(health, ratio);
        for i in k + 1..n {
            let factor = graph.div(matrix[i][k], pivot);
            let factor = graph.define(&format!("loop_l_{i}_{k}"), factor);
            trace.push(factor);
            for j in k + 1..n {
                matrix[i][j] = less(matrix[i][j], factor, matrix[k][j], graph);
            }
            s[i] = less(s[i], factor, s[k], graph);
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            s[k] = less(s[k], matrix[k][j], s[j], graph);
        }
        let value = graph.div(s[k], matrix[k][k]);
        s[k] = graph.define(&format!("signal_{k}"), value);
        trace.push(s[k]);
    }
    Solved { signals: s, health, trace }
}

/// `a - b c`
fn less(a: Expr, b: Expr, c: Expr, graph: &mut Graph) -> Expr {
    let product = graph.mul(b, c);
    graph.sub(a, product)
}
