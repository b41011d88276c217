//! What the tests share: a random stream, random expressions, an evaluator that is not the one under test.
#![allow(dead_code)] // each test file uses its part

pub(crate) mod direct;
pub(crate) mod random;

/// Are two values equal up to `tolerance` relative to 1 or their size? Two NaN are; an infinity only to itself.
pub(crate) fn close(a: f64, b: f64, tolerance: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= tolerance * a.abs().max(b.abs()).max(1.0)
}
