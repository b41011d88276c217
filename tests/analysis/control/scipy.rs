//! Random systems of Newton's against scipy.

use nalgebra::{Complex, DMatrix};
use plm::control::{Cost, continuous_riccati, discrete_riccati};
use serde_json::Value;

use super::{near, same, same_set, system};

fn matrix(value: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = serde_json::from_value(value.clone()).unwrap();
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

fn numbers(value: &Value) -> Vec<Complex<f64>> {
    let parts: Vec<[f64; 2]> = serde_json::from_value(value.clone()).unwrap();
    parts.into_iter().map(|[re, im]| Complex::new(re, im)).collect()
}

#[test]
fn the_numbers_are_those_of_scipy() {
    let all: Value = serde_json::from_str(include_str!("scipy.json")).unwrap();
    let cases = all["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 5);
    for case in cases {
        let [a, b, c, q, r, n] = ["a", "b", "c", "q", "r", "n"].map(|name| matrix(&case[name]));
        let cost = Cost { q, r, n };
        let x = continuous_riccati(&a, &b, &cost).unwrap();
        same(&x, &matrix(&case["care"]), 1e-9);
        let linear = system(a, b, c);
        let sampled = linear.sampled(case["period"].as_f64().unwrap());
        same(&sampled.a, &matrix(&case["ad"]), 1e-12);
        same(&sampled.b, &matrix(&case["bd"]), 1e-12);
        let x = discrete_riccati(&sampled.a, &sampled.b, &cost).unwrap();
        same(&x, &matrix(&case["dare"]), 1e-9);
        let frequencies: Vec<f64> = serde_json::from_value(case["frequencies"].clone()).unwrap();
        for (frequency, known) in frequencies.into_iter().zip(numbers(&case["response"])) {
            let found = linear.response("u0", "y0", frequency).unwrap();
            near((found - known).norm() / known.norm(), 0.0, 1e-10);
        }
        same_set(&linear.zeros("u0", "y0").unwrap(), &numbers(&case["zeros"]), 1e-9);
    }
}
