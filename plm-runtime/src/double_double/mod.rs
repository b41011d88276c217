//! Numbers of twice the precision: unevaluated sums of two.
//!
//! The digits of `f64` do not suffice for a small difference of large numbers, next to a singular pose or in a reference for tests.
//! Generated code is generic over its scalar, so it runs on [`DoubleDouble`] as it is:
//!
//! ```
//! use plm_runtime::{Scalar, DoubleDouble};
//!
//! fn difference_of_squares<S: Scalar>(a: S, b: S) -> S {
//!     a * a - b * b
//! }
//! let (a, b) = (94_906_267.0, 94_906_266.0);
//! assert_eq!(difference_of_squares(a, b), 189_812_532.0); // one too few
//! let [a, b] = [a, b].map(DoubleDouble::of);
//! assert_eq!(difference_of_squares(a, b).rounded(), 189_812_533.0);
//! ```
//!
//! [`Pack::pack`](crate::lanes::Pack::pack) and [`pack_held`](crate::lanes::Pack::pack_held) convert a generated mechanism and its discrete
//! state to these numbers: `mechanism.pack([&mechanism], |[s]| DoubleDouble::of(s))`.
//!
//! Method: T. J. Dekker, A floating-point technique for extending the available precision, Numerische Mathematik 18,
//! 1971; D. E. Knuth, The Art of Computer Programming 2, 4.2.2; bounds and the variants taken: M. Joldes, J.-M. Muller,
//! V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic, ACM TOMS 44(2), 2017,
//! whose numbers of algorithms stand at the operations.

mod constants;
mod decimal;
mod functions;
mod instances;
mod operators;
mod scalar;

use plm_math::exact::{ordered_sum, two_product, two_sum};

use crate::scalar::Real;

/// The number `high + low`, where `high` is that sum rounded to `S`.
///
/// With `f64` it has about 31 digits, with `f32` about 14 (and no operation computes in `f64`). Errors are below a few
/// units of [`Real::EPSILON`], 2^-104 and 2^-46, as long as low words are normal numbers: for arguments and results from
/// about 1e-270 (`f32`: 1e-22) to a quarter of the largest number. Outside precision fades to that of `S`. Each operation
/// has the same bits everywhere, unless the feature `fma` is on.
///
/// Largest errors in units of `EPSILON` times the result, of 20 000 random and hard arguments for each function:
///
/// | function | `f64` | `f32` | bound |
/// |---|---|---|---|
/// | add, sub | 0.47 | 0.57 | 0.75, proved |
/// | mul | 0.80 | 0.68 | 1.25, proved |
/// | div | 1.33 | 1.30 | 3.75, proved |
/// | sqrt | 0.57 | 0.63 | 0.79, proved |
/// | floor | 0 | 0 | 0 |
/// | sin | 0.42 | 0.57 | 0.9 |
/// | cos | 0.47 | 0.46 | 0.9 |
/// | tan | 1.36 | 1.29 | 2.0 |
/// | asin | 0.76 | 0.80 | 1.2 |
/// | acos | 0.91 | 0.87 | 1.4 |
/// | atan2 | 0.87 | 0.77 | 1.3 |
/// | exp | 0.24 | 0.25 | 0.4 |
/// | ln | 0.68 | 0.72 | 1.1 |
///
/// Angles may be as large as 2^50 (`f32`: 2^21); the sine of a larger one is not a number. After k quarter turns the angle
/// itself is uncertain by k 2^-212 (`f32`: k 2^-96), which counts where a sine or cosine is nearly zero.
///
/// Infinities, zeros with their signs and NaN are those that `S` gives for the high words.
///
/// `S` may also be [`Dual`](crate::Dual): values are twice as precise then, derivatives as precise as in `S`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble<S> {
    high: S,
    low: S,
}

// Whole operations are calls: generated code has thousands of them. In here they are inlined.
#[allow(clippy::inline_always)]
impl<S: Real> DoubleDouble<S> {
    /// The number itself.
    #[inline]
    pub const fn of(x: S) -> Self {
        Self { high: x, low: S::ZERO }
    }

    /// a + b, exactly unless it overflows.
    #[inline(always)]
    pub fn sum(a: S, b: S) -> Self {
        let (high, low) = two_sum(a, b);
        Self::settled(high, low, high)
    }

    /// a b, exactly unless it overflows or its last digits are subnormal.
    #[inline(always)]
    pub fn product(a: S, b: S) -> Self {
        let (high, low) = two_product(a, b);
        Self::settled(high, low, high)
    }

    /// The number rounded to `S`.
    #[inline]
    pub const fn high(self) -> S {
        self.high
    }

    /// Rounding error of [`high`](Self::high): the number less its rounded value.
    #[inline]
    pub const fn low(self) -> S {
        self.low
    }

    /// The number rounded to `S`, as [`high`](Self::high).
    #[inline]
    pub const fn rounded(self) -> S {
        self.high
    }

    /// high + low, for |high| >= |low|, which is `plain` in the precision of `S`: an infinity, a NaN and the sign of a zero
    /// are taken from there, since errors of infinite results are not numbers.
    #[inline(always)]
    fn settled(high: S, low: S, plain: S) -> Self {
        let (high, low) = ordered_sum(high, low);
        if high.is_finite() && high != S::ZERO { Self { high, low } } else { Self::of(plain) }
    }

    /// Algorithm 6, with an error of 3/4 EPSILON.
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let (plain, rest) = two_sum(self.high, other.high);
        let (low, last) = two_sum(self.low, other.low);
        let (high, low) = ordered_sum(plain, rest + low);
        Self::settled(high, last + low, plain)
    }

    /// Algorithm 10, with an error of 5/4 EPSILON (J.-M. Muller, L. Rideau, Formalization of double-word arithmetic, and
    /// comments on "Tight and rigorous error bounds …", ACM TOMS 48(1), 2022, theorem 5.4).
    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let (high, rest) = two_product(self.high, other.high);
        Self::settled(high, rest + (self.high * other.low + self.low * other.high), high)
    }

    /// Algorithm 7, with an error of 1/2 EPSILON.
    #[inline(always)]
    fn times_one(self, factor: S) -> Self {
        let (plain, rest) = two_product(self.high, factor);
        let (high, low) = ordered_sum(plain, self.low * factor);
        Self::settled(high, low + rest, plain)
    }

    /// Algorithm 17, with an error of 15/4 EPSILON.
    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        let quotient = self.high / divisor.high;
        let product = divisor.times_one(quotient);
        let rest = (self.high - product.high) + (self.low - product.low);
        Self::settled(quotient, rest / divisor.high, quotient)
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    /// Times a power of two: exact unless the number overflows or its last digits are subnormal.
    #[inline(always)]
    fn shifted(self, power_of_two: S) -> Self {
        let (high, low) = (self.high * power_of_two, self.low * power_of_two);
        Self::settled(high, low, high)
    }
}
