//! Dual numbers: a value and its derivatives in several directions at once.
//!
//! Generated code is generic over its scalar, so that its exact derivatives come from running it on [`Dual`]: forward
//! mode of automatic differentiation (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, 3.1). Several
//! directions share one evaluation of the values, of sines and roots above all. The values have the same bits as those
//! of the scalar alone.

mod few;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_math::exact::Split;

use crate::scalar::chain_rule::by_chain_rule;
use crate::scalar::{AtOnce, Operation, Real, Registers, Scalar};

/// A number and its derivatives in `K` directions.
///
/// Whatever decides (comparisons, selections, [`is_finite`](crate::Scalar::is_finite)) decides by the value: where a function
/// has a kink, the derivative is that of the side which the value takes.
#[derive(Clone, Copy, Debug)]
pub struct Dual<S, const K: usize> {
    /// The number.
    pub value: S,
    /// Its derivatives.
    pub tangents: [S; K],
}

impl<S: Real, const K: usize> Dual<S, K> {
    /// A number that does not depend on anything.
    #[inline]
    pub fn constant(value: S) -> Self {
        Self { value, tangents: [S::ZERO; K] }
    }

    /// The variable that belongs to the direction with this index; a constant if there is no such direction.
    #[inline]
    pub fn variable(value: S, direction: usize) -> Self {
        let one = S::lit(1.0);
        Self { value, tangents: core::array::from_fn(|k| if k == direction { one } else { S::ZERO }) }
    }

    /// `value` with a derivative of each direction. `core::array::from_fn` is not always part of its caller.
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    fn with_tangents(value: S, tangent: impl Fn(usize) -> S) -> Self {
        let mut tangents = [S::ZERO; K];
        for k in 0..K {
            tangents[k] = tangent(k);
        }
        Self { value, tangents }
    }

    /// `f(self)` by the chain rule, where `f` is `value` and its derivative `slope`.
    #[inline]
    fn chain(self, value: S, slope: S) -> Self {
        Self::with_tangents(value, |k| slope * self.tangents[k])
    }

    /// As [`chain`](Self::chain) where the slope may be infinite: what does not move stays so.
    #[inline]
    fn chain_steep(self, value: S, slope: S) -> Self {
        let product = |tangent: S| if tangent == S::ZERO { tangent } else { slope * tangent };
        Self { value, tangents: self.tangents.map(product) }
    }

    /// `value` with the derivatives `f(self', other')`.
    #[inline]
    fn join(self, other: Self, value: S, f: impl Fn(S, S) -> S) -> Self {
        Self::with_tangents(value, |k| f(self.tangents[k], other.tangents[k]))
    }
}

/// A number that does not depend on anything.
impl<S: Real, const K: usize> From<S> for Dual<S, K> {
    #[inline]
    fn from(value: S) -> Self {
        Self::constant(value)
    }
}

impl<S: Real, const K: usize> Add for Dual<S, K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.join(other, self.value + other.value, |a, b| a + b)
    }
}

impl<S: Real, const K: usize> Sub for Dual<S, K> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.join(other, self.value - other.value, |a, b| a - b)
    }
}

impl<S: Real, const K: usize> Mul for Dual<S, K> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        self.join(other, x * y, |a, b| x.mul_add(b, a * y))
    }
}

impl<S: Real, const K: usize> Div for Dual<S, K> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let (value, reciprocal) = (self.value / other.value, S::lit(1.0) / other.value);
        self.join(other, value, |a, b| (a - value * b) * reciprocal)
    }
}

impl<S: Real, const K: usize> Neg for Dual<S, K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::with_tangents(-self.value, |k| -self.tangents[k])
    }
}

impl<S: Real, const K: usize> PartialEq for Dual<S, K> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: Real, const K: usize> PartialOrd for Dual<S, K> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

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

/// The halves are those of the value. The upper one moves and the lower one does not, as if it were a constant.
impl<S: Real, const K: usize> Split for Dual<S, K> {
    const DIGITS: u32 = S::DIGITS;

    #[inline]
    fn split(self) -> (Self, Self) {
        let (high, low) = self.value.split();
        (Self { value: high, ..self }, Self::constant(low))
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
