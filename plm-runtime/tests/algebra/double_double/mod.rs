//! Numbers of twice the precision against mpmath (tools/double_double.py), and in the special cases of `f64`.

mod accuracy;
mod bits;
mod special;

use plm_runtime::{DoubleDouble, Real, Scalar};

/// A number from two words that need not be those of its rounded value.
fn from_words<S: Real>(high: S, low: S) -> DoubleDouble<S> {
    DoubleDouble::sum(high, low)
}

/// A function by its name in the reference values.
fn call<T: Real>(name: &str, x: &[T]) -> Option<T> {
    Some(match (name, x) {
        ("add", &[a, b]) => a + b,
        ("sub", &[a, b]) => a - b,
        ("mul", &[a, b]) => a * b,
        ("div", &[a, b]) => a / b,
        ("sqrt", &[a]) => a.sqrt(),
        ("floor", &[a]) => Scalar::floor(a),
        ("sin", &[a]) => a.sin(),
        ("cos", &[a]) => a.cos(),
        ("tan", &[a]) => a.tan(),
        ("asin", &[a]) => a.asin(),
        ("acos", &[a]) => a.acos(),
        ("atan2", &[y, x]) => y.atan2(x),
        ("exp", &[a]) => a.exp(),
        ("ln", &[a]) => a.ln(),
        _ => return None,
    })
}

/// The names that [`call`] knows, with the number of arguments.
const FUNCTIONS: [(&str, usize); 14] = [
    ("add", 2),
    ("sub", 2),
    ("mul", 2),
    ("div", 2),
    ("sqrt", 1),
    ("floor", 1),
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("asin", 1),
    ("acos", 1),
    ("atan2", 2),
    ("exp", 1),
    ("ln", 1),
];
