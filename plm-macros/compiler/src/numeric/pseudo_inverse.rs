//! Minimum-norm least-squares solution of a small dense system, the compiler's twin of the runtime's.

use crate::collect::CollectVec;

/// Singular values below this share of the largest count as zero.
const TOLERANCE: f64 = 1e-9;
/// Rotations converge quadratically; ten sweeps are usual.
const MOST_SWEEPS: usize = 40;

/// `pinv(matrix) rhs`, by one-sided Jacobi rotations of the rows.
///
/// The rows are rotated until they are orthogonal: `U^T A = S V^T`, then `x = V S^+ U^T b`
/// (M. R. Hestenes, Inversion of matrices by biorthogonalization and related results, J. SIAM 6, 1958).
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut rhs: Vec<f64>) -> Vec<f64> {
    let columns = matrix.first().map_or(0, Vec::len);
    for _ in 0..MOST_SWEEPS {
        if !sweep(&mut matrix, &mut rhs) {
            break;
        }
    }
    let squares: Vec<f64> = matrix.iter().map(|row| dot(row, row)).collect_vec();
    let largest = squares.iter().fold(0.0_f64, |a, &b| a.max(b));
    let mut solution = vec![0.0; columns];
    for ((row, &square), &b) in matrix.iter().zip(&squares).zip(&rhs) {
        if square > TOLERANCE * TOLERANCE * largest {
            let weight = b / square;
            for (x, &entry) in solution.iter_mut().zip(row) {
                *x += weight * entry;
            }
        }
    }
    solution
}

/// Rotates every pair of rows once; says whether any was not orthogonal yet.
fn sweep(matrix: &mut [Vec<f64>], rhs: &mut [f64]) -> bool {
    let mut rotated = false;
    for j in 1..matrix.len() {
        for i in 0..j {
            let (head, tail) = matrix.split_at_mut(j);
            let (a, b) = (&mut head[i], &mut tail[0]);
            let (alpha, beta, gamma) = (dot(a, a), dot(b, b), dot(a, b));
            if gamma.abs() <= 1e-15 * (alpha * beta).sqrt() || gamma == 0.0 {
                continue;
            }
            rotated = true;
            let zeta = (beta - alpha) / (2.0 * gamma);
            let t = zeta.signum() / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
            let c = 1.0 / (1.0 + t * t).sqrt();
            let s = c * t;
            for (x, y) in a.iter_mut().zip(b.iter_mut()) {
                (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
            }
            (rhs[i], rhs[j]) = (c * rhs[i] - s * rhs[j], s * rhs[i] + c * rhs[j]);
        }
    }
    rotated
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_underdetermined_system_gets_its_shortest_solution() {
        let x = solve(vec![vec![1.0, 1.0, 0.0]], vec![2.0]);
        assert!(x.iter().zip([1.0, 1.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-15));
    }

    #[test]
    fn contradicting_rows_are_met_in_the_mean() {
        let x = solve(vec![vec![1.0, 0.0], vec![1.0, 0.0]], vec![1.0, 3.0]);
        assert!((x[0] - 2.0).abs() < 1e-15 && x[1] == 0.0);
    }

    #[test]
    fn zero_matrix_moves_nothing() {
        assert_eq!(solve(vec![vec![0.0, 0.0]], vec![1.0]), [0.0, 0.0]);
    }
}
