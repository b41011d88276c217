//! The public functions, once for both types.

macro_rules! functions {
    ($float:ident, $bound:literal) => {
        #[doc = concat!("Elementary functions of `", stringify!($float), "`.")]
        pub mod $float {
            use crate::{asin, atan, exp, float::Float, hypot, ln, powi, sin_cos, tan};

            /// (sin x, cos x) of an angle in radians, by one reduction. NaN for infinite x.
            ///
            #[doc = concat!("No branch is taken for |x| <= ", stringify!($bound), "; larger angles are as exact, but slower.")]
            #[inline]
            pub fn sin_cos(x: $float) -> ($float, $float) {
                sin_cos::sin_cos(x)
            }

            /// [`sin_cos`] where [`are_direct`] says that it takes no branch: none is compiled. Of larger angles something else.
            #[inline]
            pub fn sin_cos_direct(x: $float) -> ($float, $float) {
                sin_cos::sin_cos_direct(x)
            }

            /// True if all angles are so small that [`sin_cos`] takes no branch: one comparison of the sum of their absolute values.
            #[inline]
            pub fn are_direct<const N: usize>(x: [$float; N]) -> bool {
                sin_cos::are_direct(x)
            }

            /// Sines and cosines of several angles, with the bits of [`sin_cos`]: one straight path for all of them,
            /// which compilers turn into vector instructions. Two, four or eight angles at a time fill them.
            #[allow(clippy::inline_always, reason = "a call would end the vectors of its caller")]
            #[inline(always)]
            pub fn sin_cos_lanes<const N: usize>(x: [$float; N]) -> ([$float; N], [$float; N]) {
                sin_cos::sin_cos_lanes(x)
            }

            /// [`sin_cos_lanes`] where [`are_direct`] says that it takes no branch, as [`sin_cos_direct`].
            #[allow(clippy::inline_always, reason = "as above")]
            #[inline(always)]
            pub fn sin_cos_lanes_direct<const N: usize>(x: [$float; N]) -> ([$float; N], [$float; N]) {
                sin_cos::sin_cos_lanes_direct(x)
            }

            /// Sine of an angle in radians; see [`sin_cos`].
            #[inline]
            pub fn sin(x: $float) -> $float {
                sin_cos::sin_cos(x).0
            }

            /// Cosine of an angle in radians; see [`sin_cos`].
            #[inline]
            pub fn cos(x: $float) -> $float {
                sin_cos::sin_cos(x).1
            }

            /// Tangent of an angle in radians. NaN for infinite x.
            #[inline]
            pub fn tan(x: $float) -> $float {
                tan::tan(x)
            }

            /// Arc sine in radians, -pi/2 to pi/2. NaN for |x| > 1.
            #[inline]
            pub fn asin(x: $float) -> $float {
                asin::asin(x)
            }

            /// Arc cosine in radians, 0 to pi. NaN for |x| > 1.
            #[inline]
            pub fn acos(x: $float) -> $float {
                asin::acos(x)
            }

            /// Arc tangent in radians, -pi/2 to pi/2.
            #[inline]
            pub fn atan(x: $float) -> $float {
                atan::atan(x)
            }

            /// Angle of the vector (x, y) against the x axis in radians, -pi to pi. Signed zeros and infinities as in
            /// C99, F.9.1.4.
            #[inline]
            pub fn atan2(y: $float, x: $float) -> $float {
                atan::atan2(y, x)
            }

            /// Angles of N vectors, with the same bits as one by one, in straight-line code for all lanes, which compilers turn
            /// into vector instructions.
            #[inline]
            pub fn atan2_lanes<const N: usize>(y: [$float; N], x: [$float; N]) -> [$float; N] {
                atan::atan2_lanes(y, x)
            }

            /// Square root, correctly rounded. -0 for -0, NaN below.
            #[inline]
            pub fn sqrt(x: $float) -> $float {
                Float::sqrt(x)
            }

            /// Exponential function.
            #[inline]
            pub fn exp(x: $float) -> $float {
                exp::exp(x)
            }

            /// Natural logarithm. Minus infinity for zeros, NaN below.
            #[inline]
            pub fn ln(x: $float) -> $float {
                ln::ln(x)
            }

            /// [`exp`] of N numbers, with the same bits as one by one, as [`atan2_lanes`].
            #[inline]
            pub fn exp_lanes<const N: usize>(x: [$float; N]) -> [$float; N] {
                exp::exp_lanes(x)
            }

            /// [`ln`] of N numbers, with the same bits as one by one, as [`atan2_lanes`].
            #[inline]
            pub fn ln_lanes<const N: usize>(x: [$float; N]) -> [$float; N] {
                ln::ln_lanes(x)
            }

            /// Length of the vector (x, y), without overflow or underflow on the way. Infinite if a coordinate is
            /// infinite, even if the other is NaN.
            #[inline]
            pub fn hypot(x: $float, y: $float) -> $float {
                hypot::hypot(x, y)
            }

            /// x^n by repeated squaring; 1 for n = 0, whatever x is. The relative error is that of its |n| - 1
            /// multiplications, and one division if n < 0.
            #[inline]
            pub fn powi(x: $float, n: i32) -> $float {
                powi::powi(x, n)
            }

            /// Magnitude.
            #[inline]
            pub const fn abs(x: $float) -> $float {
                x.abs()
            }

            /// The magnitude of `x` with the sign of `sign`, which may be a zero's.
            #[inline]
            pub const fn copysign(x: $float, sign: $float) -> $float {
                x.copysign(sign)
            }

            /// The smaller number: `if a < b { a } else { b }`, one instruction. So the second argument stands if one
            /// of both is NaN or both are zeros.
            #[inline]
            pub const fn min(a: $float, b: $float) -> $float {
                if a < b { a } else { b }
            }

            /// The larger number: `if a > b { a } else { b }`, one instruction. So the second argument stands if one
            /// of both is NaN or both are zeros.
            #[inline]
            pub const fn max(a: $float, b: $float) -> $float {
                if a > b { a } else { b }
            }

            /// The largest integer that is not above x. A zero and an infinity stay what they are.
            #[inline]
            pub const fn floor(x: $float) -> $float {
                let integer = round_ties_even(x);
                if integer > x { integer - 1.0 } else { integer }
            }

            /// The nearest integer, the even one of two that are equally near. A zero keeps its sign.
            #[inline]
            pub const fn round_ties_even(x: $float) -> $float {
                const INTEGERS: $float = <$float as Float>::INTEGERS;
                if x.abs() < INTEGERS {
                    ((x.abs() + INTEGERS) - INTEGERS).copysign(x)
                } else {
                    x
                }
            }
        }
    };
}

functions!(f64, 411774);
functions!(f32, 402);
