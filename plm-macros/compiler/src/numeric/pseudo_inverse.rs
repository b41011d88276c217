//! Minimum-norm least-squares solution of a small dense system, the compiler's twin of the runtime's.

use crate::collect::CollectVec;

/// Singular values below this share of the largest count as zero.
const TOLERANCE: f64 = 1e-9;
/// Rotations converge quadratically; ten sweeps are usual.
const MOST_SWEEPS: usize = 40;
/// A square that a rotation takes below this part of itself is computed anew.
const CANCELLED: f64 = 0.1;

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
    let mut squares: Vec<f64> = matrix.iter().map(|row| dot(row, row)).collect_vec();
    for j in 1..matrix.len() {
        for i in 0..j {
            let (head, tail) = matrix.split_at_mut(j);
            let (a, b) = (&mut head[i], &mut tail[0]);
            let (alpha, beta, gamma) = (squares[i], squares[j], dot(a, b));
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
            // Most of a square that becomes small is rounding.
            let square = |row: &[f64], before: f64, after: f64| {
                if after > CANCELLED * before { after } else { dot(row, row) }
            };
            squares[i] = square(a, alpha, alpha - t * gamma);
            squares[j] = square(b, beta, beta + t * gamma);
        }
    }
    rotated
}

/// By four sums, which do not wait for each other.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, last_a), (b, last_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        sums = [sums[0] + a[0] * b[0], sums[1] + a[1] * b[1], sums[2] + a[2] * b[2], sums[3] + a[3] * b[3]];
    }
    let last = last_a.iter().zip(last_b).fold(0.0, |sum, (x, y)| sum + x * y);
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + last
}

#[cfg(test)]
mod tests {
    use super::super::random::Random;
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

    /// Matrices with rows that repeat, mirror or add others, and zeros, half of the time: the residual is normal to the columns, and the
    /// solution lies in the rows, which Gram and Schmidt make orthogonal.
    #[test]
    fn solutions_of_random_systems_are_least_in_both_senses() {
        let mut random = Random(11);
        let mut draw = || random.unit();
        for case in 0..3000 {
            let [rows, columns] = [0, 0].map(|_| 1 + (draw().abs() * 12.0) as usize);
            let mut matrix: Vec<Vec<f64>> = Vec::new();
            for i in 0..rows {
                let special = (draw().abs() * 8.0) as usize;
                let new: Vec<f64> = match (special, i) {
                    (0, 1..) => matrix[i - 1].clone(),
                    (1, 1..) => matrix[0].iter().map(|x| -x).collect_vec(),
                    (2, 2..) => matrix[0].iter().zip(&matrix[1]).map(|(x, y)| x + 0.5 * y).collect_vec(),
                    (3, _) => vec![0.0; columns],
                    _ => (0..columns).map(|_| if draw() < 0.0 { 0.0 } else { draw() }).collect_vec(),
                };
                matrix.push(new);
            }
            let rhs: Vec<f64> = (0..rows).map(|_| draw()).collect_vec();
            let x = solve(matrix.clone(), rhs.clone());
            let residual: Vec<f64> = matrix.iter().zip(&rhs).map(|(row, b)| dot(row, &x) - b).collect_vec();
            let size = 1.0 + dot(&x, &x).sqrt();
            for k in 0..columns {
                let normal: f64 = matrix.iter().zip(&residual).map(|(row, r)| row[k] * r).sum();
                assert!(normal.abs() < 1e-11 * size, "{case}: {normal:e} of {size}");
            }
            let mut outside = x;
            for base in orthogonal(matrix) {
                let along = dot(&outside, &base);
                outside = outside.iter().zip(&base).map(|(x, base)| x - along * base).collect_vec();
            }
            assert!(outside.iter().all(|x| x.abs() < 1e-11 * size), "{case}: {outside:?} of {size}");
        }
    }

    /// Unit vectors that span the rows.
    fn orthogonal(matrix: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let mut found: Vec<Vec<f64>> = Vec::new();
        for mut row in matrix {
            // Twice, since the first time leaves rounding along the others.
            for base in found.iter().chain(&found) {
                let along = dot(&row, base);
                row = row.iter().zip(base).map(|(x, base)| x - along * base).collect_vec();
            }
            let length = dot(&row, &row).sqrt();
            if length > 1e-10 {
                row = row.iter().map(|x| x / length).collect_vec();
                found.push(row);
            }
        }
        found
    }
}
