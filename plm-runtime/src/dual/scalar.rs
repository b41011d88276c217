//! Dual numbers as numbers of generated code.

use super::{Dual, few};
use crate::scalar::chain_rule::by_chain_rule;
use crate::scalar::{AtOnce, Operation, Real, Registers, Scalar};

impl<S: Real, const K: usize> Scalar for Dual<S, K> {
    type Mask = bool;
    type Turns = i32;

    const ZERO: Self = Self { value: S::ZERO, tangents: [S::ZERO; K] };
    const HEALTHY: f64 = S::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = true;
    const AT_ONCE: AtOnce = if K > few::MOST { AtOnce::Steps } else { AtOnce::Nothing };
    const REGISTERS: Registers = if K > 1 { Registers::Filled } else { Registers::Scalar };

    by_chain_rule!(chain_steep);

    /// The zeros of its derivatives are negative: to add one changes nothing whatever the sign, so that compilers leave it out. Those of zero
    /// are like it: what begins as zeros is filled with bytes, not copied.
    #[inline]
    fn lit(x: f64) -> Self {
        Self { value: S::lit(x), tangents: [S::lit(if x == 0.0 { x } else { -0.0 }); K] }
    }
    #[inline]
    fn scaled(self, by: f64) -> Self {
        Self::with_tangents(self.value.scaled(by), |k| self.tangents[k].scaled(by))
    }
    #[inline]
    fn scaled_add(self, by: f64, b: Self) -> Self {
        let value = self.value.scaled_add(by, b.value);
        Self::with_tangents(value, |k| self.tangents[k].scaled_add(by, b.tangents[k]))
    }
    #[inline]
    fn dividing(self, constant: f64) -> Self {
        let (value, reciprocal) = (self.value.dividing(constant), S::lit(1.0) / self.value);
        self.chain(value, -(value * reciprocal))
    }
    /// Weights are numbers: they take one product of each derivative.
    #[allow(clippy::inline_always, reason = "it is the formula")]
    #[inline(always)]
    fn weighted<const N: usize>(weights: [f64; N], number: impl Fn(usize) -> Self) -> Self {
        if K == 1 {
            let tangent = |k: usize| S::weighted(weights, |n| number(n).tangents[k]);
            let value = S::weighted(weights, |n| number(n).value);
            return Self::with_tangents(value, tangent);
        }
        let mut sum = Self::ZERO;
        for (n, weight) in weights.into_iter().enumerate() {
            let (weight, Self { value, tangents }) = (S::lit(weight), number(n));
            let is_first = n == 0;
            sum.value = if is_first { weight * value } else { weight.mul_add(value, sum.value) };
            for k in 0..K {
                let tangent = tangents[k];
                sum.tangents[k] =
                    if is_first { weight * tangent } else { weight.mul_add(tangent, sum.tangents[k]) };
            }
        }
        sum
    }
    #[allow(clippy::inline_always, reason = "as above")]
    #[inline(always)]
    fn moved<const N: usize>(self, h: Self, weights: [f64; N], number: impl Fn(usize) -> Self) -> Self {
        h.mul_add(Self::weighted(weights, number), self)
    }

    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        let (mut difference, mut size) = (0.0_f64, 0.0_f64);
        for (a, b) in self.tangents.into_iter().zip(other.tangents) {
            difference = difference.max((a - b).to_f64().abs());
            size = size.max(a.to_f64().abs());
        }
        difference <= within * size
    }
    fn largest_derivative(self) -> f64 {
        self.tangents.into_iter().fold(0.0, |most, tangent| most.max(tangent.to_f64().abs()))
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let (x, y) = (self.value, a.value);
        let value = x.mul_add(y, b.value);
        let tangent = |k: usize| x.mul_add(a.tangents[k], self.tangents[k].mul_add(y, b.tangents[k]));
        Self::with_tangents(value, tangent)
    }
    /// The derivative at the origin is not a number, or zero in directions in which the point does not move.
    #[inline]
    fn atan2(self, x: Self) -> Self {
        let (b, a) = (self.value, x.value);
        let square = a.mul_add(a, b * b);
        let (along_y, along_x) = (a / square, b / square);
        let turn = |dy: S, dx: S| {
            if dy == S::ZERO && dx == S::ZERO { S::ZERO } else { along_y * dy - along_x * dx }
        };
        self.join(x, b.atan2(a), turn)
    }
    #[inline]
    fn as_zero(self) -> Self {
        Self { value: self.value.as_zero(), ..self }
    }
}

impl<S: Real, const K: usize> Real for Dual<S, K> {
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
        Self { value: self.value.with_plain(plain), ..self }
    }
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    fn make<O: Operation<Self>>(operation: O) -> O::Output {
        if const { Self::AT_ONCE.has_steps() } { few::make(operation) } else { operation.make() }
    }
    const EPSILON: Self = Self { value: S::EPSILON, tangents: [S::ZERO; K] };
    const RANK_TOLERANCE: Self = Self { value: S::RANK_TOLERANCE, tangents: [S::ZERO; K] };
    const DOUBLE_DOUBLE_EPSILON: Self = Self { value: S::DOUBLE_DOUBLE_EPSILON, tangents: [S::ZERO; K] };
    const INFINITY: Self = Self { value: S::INFINITY, tangents: [S::ZERO; K] };
}
