//! Dual numbers: a value and its derivatives in several directions at once.
//!
//! Generated code is generic over its scalar, so that its exact derivatives come from running it on [`Dual`]: forward
//! mode of automatic differentiation (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, 3.1). Several
//! directions share one evaluation of the values, of sines and roots above all. The values have the same bits as those
//! of the scalar alone.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_math::exact::Split;

use crate::scalar::{Real, Scalar};

/// A number and its derivatives in `K` directions.
///
/// Whatever decides (comparisons, selections, [`is_finite`](Scalar::is_finite)) decides by the value: where a function
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

    /// `f(self)` by the chain rule, where `f` is `value` and its derivative `slope`.
    #[inline]
    fn chain(self, value: S, slope: S) -> Self {
        Self { value, tangents: self.tangents.map(|tangent| slope * tangent) }
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
        Self { value, tangents: core::array::from_fn(|k| f(self.tangents[k], other.tangents[k])) }
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
        Self { value: -self.value, tangents: self.tangents.map(|tangent| -tangent) }
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
    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        let (mut difference, mut size) = (0.0_f64, 0.0_f64);
        for (a, b) in self.tangents.into_iter().zip(other.tangents) {
            difference = difference.max((a - b).to_f64().abs());
            size = size.max(a.to_f64().abs());
        }
        difference <= within * size
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let (x, y) = (self.value, a.value);
        let value = x.mul_add(y, b.value);
        let tangent = |k: usize| x.mul_add(a.tangents[k], self.tangents[k].mul_add(y, b.tangents[k]));
        Self { value, tangents: core::array::from_fn(tangent) }
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
    /// The derivative at zero is infinite, or zero in directions in which the number does not move.
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain_steep(root, S::lit(0.5) / root)
    }
    #[inline]
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, tan.mul_add(tan, S::lit(1.0)))
    }
    /// The derivative at -1 and 1 is infinite, or zero in directions in which the number does not move.
    #[inline]
    fn asin(self) -> Self {
        self.chain_steep(self.value.asin(), S::lit(1.0) / half_chord(self.value))
    }
    /// As [`asin`](Self::asin).
    #[inline]
    fn acos(self) -> Self {
        self.chain_steep(self.value.acos(), S::lit(-1.0) / half_chord(self.value))
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
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
    /// The derivative at zero is infinite, or zero in directions in which the number does not move.
    #[inline]
    fn ln(self) -> Self {
        self.chain_steep(self.value.ln(), S::lit(1.0) / self.value)
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
        Self { value: self.value.as_zero(), ..self }
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
        self.chain_steep(self.value.powi(n), slope)
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
    const EPSILON: Self = Self { value: S::EPSILON, tangents: [S::ZERO; K] };
    const RANK_TOLERANCE: Self = Self { value: S::RANK_TOLERANCE, tangents: [S::ZERO; K] };
    const DOUBLE_DOUBLE_EPSILON: Self = Self { value: S::DOUBLE_DOUBLE_EPSILON, tangents: [S::ZERO; K] };
    const INFINITY: Self = Self { value: S::INFINITY, tangents: [S::ZERO; K] };
}

/// sqrt(1 - x^2) without cancellation.
#[inline]
fn half_chord<S: Real>(x: S) -> S {
    let one = S::lit(1.0);
    ((one - x) * (one + x)).sqrt()
}
