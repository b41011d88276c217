//! Integer powers.

use crate::float::Float;

/// x^n by squaring, the factors taken in one fixed order. A negative power is the inverse of the positive one.
#[inline]
pub(crate) fn powi<F: Float>(x: F, n: i32) -> F {
    let magnitude = n.unsigned_abs();
    if n >= 0 {
        return power(x, magnitude);
    }
    let inverse = F::ONE / power(x, magnitude);
    if inverse == F::ZERO && x.abs() < F::INFINITY {
        // The positive power overflowed, the negative one need not vanish: it is made from two factors.
        let half = magnitude / 2;
        (F::ONE / power(x, half)) * (F::ONE / power(x, magnitude - half))
    } else {
        inverse
    }
}

#[inline]
fn power<F: Float>(x: F, mut n: u32) -> F {
    let mut factor = x;
    let mut result = F::ONE;
    while n != 0 {
        if n & 1 == 1 {
            result = result * factor;
        }
        n >>= 1;
        if n != 0 {
            factor = factor * factor;
        }
    }
    result
}
