//! Small dense linear systems.

/// Solves `a x = b` for several right sides by elimination with full pivots; gives the determinant. None if the matrix is singular.
pub fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<Vec<f64>>) -> Option<(Vec<Vec<f64>>, f64)> {
    let n = a.len();
    let sizes: Vec<f64> =
        a.iter().map(|row| row.iter().fold(0.0, |size: f64, x| size.max(x.abs()))).collect();
    let mut determinant = 1.0;
    for (row, size) in sizes.iter().enumerate() {
        if *size == 0.0 {
            return None;
        }
        a[row].iter_mut().chain(&mut b[row]).for_each(|x| *x /= size);
        determinant *= size;
    }
    let mut columns: Vec<usize> = (0..n).collect();
    for k in 0..n {
        let (mut p, mut q) = (k, k);
        for i in k..n {
            for j in k..n {
                if a[i][j].abs() > a[p][q].abs() {
                    (p, q) = (i, j);
                }
            }
        }
        // Also what is not a number.
        if !(a[p][q].abs() > 1e-10) {
            return None;
        }
        if p != k {
            a.swap(p, k);
            b.swap(p, k);
            determinant = -determinant;
        }
        if q != k {
            for row in &mut *a {
                row.swap(q, k);
            }
            columns.swap(q, k);
            determinant = -determinant;
        }
        determinant *= a[k][k];
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            for j in 0..b[i].len() {
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    let mut x = b.clone();
    for k in (0..n).rev() {
        for j in 0..b[k].len() {
            let known: f64 = (k + 1..n).map(|l| a[k][l] * b[l][j]).sum();
            b[k][j] = (b[k][j] - known) / a[k][k];
            x[columns[k]][j] = b[k][j];
        }
    }
    Some((x, determinant))
}

/// The solution for one right side.
pub fn solve_one(a: Vec<Vec<f64>>, b: &[f64]) -> Option<(Vec<f64>, f64)> {
    let (x, determinant) = solve(a, b.iter().map(|b| vec![*b]).collect())?;
    Some((x.into_iter().map(|row| row[0]).collect(), determinant))
}
