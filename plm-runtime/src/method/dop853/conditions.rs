//! Order conditions that follow from quadrature and from the stages' own orders (Hairer, Nørsett, Wanner I,
//! II.1, II.5).

use super::tableau::*;

/// The times of the stages, as fractions of the step; the thirteenth is its end.
const C: [f64; 17] = [0.0, 0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, 1.0, 1.0, C14, C15, C16];

/// The stages of the weights, and of the dense output.
const STEP: [usize; 8] = [1, 6, 7, 8, 9, 10, 11, 12];
const DENSE: [usize; 12] = [1, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16];

/// sum of weight c^q.
fn moment(weights: &[f64], stages: &[usize], q: i32) -> f64 {
    assert_eq!(weights.len(), stages.len());
    weights.iter().zip(stages).map(|(weight, stage)| weight * C[*stage].powi(q)).sum()
}

/// A stage, its row, and the stages of the row.
type Row = (usize, &'static [f64], &'static [usize]);

const ROWS: [Row; 14] = [
    (2, &A2, &[1]),
    (3, &A3, &[1, 2]),
    (4, &A4, &[1, 3]),
    (5, &A5, &[1, 3, 4]),
    (6, &A6, &[1, 4, 5]),
    (7, &A7, &[1, 4, 5, 6]),
    (8, &A8, &[1, 4, 5, 6, 7]),
    (9, &A9, &[1, 4, 5, 6, 7, 8]),
    (10, &A10, &[1, 4, 5, 6, 7, 8, 9]),
    (11, &A11, &[1, 4, 5, 6, 7, 8, 9, 10]),
    (12, &A12, &[1, 4, 5, 6, 7, 8, 9, 10, 11]),
    (14, &A14, &[1, 7, 8, 9, 10, 11, 12, 13]),
    (15, &A15, &[1, 6, 7, 8, 11, 12, 13, 14]),
    (16, &A16, &[1, 6, 7, 8, 9, 13, 14, 15]),
];

/// Rounding of sums of terms up to 50.
const ROUNDING: f64 = 2e-14;

#[test]
fn stages_have_the_order_that_the_method_is_built_on() {
    for (stage, row, of) in ROWS {
        let order = match stage {
            2 => 1,
            3..=5 => 3,
            6..=12 => 5,
            _ => 6,
        };
        for q in 0..order {
            let exact = C[stage].powi(q + 1) / f64::from(q + 1);
            assert!((moment(row, of, q) - exact).abs() < ROUNDING, "stage {stage}, power {q}");
        }
        let q = order;
        let next = moment(row, of, q) - C[stage].powi(q + 1) / f64::from(q + 1);
        assert!(next.abs() > 1e-8, "stage {stage} has one order more than it should");
    }
}

#[test]
fn weights_integrate_polynomials_of_degree_7_and_the_embedded_ones_4_and_2() {
    for q in 0..8 {
        assert!((moment(&B, &STEP, q) - 1.0 / f64::from(q + 1)).abs() < ROUNDING, "weights, power {q}");
        let (fifth, third) = (moment(&E5, &STEP, q).abs(), moment(&E3, &STEP, q).abs());
        assert_eq!(
            (fifth < ROUNDING, third < ROUNDING),
            (q < 5, q < 3),
            "errors, power {q}: {fifth} {third}"
        );
    }
}

#[test]
fn the_dense_output_integrates_polynomials_of_degree_6() {
    for q in 0..7 {
        // y' = t^q: y(theta) = theta^(q+1) / (q+1), by the ends and their rates and the four terms beyond them.
        let end = 1.0 / f64::from(q + 1);
        let bends = [D4, D5, D6, D7].map(|d| moment(&d, &DENSE, q));
        let (first, last) = (C[1].powi(q), 1.0);
        for theta in [0.1, 0.35, 0.5, 0.8] {
            let rest = 1.0 - theta;
            let bend = bends[0] + theta * (bends[1] + rest * (bends[2] + theta * bends[3]));
            let start_slope = first - end;
            let end_slope = end - last - start_slope;
            let y = theta * (end + rest * (start_slope + theta * (end_slope + rest * bend)));
            assert!((y - theta.powi(q + 1) / f64::from(q + 1)).abs() < 1e-13, "{theta}, power {q}");
        }
    }
}
