//! Orthogonalisation of rows against nalgebra's singular values and pseudo-inverse.

use nalgebra::SMatrix;
use plm_runtime::linalg::{dot, identity, pseudo_solve, rotate};

use crate::random::Random;

/// A random matrix of the given rank with singular values spread over `decades`.
fn random<const M: usize, const N: usize>(random: &mut Random, rank: usize, decades: f64) -> [[f64; N]; M] {
    let mut a = [[0.0; N]; M];
    for k in 0..rank {
        let size = 10_f64.powf(-decades * k as f64 / rank.max(2) as f64);
        let (u, v): ([f64; M], [f64; N]) =
            (core::array::from_fn(|_| random.signed()), core::array::from_fn(|_| random.signed()));
        for i in 0..M {
            for j in 0..N {
                a[i][j] += size * u[i] * v[j];
            }
        }
    }
    a
}

fn check<const M: usize, const N: usize>(a: [[f64; N]; M], rank: usize, b: [f64; M], seed: u64) {
    let oracle = SMatrix::<f64, M, N>::from_fn(|i, j| a[i][j]);
    let dynamic = nalgebra::DMatrix::from_fn(M, N, |i, j| a[i][j]);
    let mut expected: Vec<f64> = dynamic.clone().svd(false, false).singular_values.iter().copied().collect();
    expected.sort_by(|a, b| b.total_cmp(a));
    let found = rotate(a, identity::<f64, M>()).unwrap();
    let cut = found.cut(1e-8);
    assert_eq!(found.rank(cut), rank, "seed {seed}");
    let mut sigma = found.sigma;
    sigma.sort_by(|a, b| b.total_cmp(a));
    for k in 0..rank {
        assert!((sigma[k] - expected[k]).abs() <= 1e-14 * expected[0], "seed {seed}: {sigma:?} {expected:?}");
    }
    // W A = S V^T, row by row.
    for (w, row) in found.carried.iter().zip(&found.rows) {
        for j in 0..N {
            let product: f64 = (0..M).map(|i| w[i] * a[i][j]).sum();
            assert!(
                (product - row[j]).abs() < 1e-14 * expected[0],
                "seed {seed} {M} {N} {rank} {:e}",
                (product - row[j]) / expected[0]
            );
        }
    }
    // The null space is orthonormal, and there is as much of it as rows are redundant.
    let null: Vec<_> = found.null(cut).collect();
    assert_eq!(null.len(), M - rank);
    for (i, y) in null.iter().enumerate() {
        for (j, z) in null.iter().enumerate() {
            assert!((dot(y, z) - f64::from(u8::from(i == j))).abs() < 1e-14, "seed {seed}");
        }
        let image = oracle.transpose() * nalgebra::SVector::<f64, M>::from_fn(|i, _| y[i]);
        assert!(image.amax() < 1e-14 * expected[0], "seed {seed}");
    }
    let x = pseudo_solve(a, &b).unwrap();
    let inverse = dynamic.pseudo_inverse(1e-8 * expected[0]).unwrap();
    let reference = inverse * nalgebra::DVector::from_fn(M, |i, _| b[i]);
    let condition = expected[0] / expected[rank.max(1) - 1];
    for j in 0..N {
        let tolerance = 1e-14 * condition * reference.amax().max(1.0);
        assert!((x[j] - reference[j]).abs() <= tolerance, "seed {seed}: {} {}", x[j], reference[j]);
    }
}

fn check_shape<const M: usize, const N: usize>(seed: u64) {
    let mut numbers = Random(seed);
    for rank in 1..=M.min(N) {
        for decades in [0.0, 3.0] {
            let a = random::<M, N>(&mut numbers, rank, decades);
            check(a, rank, core::array::from_fn(|_| numbers.signed()), seed);
        }
    }
}

#[test]
fn singular_values_rank_and_pseudo_inverse_are_those_of_nalgebra() {
    for seed in 0..20 {
        check_shape::<4, 6>(seed);
        check_shape::<6, 6>(seed);
        check_shape::<7, 4>(seed);
        check_shape::<1, 5>(seed);
        check_shape::<12, 20>(seed);
    }
}

#[test]
fn a_matrix_that_is_not_finite_has_no_rank() {
    assert!(rotate([[1.0, f64::NAN], [0.0, 1.0]], identity()).is_none());
    assert!(rotate([[1.0, f64::INFINITY], [0.0, 1.0]], identity()).is_none());
}

#[test]
fn graded_rows_keep_their_rank() {
    // Rows 1e6 apart in size, well within the tolerance, and one below it.
    let a = [[1e6, 0.0, 0.0], [1e6, 1.0, 0.0], [0.0, 0.0, 1e-3]];
    let found = rotate(a, identity::<f64, 3>()).unwrap();
    assert_eq!(found.rank(found.cut(1e-8)), 2);
}

#[test]
fn no_rows_and_no_columns_are_fine() {
    let zero = rotate([[0.0; 3]; 2], identity::<f64, 2>()).unwrap();
    assert_eq!((zero.rank(0.0), zero.null(0.0).count()), (0, 2));
    assert_eq!(rotate::<f64, 0, 3, 0>([], []).unwrap().rank(0.0), 0);
    assert_eq!(pseudo_solve::<f64, 2, 0>([[], []], &[1.0, 2.0]), Some([]));
}
