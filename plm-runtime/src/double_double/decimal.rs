//! Numbers as they were written: a parameter counts as the decimal in its declaration.
//!
//! The test for lengths that meet at a singular pose must not depend on the rounding of their decimals.

use plm_math::exact::two_product;

use super::DoubleDouble;
use crate::scalar::Real;

/// Decimals have so many digits less than numbers of `S`: others would be decimals by chance.
const SPARED: f64 = 1e-2;

impl<S: Real> DoubleDouble<S> {
    /// The number that was written where `x` was read: the shortest decimal that is rounded to `x`, if it has few digits, else `x`.
    ///
    /// Lengths of 0.3, 0.8, 0.5 and 0.6 m are a neutral linkage then, as intended: 0.3 + 0.8 is 0.5 + 0.6.
    ///
    /// ```
    /// use plm_runtime::DoubleDouble;
    ///
    /// let [a, b, c, d] = [0.3_f64, 0.8, 0.5, 0.6].map(DoubleDouble::written);
    /// assert!((a + b - (c + d)).rounded().abs() < 1e-32);
    /// assert_eq!(DoubleDouble::written(0.1_f64 + 0.2), DoubleDouble::of(0.1 + 0.2)); // 0.30000000000000004
    /// ```
    #[inline(never)]
    pub fn written(x: S) -> Self {
        let (mut power, ten, half) = (S::lit(1.0), S::lit(10.0), S::lit(0.5));
        loop {
            let whole = (x * power + half).floor();
            // False for NaN.
            let few = whole.abs() < S::lit(SPARED) / S::EPSILON;
            if !few {
                return Self::of(x);
            }
            if whole / power == x {
                let (product, rest) = two_product(x, power);
                let missing = ((whole - product) - rest) / power;
                // A constant, of numbers with derivatives as well.
                return Self::sum(x, S::lit(missing.to_f64()));
            }
            power = power * ten;
        }
    }
}
