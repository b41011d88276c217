//! Exponential function.
//!
//! Method: x = k ln 2 + r, exp x = 2^k exp r, as in W. J. Cody and W. Waite, Software Manual for the Elementary
//! Functions, 1980, chapter 6, with ln 2 in two parts and a polynomial instead of their quotient; the rounding errors of
//! r and of 1 + r are carried along. Coefficients: tools/minimax.py.

use crate::float::{Float, polynomial};
use crate::pair::Pair;

/// Constants of the exponential function.
pub(crate) trait Exponent: Float {
    /// Up to here 2^k is a normal number.
    const BOUND: Self;
    const LOG2_E: Self;
    /// ln 2 = l\[0\] + l\[1\]: k l\[0\] is exact for every k of a finite result.
    const LN_2: [Self; 2];
    /// exp r = 1 + r + r^2 p(r), |r| <= ln(2)/2.
    const EXP: &[Self];
}

impl Exponent for f64 {
    const BOUND: f64 = 708.0;
    const LOG2_E: f64 = core::f64::consts::LOG2_E;
    // Bits 1 to 42 of ln 2 and 53 more.
    const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];
    const EXP: &[f64] = &[
        0.5,
        0.16666666666666682,
        0.0416666666666661,
        0.008333333333317006,
        0.0013888888889114141,
        0.00019841269896452701,
        2.480158692888446e-05,
        2.7557234795008225e-06,
        2.7557580226945595e-07,
        2.511205975723721e-08,
        2.0827075607866083e-09,
    ];
}

impl Exponent for f32 {
    const BOUND: f32 = 87.0;
    const LOG2_E: f32 = core::f32::consts::LOG2_E;
    // Bits 1 to 15 of ln 2 and 24 more.
    const LN_2: [f32; 2] = [0.693_145_75, 1.4286068e-06];
    const EXP: &[f32] = &[0.5, 0.16666664, 0.041666355, 0.0083339475, 0.0013942178, 0.000195758];
}

#[inline]
pub(crate) fn exp<F: Exponent>(x: F) -> F {
    if x.abs() <= F::BOUND {
        let (k, y) = kernel(x);
        y * F::power_of_two(k)
    } else {
        exp_extreme(x)
    }
}

/// One path for all lanes, which compilers join, where none of them is near the ends of the range.
#[inline]
pub(crate) fn exp_lanes<F: Exponent, const N: usize>(x: [F; N]) -> [F; N] {
    let direct = x.iter().fold(true, |all, x| all & (x.abs() <= F::BOUND));
    if !direct {
        return x.map(exp);
    }
    let mut powers = [F::ZERO; N];
    for lane in 0..N {
        let (k, y) = kernel(x[lane]);
        powers[lane] = y * F::power_of_two(k);
    }
    powers
}

/// k and exp(x) / 2^k.
#[inline]
fn kernel<F: Exponent>(x: F) -> (i32, F) {
    let sum = x * F::LOG2_E + F::ROUNDER;
    let k = sum - F::ROUNDER;
    let [first, second] = F::LN_2;
    let r = Pair { high: x - k * first, less: k * second }.rounded();
    let w = Pair::sum(F::ONE, r.high);
    let curve = r.high * r.high * polynomial(r.high, F::EXP);
    (sum.rounded(), w.high + (curve - (w.less + r.less * w.high)))
}

/// Results near the ends of the range or beyond, and NaN.
#[cold]
#[inline(never)]
fn exp_extreme<F: Exponent>(x: F) -> F {
    let far = F::BOUND + F::BOUND;
    if x > far {
        F::INFINITY
    } else if x < -far {
        F::ZERO
    } else if x.abs() <= far {
        // Two factors, so that none of them overflows and a subnormal result is rounded once.
        let (k, y) = kernel(x);
        let half = k / 2;
        y * F::power_of_two(half) * F::power_of_two(k - half)
    } else {
        F::NAN
    }
}
