//! Sine and cosine.
//!
//! Method: W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980, chapter 8, with pi/2 in three
//! parts of which the first two multiply exactly; the rest of the last subtraction is carried along as in fdlibm's
//! e_rem_pio2.c. Coefficients: tools/minimax.py. One path without branches serves all angles up to `BOUND`; what lies
//! beyond goes through [`crate::reduce`].

use crate::float::{Float, polynomial};
use crate::pair::Pair;
use crate::reduce::reduce;

/// Constants of the kernel.
pub(crate) trait Angle: Float {
    /// Largest angle of the direct path: 2^18 (f64) or 2^8 (f32) quarter turns.
    const BOUND: Self;
    const TWO_OVER_PI: Self;
    /// pi/2 = p\[0\] + p\[1\] + p\[2\]: k p\[0\] and k p\[1\] are exact for every k that `BOUND` allows.
    const PI_OVER_2: [Self; 3];
    /// sin r = r - r z p(z), z = r^2.
    const SIN: &[Self];
    /// cos r = 1 - z/2 + z^2 p(z), z = r^2.
    const COS: &[Self];
}

impl Angle for f64 {
    const BOUND: f64 = 411_774.0;
    const TWO_OVER_PI: f64 = core::f64::consts::FRAC_2_PI;
    // Bits 0 to 34, 39 to 73 and 77 to 129 of pi/2; those between are zeros.
    const PI_OVER_2: [f64; 3] = [
        f64::from_bits(0x3ff9_21fb_5444_0000),
        f64::from_bits(0x3d86_8c23_4c4c_0000),
        f64::from_bits(0x3b29_8a2e_0370_7345),
    ];
    const SIN: &[f64] = &[
        0.1666666666666663,
        -0.00833333333332184,
        0.0001984126982935849,
        -2.7557313538493105e-06,
        2.5050734385683858e-08,
        -1.589543308580776e-10,
    ];
    const COS: &[f64] = &[
        0.041666666666666595,
        -0.0013888888888873333,
        2.480158728899287e-05,
        -2.755731421354634e-07,
        2.087570483047689e-09,
        -1.1358716031847892e-11,
    ];
}

impl Angle for f32 {
    const BOUND: f32 = 402.0;
    const TWO_OVER_PI: f32 = core::f32::consts::FRAC_2_PI;
    // Bits 0 to 15, 16 to 30 and 34 to 57 of pi/2; those between are zeros.
    const PI_OVER_2: [f32; 3] =
        [f32::from_bits(0x3fc9_0f00), f32::from_bits(0x37da_a200), f32::from_bits(0x2e85_a309)];
    const SIN: &[f32] = &[0.16666655, -0.008332189, 0.00019518276];
    const COS: &[f32] = &[0.041666646, -0.001388731, 2.4432327e-05];
}

/// Sum of x/(pi/2) and `ROUNDER`, and x less that many quarter turns.
#[inline]
fn quarter_turns<F: Angle>(x: F) -> (F, Pair<F>) {
    let sum = x.times_plus(F::TWO_OVER_PI, F::ROUNDER);
    let k = sum - F::ROUNDER;
    let [first, second, third] = F::PI_OVER_2;
    let rest = k.times_plus(-first, x);
    let high = k.times_plus(-second, rest);
    let less = k.times_plus(third, k.times_plus(second, high - rest));
    (sum, Pair { high, less })
}

/// Sine and cosine of an angle of at most an eighth of a turn.
///
/// The small terms of first order in `less` are the turn by `-less`. Both results keep the sign of a zero.
#[inline]
fn kernel<F: Angle>(r: Pair<F>) -> (Pair<F>, Pair<F>) {
    let Pair { high: r, less } = r;
    let z = r * r;
    let half = F::HALF * z;
    let w = F::ONE - half;
    let sin_less = less.times_plus(w, r * z * polynomial(z, F::SIN));
    let cos_less = -(((F::ONE - w) - half) + r.times_plus(less, z * z * polynomial(z, F::COS)));
    (Pair { high: r, less: sin_less }, Pair { high: w, less: cos_less })
}

/// (s, c) turned by `quarters` quarter turns, through memory: in scalar code cheaper than masks, and no branch.
#[inline]
fn turn_by_table<F: Float>(quarters: usize, s: F, c: F) -> (F, F) {
    let circle = [s, c, -s, -c, s];
    let k = quarters & 3;
    (circle[k], circle[k + 1])
}

/// Is an angle one of the direct path?
#[inline]
fn is_direct<F: Angle>(x: F) -> bool {
    x.abs() <= F::BOUND
}

/// Are all angles of the direct path? Their magnitudes are no more than the sum of all, in any rounding.
#[inline]
pub(crate) fn are_direct<F: Angle, const N: usize>(x: [F; N]) -> bool {
    let sum = x.iter().map(|x| x.abs()).reduce(|sum, x| sum + x);
    sum.is_none_or(|sum| sum <= F::BOUND)
}

#[inline]
pub(crate) fn sin_cos<F: Angle>(x: F) -> (F, F) {
    if is_direct(x) { sin_cos_direct(x) } else { sin_cos_large(x) }
}

#[inline]
pub(crate) fn sin_cos_direct<F: Angle>(x: F) -> (F, F) {
    let (sum, r) = quarter_turns(x);
    let (s, c) = kernel(r);
    turn_by_table(sum.rounded() as usize, s.value(), c.value())
}

/// One path for all lanes; each operation is written for one lane, and compilers join them.
#[allow(clippy::inline_always, reason = "a call would end the vectors of its caller")]
#[inline(always)]
pub(crate) fn sin_cos_lanes<F: Angle, const N: usize>(x: [F; N]) -> ([F; N], [F; N]) {
    let direct = x.iter().fold(true, |all, x| all & is_direct(*x));
    if direct { sin_cos_lanes_direct(x) } else { sin_cos_each(x) }
}

#[allow(clippy::inline_always, reason = "as above")]
#[inline(always)]
pub(crate) fn sin_cos_lanes_direct<F: Angle, const N: usize>(x: [F; N]) -> ([F; N], [F; N]) {
    let (mut sines, mut cosines) = ([F::ZERO; N], [F::ZERO; N]);
    for lane in 0..N {
        let (sum, r) = quarter_turns(x[lane]);
        let (s, c) = kernel(r);
        (sines[lane], cosines[lane]) = if VECTORS {
            sum.turn(s.value(), c.value())
        } else {
            turn_by_table(sum.rounded() as usize, s.value(), c.value())
        };
    }
    (sines, cosines)
}

/// Has the target vectors of floating-point numbers? Of 32-bit ARM none that follow IEEE 754 in all.
const VECTORS: bool = !cfg!(target_arch = "arm");

/// Lanes of which one at least leaves the direct path.
#[cold]
#[inline(never)]
fn sin_cos_each<F: Angle, const N: usize>(x: [F; N]) -> ([F; N], [F; N]) {
    let (mut sines, mut cosines) = ([F::ZERO; N], [F::ZERO; N]);
    for lane in 0..N {
        (sines[lane], cosines[lane]) = sin_cos(x[lane]);
    }
    (sines, cosines)
}

/// Angles beyond `BOUND`, infinities and NaN.
#[cold]
#[inline(never)]
fn sin_cos_large<F: Angle>(x: F) -> (F, F) {
    if x.abs() < F::INFINITY {
        let (quarters, r) = reduce_large(x);
        let (s, c) = kernel(r);
        turn_by_table(quarters, s.value(), c.value())
    } else {
        (F::NAN, F::NAN)
    }
}

/// Number of quarter turns in a finite x beyond `BOUND`, modulo 4, and what is left of x without them.
fn reduce_large<F: Angle>(x: F) -> (usize, Pair<F>) {
    let (m, e) = x.integer_and_exponent();
    let reduced = reduce(m, e);
    let negative = x < F::ZERO;
    let quarters = if negative { 4 - reduced.quarters } else { reduced.quarters };
    let (high, low) = F::from_fraction(reduced.fraction, reduced.exponent);
    let r = Pair { high, less: -low }.rounded();
    (quarters, if negative == reduced.negative { r } else { -r })
}

/// For finite x: whether the number of quarter turns is odd, and sine and cosine of the rest before rounding. The cosine
/// is relieved of the rounding error of r^2, its largest one.
#[inline]
pub(crate) fn parts<F: Angle>(x: F) -> (bool, Pair<F>, Pair<F>) {
    let (quarters, r) = if is_direct(x) {
        let (sum, r) = quarter_turns(x);
        (sum.rounded() as usize, r)
    } else {
        reduce_large(x)
    };
    let (s, c) = kernel(r);
    let square = Pair::product(r.high, r.high);
    (quarters & 1 == 1, s, Pair { high: c.high, less: c.less - F::HALF * square.less })
}
