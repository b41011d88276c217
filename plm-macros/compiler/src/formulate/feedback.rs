//! The signals of forces that read accelerations and multipliers.
//!
//! With `s = s_0 + S s`, `s_0` being the signals of the motion without feedback and column j of `S` those of a unit of signal
//! j alone, `(I - S) s = s_0`: a bordered solution of the linear system with its factors as they are
//! (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, section 2.1.4, Sherman-Morrison-Woodbury).

use plm_cas::Expr;

/// The signals, and how far the smallest pivot is from having cancelled.
pub(super) struct Solved {
    pub(super) signals: Vec<Expr>,
    pub(super) health: Expr,
    /// Every step on the way.
    pub(super) trace: Vec<Expr>,
}

/// Solves `(I - S) s = s_0` by elimination; `unit[j]` is column j of `S`.
pub(super) fn solve(free: &[Expr], unit: &[Vec<Expr>]) -> Solved {
    let n = free.len();
    let one = Expr::ONE;
    let mut trace = Vec::new();
    let mut matrix: Vec<Vec<Expr>> = Vec::with_capacity(n);
    for i in 0..n {
        let row = (0..n).map(|j| {
            let identity = if i == j { one } else { Expr::ZERO };
            let entry = identity - unit[j][i];
            entry.named(format!("loop_{i}_{j}"))
        });
        matrix.push(row.collect());
        trace.extend(&matrix[i]);
    }
    let mut s = free.to_vec();
    let mut health = one;
    for k in 0..n {
        let pivot = matrix[k][k];
        let (size, gain) = (pivot.abs(), unit[k][k].abs());
        let range = one + gain;
        let ratio = size / range;
        health = health.min(ratio);
        for i in k + 1..n {
            let factor = matrix[i][k] / pivot;
            let factor = factor.named(format!("loop_l_{i}_{k}"));
            trace.push(factor);
            for j in k + 1..n {
                matrix[i][j] = less(matrix[i][j], factor, matrix[k][j]);
            }
            s[i] = less(s[i], factor, s[k]);
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            s[k] = less(s[k], matrix[k][j], s[j]);
        }
        let value = s[k] / matrix[k][k];
        s[k] = value.named(format!("signal_{k}"));
        trace.push(s[k]);
    }
    Solved { signals: s, health, trace }
}

/// `a - b c`
fn less(a: Expr, b: Expr, c: Expr) -> Expr {
    let product = b * c;
    a - product
}
