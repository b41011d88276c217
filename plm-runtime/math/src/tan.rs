//! Tangent: the quotient of sine and cosine, both taken before their final rounding.

use crate::sin_cos::{Angle, parts};

#[inline]
pub(crate) fn tan<F: Angle>(x: F) -> F {
    if x.abs() < F::INFINITY {
        let (odd, s, c) = parts(x);
        let (s, c) = (s.rounded(), c.rounded());
        if odd { (-c).over(s).value() } else { s.over(c).value() }
    } else {
        F::NAN
    }
}
