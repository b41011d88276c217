//! Operations of a floating-point type that the functions need beside its arithmetic.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// `f32` or `f64`. Constants and bit operations; each family of functions adds its coefficients by a trait of its own.
pub(crate) trait Float:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    const ZERO: Self;
    const HALF: Self;
    const ONE: Self;
    const TWO: Self;
    const NAN: Self;
    const INFINITY: Self;

    /// 2^(p-1), p the bits of the significand: from here on all numbers are integers.
    const INTEGERS: Self;

    /// 1.5 * 2^(p-1): `x + ROUNDER` is x rounded to an integer (ties to even), which stands in its low bits.
    const ROUNDER: Self;

    /// Numbers from 2^-SCALE to 2^SCALE can be squared and divided by each other with all error terms normal.
    const SCALE: i32;

    /// Largest power of two by which [`scale_to_one`] scales, a normal number either way.
    const RESCALE: i32;

    /// Number of bits of the significand, p.
    const DIGITS: i32;

    fn abs(self) -> Self;

    /// `self * a + b`: two roundings, or one with the feature `fma`.
    fn times_plus(self, a: Self, b: Self) -> Self;

    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;

    /// The upper half of the significand: `a.head() * b.head()` is exact.
    fn head(self) -> Self;

    /// 2^k, for k in the range of normal numbers.
    fn power_of_two(k: i32) -> Self;

    /// floor(log2 |x|), for normal x.
    fn exponent(self) -> i32;

    /// |x| / 2^exponent, for normal x.
    fn significand(self) -> Self;

    /// An integer of few bits, exactly.
    fn from_i32(k: i32) -> Self;

    /// The integer k of `x + ROUNDER`, modulo 2^(p-2).
    fn rounded(self) -> i32;

    /// (s, c) turned by k quarter turns, k = `self.rounded()`, by masks alone: this form fills vector lanes.
    fn turn(self, s: Self, c: Self) -> (Self, Self);

    /// Correctly rounded square root.
    fn sqrt(self) -> Self;

    /// |x| = m 2^e with an integer m, for normal x.
    fn integer_and_exponent(self) -> (u64, i32);

    /// fraction * 2^(exponent - 64) as an unevaluated sum of two numbers; the fraction's leading bit is one of its two
    /// highest.
    fn from_fraction(fraction: u64, exponent: i32) -> (Self, Self);
}

macro_rules! float {
    ($float:ident, $bits:ident, $signed:ident, $digits:literal, $scale:literal, $rescale:literal) => {
        impl Float for $float {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const NAN: Self = $float::NAN;
            const INFINITY: Self = $float::INFINITY;
            const INTEGERS: Self = (1_u64 << ($digits - 1)) as $float;
            const ROUNDER: Self = (3_u64 << ($digits - 2)) as $float;
            const SCALE: i32 = $scale;
            const RESCALE: i32 = $rescale;
            const DIGITS: i32 = $digits;

            #[inline]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline]
            fn times_plus(self, a: Self, b: Self) -> Self {
                #[cfg(feature = "fma")]
                return self.mul_add(a, b);
                #[cfg(not(feature = "fma"))]
                return self * a + b;
            }

            #[inline]
            fn copysign(self, sign: Self) -> Self {
                self.copysign(sign)
            }

            #[inline]
            fn head(self) -> Self {
                $float::from_bits(self.to_bits() & ($bits::MAX << (($digits + 1) / 2)))
            }

            #[inline]
            fn power_of_two(k: i32) -> Self {
                $float::from_bits(((k + $float::MAX_EXP - 1) as $bits) << ($digits - 1))
            }

            #[inline]
            fn exponent(self) -> i32 {
                (self.abs().to_bits() >> ($digits - 1)) as i32 - ($float::MAX_EXP - 1)
            }

            #[inline]
            fn significand(self) -> Self {
                $float::from_bits(self.to_bits() & ((1 << ($digits - 1)) - 1) | Self::ONE.to_bits())
            }

            #[inline]
            #[allow(clippy::cast_lossless)] // lossless for one of both types
            fn from_i32(k: i32) -> Self {
                k as $float
            }

            #[inline]
            fn rounded(self) -> i32 {
                // The bit of 2^(p-2), half of the power in ROUNDER, is taken off by sign extension from below it.
                const ABOVE: u32 = $bits::BITS - ($digits - 2);
                ((self.to_bits() << ABOVE) as $signed >> ABOVE) as i32
            }

            #[inline]
            fn turn(self, s: Self, c: Self) -> (Self, Self) {
                const SIGN: $bits = 1 << ($bits::BITS - 1);
                let k = self.to_bits();
                let (s, c) = (s.to_bits(), c.to_bits());
                let exchange = (s ^ c) & (k & 1).wrapping_neg();
                let half_turn = (k << ($bits::BITS - 2)) & SIGN;
                let quarter_turn = k << ($bits::BITS - 1);
                let s = s ^ exchange ^ half_turn;
                let c = c ^ exchange ^ half_turn ^ quarter_turn;
                ($float::from_bits(s), $float::from_bits(c))
            }

            #[inline]
            fn sqrt(self) -> Self {
                crate::sqrt::$float(self)
            }

            #[inline]
            fn integer_and_exponent(self) -> (u64, i32) {
                let leading = 1 << ($digits - 1);
                let fraction = self.to_bits() & (leading - 1);
                (u64::from(fraction | leading), self.exponent() - ($digits - 1))
            }

            #[inline]
            fn from_fraction(fraction: u64, exponent: i32) -> (Self, Self) {
                let high = fraction >> (64 - $digits);
                let low = (fraction << $digits) >> (64 - $digits);
                let unit = Self::power_of_two(exponent - $digits);
                (high as $float * unit, low as $float * unit * Self::power_of_two(-$digits))
            }
        }
    };
}

float!(f64, u64, i64, 53, 400, 800);
float!(f32, u32, i32, 24, 40, 100);

/// c\[0\] + c\[1\] x + c\[2\] x^2 + … by Horner's rule.
#[inline]
pub(crate) fn polynomial<F: Float>(x: F, coefficients: &[F]) -> F {
    match coefficients.split_last() {
        Some((last, rest)) => rest.iter().rev().fold(*last, |sum, &c| sum.times_plus(x, c)),
        None => F::ZERO,
    }
}

/// A power of two by which x is near 1; a subnormal or very large x gets at least well into the range of `SCALE`.
#[inline]
pub(crate) fn scale_to_one<F: Float>(x: F) -> i32 {
    -x.exponent().clamp(-F::RESCALE, F::RESCALE)
}
