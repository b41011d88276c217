//! Orthogonalisation of rows against nalgebra's singular values and QR.

use nalgebra::{DMatrix, DVector};
use plm_runtime::Dual;
use plm_runtime::absolute::accelerate;
use plm_runtime::linalg::{dot, identity, rotate};

use crate::random::Random;

/// Random factors of a matrix U V^T of the given rank, with columns of U of sizes spread over `decades`.
fn factors<const M: usize, const N: usize>(
    random: &mut Random,
    rank: usize,
    decades: f64,
) -> (DMatrix<f64>, DMatrix<f64>) {
    let size = |k: usize| 10_f64.powf(-decades * k as f64 / rank.max(2) as f64);
    let u = DMatrix::from_fn(M, rank, |_, k| size(k) * random.unit());
    (u, DMatrix::from_fn(N, rank, |_, _| random.unit()))
}

/// (U V^T)^+ b = V (V^T V)^-1 U^+ b for factors of full rank (A. Ben-Israel, T. N. E. Greville, Generalized Inverses,
/// 1.6, theorem 5), by QR. (nalgebra's own pseudo-inverse loses digits on some rank-deficient matrices: seed 0, 6 x 6,
/// rank 2 gives |A^T (A x - b)| = 0.01.)
fn expected_solution(u: &DMatrix<f64>, v: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    let (qr_u, qr_v) = (u.clone().qr(), v.clone().qr());
    let z = qr_u.r().solve_upper_triangular(&(qr_u.q().transpose() * b)).unwrap();
    qr_v.q() * qr_v.r().transpose().solve_lower_triangular(&z).unwrap()
}

fn check<const M: usize, const N: usize>(u: &DMatrix<f64>, v: &DMatrix<f64>, b: [f64; M], seed: u64) -> u32 {
    let (oracle, rank) = (u * v.transpose(), u.ncols());
    let a: [[f64; N]; M] = core::array::from_fn(|i| core::array::from_fn(|j| oracle[(i, j)]));
    let mut expected: Vec<f64> = oracle.clone().svd(false, false).singular_values.iter().copied().collect();
    expected.sort_by(|a, b| b.total_cmp(a));
    let precision = 1e-14 * expected[0];

    let (mut rows, mut w) = (a, identity::<f64, M>());
    let found = rotate(&mut rows, &mut w).unwrap();
    let cut = found.cut(1e-8);
    assert_eq!(found.rank(cut), rank, "seed {seed}");
    let mut sigma = found.values;
    sigma.sort_by(|a, b| b.total_cmp(a));
    for k in 0..rank {
        assert!((sigma[k] - expected[k]).abs() <= precision, "seed {seed}: {sigma:?} {expected:?}");
    }
    // W A = S V^T, row by row.
    for (w, row) in w.iter().zip(&rows) {
        for j in 0..N {
            let product: f64 = (0..M).map(|i| w[i] * a[i][j]).sum();
            assert!((product - row[j]).abs() < precision, "seed {seed}");
        }
    }
    // The null space is orthonormal, and there is as much of it as rows are redundant.
    let null: Vec<_> = (0..M).filter(|k| found.values[*k] <= cut).map(|k| w[k]).collect();
    assert_eq!(null.len(), M - rank);
    for (i, y) in null.iter().enumerate() {
        for (j, z) in null.iter().enumerate() {
            assert!((dot(y, z) - f64::from(u8::from(i == j))).abs() < 1e-14, "seed {seed}");
        }
        assert!((oracle.transpose() * DVector::from_row_slice(y)).amax() < precision, "seed {seed}");
    }

    // Accelerations leave directions out below 1e-4 of the largest (of the matrix with scaled columns).
    let condition = expected[0] / expected[rank - 1];
    if condition > 1e3 {
        return 0;
    }
    // With unit masses and no force they are A^+ gamma.
    let solved = accelerate(0.0, &[1.0; N], &[0.0; N], &b, |rows| *rows = a).unwrap();
    assert_eq!(solved.rank, rank, "seed {seed}");
    let reference = expected_solution(u, v, &DVector::from_row_slice(&b));
    // P.-A. Wedin, Perturbation theory for pseudo-inverses, BIT 13 (1973), theorem 5.1, with |b| for the residual.
    let b = b.iter().fold(0.0, |size, b| f64::max(size, b.abs()));
    let tolerance = 1e-14 * condition * (reference.amax() + condition * b / expected[0]);
    for j in 0..N {
        let (found, expected) = (solved.a[j], reference[j]);
        assert!((found - expected).abs() <= tolerance, "seed {seed}: {found} {expected}");
    }
    1
}

/// Returns how many solutions were compared.
fn check_shape<const M: usize, const N: usize>(seed: u64) -> u32 {
    let (mut numbers, mut compared) = (Random(seed), 0);
    for rank in 1..=M.min(N) {
        for decades in [0.0, 2.0] {
            let (u, v) = factors::<M, N>(&mut numbers, rank, decades);
            compared += check::<M, N>(&u, &v, core::array::from_fn(|_| numbers.unit()), seed);
        }
    }
    compared
}

#[test]
fn singular_values_rank_null_space_and_pseudo_inverse_are_right() {
    let mut compared = 0;
    for seed in 0..20 {
        compared += check_shape::<4, 6>(seed);
        compared += check_shape::<6, 6>(seed);
        compared += check_shape::<7, 4>(seed);
        compared += check_shape::<1, 5>(seed);
        compared += check_shape::<12, 20>(seed);
    }
    // 20 seeds, 27 ranks, 2 spreads.
    assert!(compared > 1000, "{compared}");
}

/// Rank of a matrix of three rows.
fn rank(mut a: [[f64; 3]; 3]) -> Option<usize> {
    let found = rotate(&mut a, &mut identity::<f64, 3>())?;
    Some(found.rank(found.cut(1e-8)))
}

#[test]
fn a_matrix_that_is_not_finite_has_no_rank() {
    assert_eq!(rank([[1.0, f64::NAN, 0.0], [0.0, 1.0, 0.0], [0.0; 3]]), None);
    assert_eq!(rank([[1.0, f64::INFINITY, 0.0], [0.0, 1.0, 0.0], [0.0; 3]]), None);
}

#[test]
fn graded_rows_keep_their_rank() {
    // Rows 1e6 apart in size, well within the tolerance, and one below it.
    assert_eq!(rank([[1e6, 0.0, 0.0], [1e6, 1.0, 0.0], [0.0, 0.0, 1e-3]]), Some(2));
}

#[test]
fn no_rows_no_columns_and_no_entries_are_fine() {
    assert_eq!(rank([[0.0; 3]; 3]), Some(0));
    assert_eq!(rotate::<f64, 0, 3, 0>(&mut [], &mut []).unwrap().rank(0.0), 0);
    assert_eq!(accelerate::<f64, 0, 2>(0.0, &[], &[], &[1.0, 2.0], |_| ()).unwrap().rank, 0);
}

/// Bits of accelerations and multipliers in arrays of a size; what stands after the matrix is zero.
fn bits<const M: usize, const N: usize>(a: &DMatrix<f64>, b: &DVector<f64>) -> Vec<u64> {
    let (rows, columns) = a.shape();
    let inverse_mass = core::array::from_fn(|j| f64::from(u8::from(j < columns)));
    let gamma = core::array::from_fn(|i| if i < rows { b[i] } else { 0.0 });
    let solved = accelerate::<f64, N, M>(0.0, &inverse_mass, &[0.0; N], &gamma, |to| {
        for (i, row) in to.iter_mut().enumerate().take(rows) {
            *row = core::array::from_fn(|j| if j < columns { a[(i, j)] } else { 0.0 });
        }
    });
    let solved = solved.unwrap();
    solved.a[..columns].iter().chain(&solved.lambda[..rows]).map(|number| number.to_bits()).collect()
}

#[test]
fn room_after_a_matrix_changes_no_bit() {
    for seed in 0..200 {
        let mut random = Random(seed);
        let (u, v) = factors::<6, 9>(&mut random, 5, 1.0);
        // Decimals, whose sums and products leave rounding in the place of the dependent row.
        let a = (u * v.transpose()).map(|number| (number * 1e3).round() / 1e3);
        let a = a
            .clone()
            .insert_row(6, 0.0)
            .map_with_location(|i, j, number| if i < 6 { number } else { a.column(j).sum() });
        let b = DVector::from_fn(7, |_, _| random.unit());
        assert_eq!(bits::<7, 9>(&a, &b), bits::<16, 24>(&a, &b), "seed {seed}");
    }
}

/// Rotations of constant rows carry the tangents of zeros as they carry numbers.
#[test]
fn rotations_carry_derivatives_of_zeros() {
    for seed in 0..50 {
        let mut random = Random(seed);
        let (u, v) = factors::<5, 4>(&mut random, 3, 0.0);
        let a = u * v.transpose();
        let rows: [[f64; 4]; 5] = core::array::from_fn(|i| core::array::from_fn(|j| a[(i, j)]));
        let tangents: [[f64; 3]; 5] = core::array::from_fn(|_| core::array::from_fn(|_| random.unit()));
        let (mut plain, mut carried) = (rows, tangents);
        rotate(&mut plain, &mut carried).unwrap();
        let dual = |value: f64, tangent: f64| Dual { value, tangents: [tangent] };
        let mut lifted = rows.map(|row| row.map(|value| dual(value, 0.0)));
        let mut zeros = tangents.map(|row| row.map(|tangent| dual(0.0, tangent)));
        rotate(&mut lifted, &mut zeros).unwrap();
        assert_eq!(zeros.map(|row| row.map(|dual| dual.tangents[0])), carried, "seed {seed}");
    }
}
