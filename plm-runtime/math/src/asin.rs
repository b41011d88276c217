//! Arc sine and arc cosine.
//!
//! Method: a polynomial up to 1/2; above, asin x = pi/2 - 2 asin sqrt((1 - x)/2), with the rounding error of the square
//! root carried along, as in fdlibm's e_asin.c. Coefficients: tools/minimax.py.

use crate::atan::Arc;
use crate::float::polynomial;
use crate::pair::Pair;

/// Coefficients of the arc sine.
pub(crate) trait ArcSine: Arc {
    /// asin s = s + s z p(z), z = s^2, |s| <= 1/2.
    const ASIN: &[Self];
}

impl ArcSine for f64 {
    const ASIN: &[f64] = &[
        0.1666666666666676,
        0.07499999999970865,
        0.04464285717456309,
        0.0303819427097393,
        0.022372214939852284,
        0.017351612777981903,
        0.013980812233693487,
        0.011398974821627075,
        0.01077992641450527,
        0.0037075655963070284,
        0.02170478623048662,
        -0.020995480539835774,
        0.03262648147995449,
    ];
}

impl ArcSine for f32 {
    const ASIN: &[f32] = &[0.16666752, 0.074953094, 0.045469142, 0.024184858, 0.042158145];
}

#[inline]
pub(crate) fn asin<F: ArcSine>(x: F) -> F {
    let [_, quarter, ..] = F::EIGHTHS;
    let a = x.abs();
    if a <= F::HALF {
        near_zero(a).value().copysign(x)
    } else if a <= F::ONE {
        quarter.plus(-F::TWO, near_one(a)).copysign(x)
    } else {
        F::NAN
    }
}

#[inline]
pub(crate) fn acos<F: ArcSine>(x: F) -> F {
    let [_, quarter, _, half] = F::EIGHTHS;
    let a = x.abs();
    if a <= F::HALF {
        quarter.plus(-F::ONE, near_zero(x))
    } else if a <= F::ONE {
        let rest = near_one(a);
        if x > F::ZERO { F::TWO * rest.value() } else { half.plus(-F::TWO, rest) }
    } else {
        F::NAN
    }
}

/// asin s, for |s| <= 1/2.
#[inline]
fn near_zero<F: ArcSine>(s: F) -> Pair<F> {
    let z = s * s;
    Pair { high: s, less: -(s * z * polynomial(z, F::ASIN)) }
}

/// asin sqrt((1 - a)/2), for 1/2 <= a <= 1.
#[inline]
fn near_one<F: ArcSine>(a: F) -> Pair<F> {
    let z = F::HALF * (F::ONE - a);
    let s = z.sqrt();
    let square = Pair::product(s, s);
    let error = if s > F::ZERO { ((square.high - z) - square.less) / (s + s) } else { F::ZERO };
    Pair { high: s, less: error - s * z * polynomial(z, F::ASIN) }
}
