//! Length of a vector.
//!
//! Method: the squares are taken with their rounding errors (Dekker), as in musl's hypot.c; lengths whose squares
//! would overflow or lose bits are scaled by a power of two.

use crate::float::{Float, scale_to_one};
use crate::pair::Pair;

#[inline]
pub(crate) fn hypot<F: Float>(x: F, y: F) -> F {
    let (larger, smaller) = if y.abs() > x.abs() { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    if smaller >= F::power_of_two(-F::SCALE) && larger <= F::power_of_two(F::SCALE) {
        length(larger, smaller)
    } else {
        hypot_extreme(larger, smaller)
    }
}

#[inline]
fn length<F: Float>(larger: F, smaller: F) -> F {
    let (a, b) = (Pair::product(larger, larger), Pair::product(smaller, smaller));
    let sum = Pair::sum(a.high, b.high);
    (sum.high - (sum.less + (a.less + b.less))).sqrt()
}

/// Coordinates that are zero, infinite, NaN, or very large or small.
#[cold]
#[inline(never)]
fn hypot_extreme<F: Float>(x: F, y: F) -> F {
    if x == F::INFINITY || y == F::INFINITY {
        F::INFINITY
    } else if y <= x * F::power_of_two(-F::DIGITS - 8) {
        x
    } else if x >= y {
        let k = scale_to_one(x);
        let scale = F::power_of_two(k);
        length(x * scale, y * scale) * F::power_of_two(-k)
    } else {
        F::NAN
    }
}
