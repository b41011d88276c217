//! `f32` and `f64` as scalars.

use plm_math as math;

#[cfg(feature = "fma")]
use super::fused;
use super::{Real, Registers, Scalar};

/// `lanes` of N values in L >= N lanes; the last value fills up.
#[inline]
fn padded<T: Copy, const N: usize, const L: usize>(
    x: [T; N],
    lanes: impl FnOnce([T; L]) -> ([T; L], [T; L]),
) -> ([T; N], [T; N]) {
    let (a, b) = lanes(core::array::from_fn(|i| x[i.min(N - 1)]));
    (core::array::from_fn(|i| a[i]), core::array::from_fn(|i| b[i]))
}

macro_rules! real {
    ($real:ident, $healthy:literal, $agreement:literal, $rank_tolerance:literal, { $($own:item)* }) => {
        impl Scalar for $real {
            $($own)*

            type Mask = bool;
            type Turns = i32;

            const ZERO: Self = 0.0;
            const HEALTHY: f64 = $healthy;
            const AGREEMENT: f64 = $agreement;
            const PRECISION: f64 = $real::EPSILON as f64;
            const REGISTERS: Registers = if cfg!(any(target_feature = "sse2", target_arch = "aarch64")) {
                Registers::Pairs
            } else {
                Registers::Scalar
            };

            #[inline]
            fn lit(x: f64) -> Self {
                x as $real
            }
            #[allow(clippy::cast_lossless, reason = "lossless in f64 alone")]
            #[inline]
            fn of_turns(turns: i32) -> Self {
                turns as $real
            }
            #[inline]
            fn to_turns(self) -> i32 {
                self as i32
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline]
            fn is_finite(self) -> bool {
                $real::is_finite(self)
            }
            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                #[cfg(feature = "fma")]
                return fused::$real(self, a, b);
                #[cfg(not(feature = "fma"))]
                return self * a + b;
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                math::$real::sin_cos(self)
            }
            #[allow(clippy::inline_always, reason = "as `sin_cos_lanes`")]
            #[inline(always)]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                // Vectors have two, four or eight lanes: what lies between is filled up.
                match N {
                    3 => padded::<_, N, 4>(angles, math::$real::sin_cos_lanes),
                    5..=7 => padded::<_, N, 8>(angles, math::$real::sin_cos_lanes),
                    _ => math::$real::sin_cos_lanes(angles),
                }
            }
            #[inline]
            fn sin_cos_by<const DIRECT: bool>(self) -> (Self, Self) {
                // By its path: numbers have a method of that name in std, with other bits.
                if DIRECT { math::$real::sin_cos_direct(self) } else { math::$real::sin_cos(self) }
            }
            #[allow(clippy::inline_always, reason = "as `sin_cos_lanes`")]
            #[inline(always)]
            fn sin_cos_all_by<const DIRECT: bool, const N: usize>(
                angles: [Self; N],
            ) -> ([Self; N], [Self; N]) {
                if DIRECT { math::$real::sin_cos_lanes_direct(angles) } else { Self::sin_cos_all(angles) }
            }
            #[inline]
            fn sqrt(self) -> Self {
                math::$real::sqrt(self)
            }
            #[inline]
            fn tan(self) -> Self {
                math::$real::tan(self)
            }
            #[inline]
            fn asin(self) -> Self {
                math::$real::asin(self)
            }
            #[inline]
            fn acos(self) -> Self {
                math::$real::acos(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                math::$real::atan2(self, x)
            }
            #[inline]
            fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
                math::$real::atan2_lanes(y, x)
            }
            #[inline]
            fn exp_all<const N: usize>(x: [Self; N]) -> [Self; N] {
                math::$real::exp_lanes(x)
            }
            #[inline]
            fn ln_all<const N: usize>(x: [Self; N]) -> [Self; N] {
                math::$real::ln_lanes(x)
            }
            #[inline]
            fn exp(self) -> Self {
                math::$real::exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                math::$real::ln(self)
            }
            #[inline]
            fn abs(self) -> Self {
                $real::abs(self)
            }
            #[inline]
            fn floor(self) -> Self {
                // Zero has one sign: numbers of two words, which are sums, keep none.
                math::$real::floor(self) + 0.0
            }
            #[inline]
            fn lt(self, other: Self) -> bool {
                self < other
            }
            #[inline]
            fn select(mask: bool, a: Self, b: Self) -> Self {
                if mask { a } else { b }
            }
            #[inline]
            fn choose(mask: bool, a: bool, b: bool) -> bool {
                if mask { a } else { b }
            }
            #[inline]
            fn any(mask: bool) -> bool {
                mask
            }
            #[inline]
            fn all(mask: bool) -> bool {
                mask
            }
        }

        impl Real for $real {
            type Plain = Self;

            #[inline]
            fn plain(self) -> Self {
                self
            }
            #[inline]
            fn of_plain(plain: Self) -> Self {
                plain
            }
            #[inline]
            fn with_plain(self, plain: Self) -> Self {
                plain
            }
            const EPSILON: Self = $real::EPSILON;
            const RANK_TOLERANCE: Self = $rank_tolerance;
            const DOUBLE_DOUBLE_EPSILON: Self = $real::EPSILON * $real::EPSILON;
            const INFINITY: Self = $real::INFINITY;
            #[inline]
            fn are_direct<const N: usize>(angles: [Self; N]) -> bool {
                math::$real::are_direct(angles)
            }
        }
    };
}

real!(f64, 6e-6, 1e9, 1.490_116_119_384_765_6e-8, {
    #[inline]
    fn f64s(numbers: &[f64]) -> Option<&[f64]> {
        Some(numbers)
    }
    #[inline]
    fn f64s_mut(numbers: &mut [f64]) -> Option<&mut [f64]> {
        Some(numbers)
    }
});
real!(f32, 5e-3, 1e5, 3.452_669_8e-4, {});
