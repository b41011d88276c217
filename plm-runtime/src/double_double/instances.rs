//! Operations over `f64`, compiled in this crate.

use super::DoubleDouble;
use crate::scalar::Scalar;

impl DoubleDouble<f64> {
    /// Calls every operation that is not inlined once; it is never called itself. A program that is built without optimisation shares the
    /// code that the compiler generates for it in this crate. If this crate is optimised, as for our tests, motions near singular poses
    /// take less time.
    #[doc(hidden)]
    #[must_use]
    pub fn operations(a: Self, b: Self) -> ([Self; 7], [Self; 9]) {
        let (sin, cos) = a.sin_cos();
        let arithmetic = [a + b, a - b, a * b, a / b, a.mul_add(b, a), a.floor(), a.sqrt()];
        let functions =
            [sin, cos, a.tan(), a.asin(), a.acos(), a.atan2(b), a.exp(), a.ln(), Self::written(a.high)];
        (arithmetic, functions)
    }
}
