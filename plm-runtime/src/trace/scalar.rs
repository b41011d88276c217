//! Recorded numbers as scalars of generated code.

use plm_math::exact::Split;

use super::Traced;
use crate::scalar::{Real, Scalar};

impl<S: Real> Scalar for Traced<'_, S> {
    type Mask = bool;
    type Turns = i32;

    const ZERO: Self = Self::constant(S::ZERO);
    const HEALTHY: f64 = S::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = true;

    #[inline]
    fn lit(x: f64) -> Self {
        Self::constant(S::lit(x))
    }
    #[inline]
    fn of_turns(turns: i32) -> Self {
        Self::constant(S::of_turns(turns))
    }
    #[inline]
    fn to_turns(self) -> i32 {
        self.value.to_turns()
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }
    /// Those of the values; by the variables of the trace they are not known before it is gone through backward.
    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        self.place() == other.place() && self.value.has_derivatives_of(other.value, within)
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self.add_product(a, b)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sin, cos) = S::sin_cos_all(angles.map(|angle| angle.value));
        (
            core::array::from_fn(|i| angles[i].chain(sin[i], cos[i])),
            core::array::from_fn(|i| angles[i].chain(cos[i], -sin[i])),
        )
    }
    /// The derivative at zero is infinite.
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, S::lit(0.5) / root)
    }
    #[inline]
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, tan.mul_add(tan, S::lit(1.0)))
    }
    /// The derivative at -1 and 1 is infinite.
    #[inline]
    fn asin(self) -> Self {
        self.chain(self.value.asin(), S::lit(1.0) / half_chord(self.value))
    }
    /// As [`asin`](Self::asin).
    #[inline]
    fn acos(self) -> Self {
        self.chain(self.value.acos(), S::lit(-1.0) / half_chord(self.value))
    }
    /// The derivative at the origin is not a number.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (b, a) = (self.value, x.value);
        let by = || {
            let square = a.mul_add(a, b * b);
            [a / square, -(b / square)]
        };
        self.join(x, b.atan2(a), by)
    }
    #[inline]
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
    /// The derivative at zero is infinite.
    #[inline]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), S::lit(1.0) / self.value)
    }
    /// The derivative at zero is zero, the middle of its two sides.
    #[inline]
    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.signum0())
    }
    #[inline]
    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }
    #[inline]
    fn as_zero(self) -> Self {
        self.with_value(self.value.as_zero())
    }
    #[inline]
    fn lt(self, other: Self) -> bool {
        self.value < other.value
    }
    #[inline]
    fn select(mask: bool, a: Self, b: Self) -> Self {
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
    #[inline]
    fn powi(self, n: i32) -> Self {
        // x^0 is constant; everywhere else x^(n-1) exists where x^n does.
        let slope =
            if n == 0 { S::ZERO } else { S::lit(f64::from(n)) * self.value.powi(n.saturating_sub(1)) };
        self.chain(self.value.powi(n), slope)
    }
}

/// The halves are those of the value. The upper one moves and the lower one does not, as if it were a constant.
impl<S: Real> Split for Traced<'_, S> {
    const DIGITS: u32 = S::DIGITS;

    #[inline]
    fn split(self) -> (Self, Self) {
        let (high, low) = self.value.split();
        (self.with_value(high), Self::constant(low))
    }
}

impl<S: Real> Real for Traced<'_, S> {
    const EPSILON: Self = Self::constant(S::EPSILON);
    const RANK_TOLERANCE: Self = Self::constant(S::RANK_TOLERANCE);
    const DOUBLE_DOUBLE_EPSILON: Self = Self::constant(S::DOUBLE_DOUBLE_EPSILON);
    const INFINITY: Self = Self::constant(S::INFINITY);
}

/// sqrt(1 - x^2) without cancellation.
#[inline]
fn half_chord<S: Real>(x: S) -> S {
    let one = S::lit(1.0);
    ((one - x) * (one + x)).sqrt()
}
