//! Recorded numbers as scalars of generated code.

use plm_math::exact::Split;

use super::Traced;
use super::operation::make;
use crate::scalar::chain_rule::by_chain_rule;
use crate::scalar::{AtOnce, Operation, Real, Scalar};

impl<S: Real> Scalar for Traced<'_, S> {
    type Mask = bool;
    type Turns = i32;

    const ZERO: Self = Self::constant(S::ZERO);
    const HEALTHY: f64 = S::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = true;
    const AT_ONCE: AtOnce = AtOnce::Rates;

    by_chain_rule!(chain);

    #[inline]
    fn lit(x: f64) -> Self {
        Self::constant(S::lit(x))
    }

    /// Those of the values; by the variables of the trace they are not known before it is gone through backward.
    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        self.place() == other.place() && self.value.has_derivatives_of(other.value, within)
    }
    /// Infinite where it depends on variables of the trace.
    fn largest_derivative(self) -> f64 {
        self.place().map_or_else(|| self.value.largest_derivative(), |_| f64::INFINITY)
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self.add_product(a, b)
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
    fn weighted<const K: usize>(weights: [f64; K], number: impl Fn(usize) -> Self) -> Self {
        let value = S::weighted(weights, |k| number(k).value);
        Self::constant(S::ZERO).moved_by(S::lit(1.0), weights, number).with_value(value)
    }
    #[inline]
    fn moved<const K: usize>(self, h: Self, weights: [f64; K], number: impl Fn(usize) -> Self) -> Self {
        match h.place() {
            None => self.moved_by(h.value, weights, number),
            Some(_) => h.mul_add(Self::weighted(weights, number), self),
        }
    }
    #[inline]
    fn as_zero(self) -> Self {
        self.with_value(self.value.as_zero())
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
    type Plain = S::Plain;

    #[inline]
    fn plain(self) -> S::Plain {
        self.value.plain()
    }
    #[inline]
    fn of_plain(plain: S::Plain) -> Self {
        Self::constant(S::of_plain(plain))
    }
    #[inline]
    fn with_plain(self, plain: S::Plain) -> Self {
        self.with_value(self.value.with_plain(plain))
    }
    #[inline]
    fn make<O: Operation<Self>>(operation: O) -> O::Output {
        make(operation)
    }
    const EPSILON: Self = Self::constant(S::EPSILON);
    const RANK_TOLERANCE: Self = Self::constant(S::RANK_TOLERANCE);
    const DOUBLE_DOUBLE_EPSILON: Self = Self::constant(S::DOUBLE_DOUBLE_EPSILON);
    const INFINITY: Self = Self::constant(S::INFINITY);
}
