//! Natural logarithm.
//!
//! Method: x = 2^k (1 + f), 1 + f between sqrt(1/2) and sqrt(2); with s = f/(2 + f), ln(1 + f) = ln((1 + s)/(1 - s)) =
//! f - f^2/2 + s (f^2/2 + s^2 p(s^2)), as in fdlibm's e_log.c, the rounding error of k ln 2 + f being carried along.
//! Coefficients: tools/minimax.py.

use crate::exp::Exponent;
use crate::float::polynomial;
use crate::pair::Pair;

/// Coefficients of the logarithm.
pub(crate) trait Logarithm: Exponent {
    const SQRT_2: Self;
    /// The smallest normal number.
    const MIN_POSITIVE: Self;
    /// ln((1 + s)/(1 - s)) = 2 s + s z p(z), z = s^2.
    const LN: &[Self];
}

impl Logarithm for f64 {
    const SQRT_2: f64 = core::f64::consts::SQRT_2;
    const MIN_POSITIVE: f64 = f64::MIN_POSITIVE;
    const LN: &[f64] = &[
        0.6666666666666735,
        0.39999999999409364,
        0.28571428743681715,
        0.22222198429676895,
        0.18183572308332607,
        0.15313833632111662,
        0.1479824108765045,
    ];
}

impl Logarithm for f32 {
    const SQRT_2: f32 = core::f32::consts::SQRT_2;
    const MIN_POSITIVE: f32 = f32::MIN_POSITIVE;
    const LN: &[f32] = &[0.66666776, 0.39977577, 0.2987106];
}

#[inline]
pub(crate) fn ln<F: Logarithm>(x: F) -> F {
    if x >= F::MIN_POSITIVE && x < F::INFINITY { ln_normal(x, 0) } else { ln_extreme(x) }
}

/// One path for all lanes, which compilers join, where all are normal numbers.
#[inline]
pub(crate) fn ln_lanes<F: Logarithm, const N: usize>(x: [F; N]) -> [F; N] {
    let direct = x.iter().fold(true, |all, x| all & (F::MIN_POSITIVE..F::INFINITY).contains(x));
    if !direct {
        return x.map(ln);
    }
    let mut logarithms = [F::ZERO; N];
    for lane in 0..N {
        logarithms[lane] = ln_normal(x[lane], 0);
    }
    logarithms
}

/// ln(2^shift x), for normal x.
#[inline]
fn ln_normal<F: Logarithm>(x: F, shift: i32) -> F {
    let m = x.significand();
    let upper = m > F::SQRT_2;
    let f = if upper { F::HALF * m } else { m } - F::ONE;
    let k = F::from_i32(x.exponent() + i32::from(upper) + shift);
    let [first, second] = F::LN_2;

    let s = f / (F::TWO + f);
    let z = s * s;
    let half_square = F::HALF * f * f;
    let sum = Pair::sum(k * first, f);
    let small = s * (half_square + z * polynomial(z, F::LN)) + (k * second - sum.less);
    sum.high - (half_square - small)
}

/// Zeros, subnormal and negative numbers, infinity and NaN.
#[cold]
#[inline(never)]
fn ln_extreme<F: Logarithm>(x: F) -> F {
    if x == F::ZERO {
        -F::INFINITY
    } else if x == F::INFINITY {
        x
    } else if x > F::ZERO {
        ln_normal(x * F::power_of_two(F::DIGITS), -F::DIGITS)
    } else {
        F::NAN
    }
}
