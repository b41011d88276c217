//! Dual numbers: a value and its derivatives in several directions at once.
//!
//! Generated code is generic over its scalar, so that its exact derivatives come from running it on [`Dual`]: forward
//! mode of automatic differentiation (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, 3.1). Several
//! directions share one evaluation of the values, of sines and roots above all. The values have the same bits as those
//! of the scalar alone.

mod few;
mod scalar;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_math::exact::Split;

use crate::scalar::Real;

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

/// The halves are those of the value. The upper one moves and the lower one does not, as if it were a constant.
impl<S: Real, const K: usize> Split for Dual<S, K> {
    const DIGITS: u32 = S::DIGITS;

    #[inline]
    fn split(self) -> (Self, Self) {
        let (high, low) = self.value.split();
        (Self { value: high, ..self }, Self::constant(low))
    }
}
