//! Elementary functions.
//!
//! Sine, cosine and the exponential function are sums of their series on a small interval. The others start from the value
//! in `S` and take one step of a correction, which is as precise as `S` itself.

use core::ops::Neg;

use super::DoubleDouble;
use super::constants::{INVERSE_FACTORIALS, LN_2, PI_OVER_2, is_single};
use crate::scalar::{Real, Scalar};

/// Which terms of a series count, by the numbers whose factorials divide them; for `f64` and for `f32`.
struct Terms {
    first: usize,
    step: usize,
    /// From here on terms are so small that they need one word: less than 2^-52 (`f32`: 2^-22) of the sum.
    short: [usize; 2],
    /// The last that changes the sum.
    last: [usize; 2],
}

/// (sin r - r) / r^3, up to an eighth of a turn.
const SINE: Terms = Terms { first: 3, step: 2, short: [19, 11], last: [27, 15] };
/// (cos r - 1) / r^2, up to an eighth of a turn.
const COSINE: Terms = Terms { first: 2, step: 2, short: [18, 12], last: [28, 16] };
/// (exp r - 1 - r) / r^2, up to ln 2 / 2.
const EXPONENTIAL: Terms = Terms { first: 2, step: 1, short: [14, 9], last: [24, 14] };

impl Terms {
    /// The sum of x^j / (first + j step)! by Horner's rule, from the small terms on.
    #[inline]
    fn sum<S: Real>(&self, x: DoubleDouble<S>) -> DoubleDouble<S> {
        let kind = usize::from(is_single::<S>());
        let (short, last) =
            if kind == 0 { (self.short[0], self.last[0]) } else { (self.short[1], self.last[1]) };
        let mut small = S::ZERO;
        // `step_by` panics at zero.
        let mut n = last;
        while n >= short {
            small = small * x.high + INVERSE_FACTORIALS.at(2 * n);
            n -= self.step;
        }
        let mut sum = DoubleDouble::of(small);
        while n >= self.first {
            sum = sum.times(x).plus(INVERSE_FACTORIALS.pair(2 * n));
            n -= self.step;
        }
        sum
    }
}

/// The nearest integer.
#[inline]
fn nearest<S: Real>(x: S) -> S {
    (x + S::lit(0.5)).floor()
}

/// x - k (c_0 + c_1 + …), where each product is exact.
#[inline]
fn less_multiple<S: Real, const N: usize>(x: DoubleDouble<S>, k: S, words: [S; N]) -> DoubleDouble<S> {
    words.into_iter().fold(x, |rest, word| rest.plus(DoubleDouble::product(k, word).negated()))
}

/// Sine and cosine by quarter revolutions and series.
pub(super) fn sin_cos<S: Real>(x: DoubleDouble<S>) -> (DoubleDouble<S>, DoubleDouble<S>) {
    // So that the number of quarter turns is a whole number of `S`, and the words of pi/2 suffice.
    let largest = S::lit(if is_single::<S>() { 2_097_152.0 } else { 1_125_899_906_842_624.0 });
    if !x.high.abs().lt(largest) {
        let nan = DoubleDouble::lit(f64::NAN);
        return (nan, nan);
    }
    if x.high == S::ZERO {
        // A sum would lose the sign of zero.
        return (x, DoubleDouble::lit(1.0));
    }
    let quarters = nearest(x.high * S::lit(core::f64::consts::FRAC_2_PI));
    let angle = if quarters == S::ZERO {
        x
    } else {
        less_multiple(x, quarters, [0, 1, 2, 3].map(|i| PI_OVER_2.at(i)))
    };

    let square = angle.times(angle).negated();
    let sin = angle.plus(angle.times(square).times(SINE.sum(square)));
    let cos = DoubleDouble::lit(1.0).plus(square.times(COSINE.sum(square)));

    // By k modulo 4: quarters, their half and the half of that are exact in `S`.
    let half = (quarters * S::lit(0.5)).floor();
    let is_odd = quarters != half + half;
    let is_turned = half != (half * S::lit(0.5)).floor() * S::lit(2.0);
    let (sin, cos) = if is_odd { (cos, sin.negated()) } else { (sin, cos) };
    if is_turned { (sin.neg(), cos.neg()) } else { (sin, cos) }
}

/// exp x - 1 for |x| <= ln 2 / 2, with a small relative error.
#[inline]
fn exp_less_one<S: Real>(x: DoubleDouble<S>) -> DoubleDouble<S> {
    x.plus(x.times(x).times(EXPONENTIAL.sum(x)))
}

/// x 2^k; in two steps, since 2^k may be no number where x 2^k is one.
#[inline]
fn scaled<S: Real>(x: DoubleDouble<S>, k: S) -> DoubleDouble<S> {
    // Exact: exponents are small.
    let k = k.to_f64() as i32;
    let half = k / 2;
    x.shifted(S::lit(2.0).powi(half)).shifted(S::lit(2.0).powi(k - half))
}

/// How many times ln 2.
#[inline]
fn doublings<S: Real>(x: S) -> S {
    nearest(x * S::lit(core::f64::consts::LOG2_E))
}

/// Exponential function, by powers of two and the series.
pub(super) fn exp<S: Real>(x: DoubleDouble<S>) -> DoubleDouble<S> {
    let plain = x.high.exp();
    if !plain.is_finite() || plain == S::ZERO {
        return DoubleDouble::of(plain);
    }
    let k = doublings(x.high);
    let rest = less_multiple(x, k, [0, 1, 2].map(|i| LN_2.at(i)));
    scaled(DoubleDouble::lit(1.0).plus(exp_less_one(rest)), k)
}

/// Natural logarithm: x = m 2^k, and with the logarithm l of m in `S` ln m = l + ln(1 + c), c = m exp(-l) - 1.
pub(super) fn ln<S: Real>(x: DoubleDouble<S>) -> DoubleDouble<S> {
    let plain = x.high.ln();
    if !plain.is_finite() {
        return DoubleDouble::of(plain);
    }
    let k = doublings(plain);
    let m = scaled(x, -k);
    let l = m.high.ln();
    // In this form without a cancellation of rounded numbers next to m = 1.
    let c = m.plus(DoubleDouble::lit(-1.0)).plus(m.times(exp_less_one(DoubleDouble::of(-l))));
    // Two more terms of its series: next to 1 the low word of m may be nearly all of c.
    let curved = c.high * c.high * (c.high * S::lit(1.0 / 3.0) - S::lit(0.5));
    let ln_m = DoubleDouble::of(l).plus(c.plus(DoubleDouble::of(curved)));
    if k == S::ZERO { ln_m } else { LN_2.pair(0).times_one(k).plus(ln_m) }
}

/// Square root: Algorithm 8 of V. Lefèvre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, Accurate calculation of Euclidean
/// norms using double-word arithmetic, ACM TOMS 49(1), 2023, with an error of 25/32 EPSILON.
pub(super) fn sqrt<S: Real>(x: DoubleDouble<S>) -> DoubleDouble<S> {
    let root = x.high.sqrt();
    let square = DoubleDouble::product(root, root);
    let rest = ((x.high - square.high) - square.low) + x.low;
    DoubleDouble::settled(root, rest / (root + root), root)
}

/// sqrt(1 - x^2) without cancellation; NaN outside [-1, 1].
#[inline]
pub(super) fn half_chord<S: Real>(x: DoubleDouble<S>) -> DoubleDouble<S> {
    let one = DoubleDouble::lit(1.0);
    ((one - x) * (one + x)).sqrt()
}

/// Angle of the point (x, y): that in `S`, and what is left when the point is turned back by it.
pub(super) fn atan2<S: Real>(y: DoubleDouble<S>, x: DoubleDouble<S>) -> DoubleDouble<S> {
    let plain = y.high.atan2(x.high);
    let (sin, cos) = DoubleDouble::of(plain).sin_cos();
    // The tangent of an angle that is below the rounding of `plain`: the angle itself, to twice the digits.
    let across = y.times(cos).plus(x.times(sin).negated());
    let along = x.times(cos).plus(y.times(sin));
    let left = across.over(along);
    if left.high == S::ZERO {
        return DoubleDouble::of(plain);
    }
    if left.is_finite() {
        return DoubleDouble::of(plain).plus(left);
    }
    // The origin, or an infinite coordinate: a multiple of pi/4, or no number.
    let eighths = nearest(plain * S::lit(core::f64::consts::FRAC_2_PI * 2.0));
    let exact = PI_OVER_2.pair::<S>(0).times_one(eighths * S::lit(0.5));
    if exact.high == plain { DoubleDouble { high: plain, low: exact.low } } else { DoubleDouble::of(plain) }
}
