//! Sums and products with their rounding errors, which are floating-point numbers themselves.
//!
//! Written over any numbers that [`Split`], since numbers with derivatives are rounded in the same way. Nothing is fused:
//! the bits are the same everywhere.

use core::ops::{Add, Mul, Sub};

/// Numbers that come apart into two halves of their digits.
pub trait Split: Sized {
    /// Bits of the significand: 24 for `f32`, 53 for `f64`.
    const DIGITS: u32;

    /// The upper half of the digits, rounded, and the rest: the products of two such halves are exact.
    #[must_use]
    fn split(self) -> (Self, Self);
}

macro_rules! split {
    ($float:ident, $bits:ident) => {
        impl Split for $float {
            const DIGITS: u32 = $float::MANTISSA_DIGITS;

            /// The split of Veltkamp (in T. J. Dekker, "A floating-point technique for extending the available
            /// precision", Numerische Mathematik 18, 1971, (5.5)), with the rounding in integers: no large number
            /// overflows, save those that round up to infinity.
            #[inline]
            fn split(self) -> (Self, Self) {
                const REST: u32 = $float::MANTISSA_DIGITS.div_ceil(2);
                let rounded = self.to_bits().wrapping_add(1 << (REST - 1)) & ($bits::MAX << REST);
                let high = $float::from_bits(rounded);
                (high, self - high)
            }
        }
    };
}

split!(f64, u64);
split!(f32, u32);

/// The rounded sum a + b, and its rounding error (D. E. Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
#[inline]
pub fn two_sum<T: Copy + Add<Output = T> + Sub<Output = T>>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Sum and rounding error as [`two_sum`] has them, in three operations, for |a| >= |b| or a = 0 (T. J. Dekker, 1971, (4.14)).
#[inline]
pub fn ordered_sum<T: Copy + Add<Output = T> + Sub<Output = T>>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The rounded product a b, and its rounding error (T. J. Dekker, 1971, (5.14)): exact unless a term overflows or is
/// subnormal.
#[inline]
pub fn two_product<T>(a: T, b: T) -> (T, T)
where
    T: Copy + Split + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (a.split(), b.split());
    let rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, rest)
}

#[cfg(test)]
mod tests {
    use super::{Split, ordered_sum, two_product, two_sum};

    /// Significands and exponents from the multiples of the golden ratio.
    fn numbers() -> impl Iterator<Item = u64> {
        (1..20_000_u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    /// m 2^e of a number, with an odd or even integer m of at most 53 bits.
    fn integer(x: f64) -> (i128, i32) {
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i32;
        let fraction = i128::from(x.to_bits() & ((1 << 52) - 1));
        let (m, e) = if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
        (if x < 0.0 { -m } else { m }, e)
    }

    /// x 2^shift as an integer.
    fn scaled(x: f64, shift: i32) -> i128 {
        let (m, e) = integer(x);
        let shift = e + shift;
        if m == 0 {
            0
        } else if shift >= 0 {
            m << shift
        } else {
            assert_eq!(m & ((1 << -shift) - 1), 0, "{x:e} has digits below 2^{shift}");
            m >> -shift
        }
    }

    /// Numbers from 2^-4 to 2^4, so that all digits of sums and products fit into 128 bits.
    fn moderate(bits: u64) -> f64 {
        let exponent = 1023 - 4 + (bits >> 32) % 8;
        f64::from_bits((bits.rotate_left(17) & !(0x7ff << 52)) | exponent << 52)
    }

    #[test]
    fn sums_and_products_have_exact_errors() {
        for bits in numbers() {
            let (a, b) = (moderate(bits), moderate(bits.rotate_left(29) ^ 0x1234_5678_9abc_def0));
            let (sum, rest) = two_sum(a, b);
            assert_eq!(scaled(sum, 60) + scaled(rest, 60), scaled(a, 60) + scaled(b, 60), "{a:e} + {b:e}");
            let (large, small) = if a.abs() > b.abs() { (a, b) } else { (b, a) };
            assert_eq!(ordered_sum(large, small), (sum, rest));
            let (product, rest) = two_product(a, b);
            let (m, n) = (integer(a), integer(b));
            let e = m.1 + n.1;
            assert_eq!(scaled(product, -e) + scaled(rest, -e), m.0 * n.0, "{a:e} * {b:e}");
        }
    }

    #[test]
    fn single_products_are_those_of_f64() {
        for bits in numbers() {
            let (a, b) = (moderate(bits) as f32, moderate(!bits.rotate_left(7)) as f32);
            let (product, rest) = two_product(a, b);
            assert_eq!(f64::from(product) + f64::from(rest), f64::from(a) * f64::from(b), "{a:e} * {b:e}");
        }
    }

    #[test]
    fn halves_have_half_of_the_digits() {
        for bits in numbers() {
            let x = f64::from_bits(bits);
            if x.abs() < f64::MAX / 2.0 {
                let (high, low) = x.split();
                assert_eq!(high + low, x);
                // 26 digits each: the last 27 of 53 are zero.
                for half in [high, low] {
                    let (m, _) = integer(half);
                    let m = m.unsigned_abs();
                    assert!(m == 0 || 128 - m.leading_zeros() - m.trailing_zeros() <= 26, "{x:e}: {half:e}");
                }
            }
        }
        assert_eq!((-0.0_f64).split().0.to_bits(), (-0.0_f64).to_bits());
        assert_eq!(f64::INFINITY.split().0, f64::INFINITY);
    }
}
