//! The signals of forces that read accelerations and multipliers.
//!
//! With `s = s_0 + S s`, `s_0` being the signals of the motion without feedback and column j of `S` those of a unit of signal
//! j alone, `(I - S) s = s_0`: a bordered solution of the linear system with its factors as they are
//! (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, section 2.1.4, Sherman-Morrison-Woodbury). It is
//! eliminated by the rows in their order, without pivoting:
//!
//! ```text
//! (1)  l_ik = m_ik / m_kk,   m_ij <- m_ij - l_ik m_kj,   s_i <- s_i - l_ik s_k     k < i, k < j
//! (2)  s_k  = (s_k - sum_{j > k} m_kj s_j) / m_kk
//! ```

use crate::collect::CollectVec;
use plm_cas::Expr;

/// The signals, and how far the smallest pivot is from having cancelled.
pub(super) struct Solved {
    pub(super) signals: Vec<Expr>,
    /// The smallest `|m_kk| / (1 + |S_kk|)`; 1 where nothing cancels.
    pub(super) health: Expr,
    /// Every step on the way.
    pub(super) trace: Vec<Expr>,
}

/// Solves `(I - S) s = s_0` by elimination; `units[j]` is column j of `S`.
pub(super) fn solve(s_0: Vec<Expr>, units: &[Vec<Expr>]) -> Solved {
    let n = s_0.len();
    let mut trace = Vec::new();
    let entry = |i: usize, j: usize| {
        let identity = if i == j { Expr::ONE } else { Expr::ZERO };
        (identity - units[j][i]).named(format!("loop_{i}_{j}"))
    };
    let mut m: Vec<Vec<Expr>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect_vec()).collect_vec();
    trace.extend(m.iter().flatten());
    let mut s = s_0;
    let mut health = Expr::ONE;
    for k in 0..n {
        health = health.min(m[k][k].abs() / (1 + units[k][k].abs()));
        for i in k + 1..n {
            let l = (m[i][k] / m[k][k]).named(format!("loop_l_{i}_{k}")); // (1)
            trace.push(l);
            for j in k + 1..n {
                m[i][j] = m[i][j] - l * m[k][j];
            }
            s[i] = s[i] - l * s[k];
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            s[k] = s[k] - m[k][j] * s[j]; // (2)
        }
        s[k] = (s[k] / m[k][k]).named(format!("signal_{k}"));
        trace.push(s[k]);
    }
    Solved { signals: s, health, trace }
}

#[cfg(test)]
mod tests {
    use plm_cas::{Expr, Number};

    use super::solve;
    use crate::numeric::value;

    fn numbers(values: &[f64]) -> Vec<Expr> {
        values.iter().map(|&value| Number::from_f64(value).into()).collect()
    }

    /// With `S = (0.5, 0.25; -1, 0.25)` and `s = (2, 4)`, `s_0 = (I - S) s = (0, 5)`.
    #[test]
    fn two_signals_that_feed_each_other_are_solved() {
        let units = [numbers(&[0.5, -1.0]), numbers(&[0.25, 0.25])];
        let solved = solve(numbers(&[0.0, 5.0]), &units);
        let s: Vec<f64> = solved.signals.iter().map(|&s| value(s, &[])).collect();
        assert_eq!(s, [2.0, 4.0]);
    }

    /// `s = s_0 + s` has no solution.
    #[test]
    fn a_signal_that_feeds_itself_fully_has_no_health() {
        let solved = solve(numbers(&[1.0]), &[numbers(&[1.0])]);
        assert_eq!(value(solved.health, &[]), 0.0);
    }
}
