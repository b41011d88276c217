//! Numbers that generated code computes with.
//!
//! [`Scalar`] is what a right-hand side needs: arithmetic, elementary functions, and selection instead of branches, so
//! that several trajectories in the lanes of one vector register are a scalar too. [`Real`] is one real number
//! (`f32`, `f64`), on which step control and assembly can decide.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

mod at_once;
pub(crate) mod chain_rule;
mod factor;
mod floats;
#[cfg(feature = "fma")]
mod fused;
mod operation;
mod real;
mod registers;

pub use self::at_once::AtOnce;
pub use self::factor::Factor;
pub use self::operation::Operation;
pub use self::real::Real;
pub use self::registers::Registers;

/// A number, or several in lanes, with the operations of a right-hand side.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The outcome of a comparison, lane by lane.
    type Mask: Copy + Debug;
    /// Number of revolutions of an angle, lane by lane.
    type Turns: Copy + Debug + PartialEq;

    /// 0, in every lane.
    const ZERO: Self;
    /// Smallest pivot ratio ([`Health`](crate::Health)) at which a solution without pivoting is accepted.
    ///
    /// With the ratio r such a solution is good to about eps / r, the one by rank to eps / sqrt(r). At
    /// r = eps^(1/3) the first still has two thirds of all digits, which no step of usual accuracy notices.
    const HEALTHY: f64;
    /// Largest ratio of a diagonal entry to its pivot; a row beyond it depends on others and is left out. Where numbers are
    /// as exact as the lengths, rounding and a singular pose cannot be distinguished, and no row is left out.
    const MOST_GROWTH: f64 = f64::INFINITY;
    /// Lengths that repeat each other may differ by one part in so many; the rest of what they differ by is not rounding.
    const AGREEMENT: f64;
    /// A unit in the last place of 1: two numbers that differ by less are one.
    const PRECISION: f64;
    /// Such a number carries derivatives: an iteration goes on until they have converged too.
    const HAS_DERIVATIVES: bool = false;
    /// Operations of many such numbers that are made at once.
    const AT_ONCE: AtOnce = AtOnce::Nothing;
    /// How such numbers use vector registers.
    const REGISTERS: Registers = Registers::Scalar;

    /// The constant `x`, rounded to this type, in every lane.
    fn lit(x: f64) -> Self;
    /// Number of revolutions as a scalar.
    fn of_turns(turns: Self::Turns) -> Self;
    /// A whole number as a number of revolutions.
    fn to_turns(self) -> Self::Turns;
    /// The value as `f64`; of the first lane where there are several (times are equal in all lanes).
    fn to_f64(self) -> f64;
    /// Neither infinite nor NaN, in every lane.
    fn is_finite(self) -> bool;
    /// Does the number have the derivatives of another one, but for this part of their size? False where they are not known.
    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        let _ = (self, other, within);
        true
    }

    /// Largest derivative of the number that holds on both sides; 0 if its derivatives are not known, and for numbers without derivatives.
    #[inline]
    fn largest_derivative(self) -> f64 {
        0.0
    }

    /// Derivative of a number that has a one-sided one ([`OneSided`](crate::OneSided)); `None` for every other type.
    #[inline]
    fn goes(self) -> Option<f64> {
        None
    }

    /// `self * a + b`: two roundings, or one with the feature `fma`.
    #[must_use]
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// `lit(by) * self`.
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    #[must_use]
    fn scaled(self, by: f64) -> Self {
        Self::lit(by) * self
    }
    /// `lit(by) * self + b`, as [`mul_add`](Self::mul_add).
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    #[must_use]
    fn scaled_add(self, by: f64, b: Self) -> Self {
        Self::lit(by).mul_add(self, b)
    }
    /// `lit(constant) / self`.
    #[allow(clippy::inline_always, reason = "it is the operation")]
    #[inline(always)]
    #[must_use]
    fn dividing(self, constant: f64) -> Self {
        Self::lit(constant) / self
    }
    /// The sum of weight times number, in the order of the weights.
    #[inline]
    #[must_use]
    fn weighted<const K: usize>(weights: [f64; K], number: impl Fn(usize) -> Self) -> Self {
        let mut sum = Self::lit(0.0);
        for k in 0..K {
            let (weight, s) = (Self::lit(weights[k]), number(k));
            sum = if k == 0 { weight * s } else { weight.mul_add(s, sum) };
        }
        sum
    }
    /// `h * weighted(...) + self`.
    #[inline]
    #[must_use]
    fn moved<const K: usize>(self, h: Self, weights: [f64; K], number: impl Fn(usize) -> Self) -> Self {
        h.mul_add(Self::weighted(weights, number), self)
    }
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    /// Sines and cosines of several angles, the same bits as one by one, in vector instructions where there are some.
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);
    /// [`sin_cos`](Self::sin_cos); with `DIRECT` no branch is compiled, and angles must be [`Real::are_direct`].
    #[inline]
    #[must_use]
    fn sin_cos_by<const DIRECT: bool>(self) -> (Self, Self) {
        self.sin_cos()
    }
    /// [`sin_cos_all`](Self::sin_cos_all), in the same way.
    #[allow(clippy::inline_always, reason = "a call would end the vectors of its caller")]
    #[inline(always)]
    #[must_use]
    fn sin_cos_all_by<const DIRECT: bool, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        Self::sin_cos_all(angles)
    }
    /// Square root, correctly rounded; NaN below zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The root of a number, or of zero if that is larger; with `DIRECT` NaN below zero.
    #[inline]
    #[must_use]
    fn root_by<const DIRECT: bool>(self) -> Self {
        if DIRECT { self.sqrt() } else { Self::lit(0.0).max(self).sqrt() }
    }
    /// Tangent of an angle in rad.
    #[must_use]
    fn tan(self) -> Self;
    /// Arc sine in rad, in [-pi/2, pi/2]; NaN outside [-1, 1].
    #[must_use]
    fn asin(self) -> Self;
    /// Arc cosine in rad, in [0, pi]; NaN outside [-1, 1].
    #[must_use]
    fn acos(self) -> Self;
    /// Angle of the point (`x`, `self`) from the positive x axis, in rad, in [-pi, pi].
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Such angles of several points, the same bits as one by one, in vector instructions where there are some.
    #[inline]
    #[must_use]
    fn atan2_all<const N: usize>(y: [Self; N], x: [Self; N]) -> [Self; N] {
        core::array::from_fn(|i| y[i].atan2(x[i]))
    }
    /// Exponential function.
    #[must_use]
    fn exp(self) -> Self;
    /// That of several numbers, as [`atan2_all`](Self::atan2_all).
    #[inline]
    #[must_use]
    fn exp_all<const N: usize>(x: [Self; N]) -> [Self; N] {
        x.map(Self::exp)
    }
    /// Natural logarithm; NaN below zero.
    #[must_use]
    fn ln(self) -> Self;
    /// That of several numbers, as [`atan2_all`](Self::atan2_all).
    #[inline]
    #[must_use]
    fn ln_all<const N: usize>(x: [Self; N]) -> [Self; N] {
        x.map(Self::ln)
    }
    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// The largest integer that is not above the number.
    #[must_use]
    fn floor(self) -> Self;

    /// Zero, with the derivatives of this number where it has some.
    #[inline]
    #[must_use]
    fn as_zero(self) -> Self {
        Self::ZERO
    }

    /// `self < other`.
    fn lt(self, other: Self) -> Self::Mask;
    /// `a` where the mask is set, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// The mask `a` where the mask is set, `b` elsewhere.
    #[inline]
    fn choose(mask: Self::Mask, a: Self::Mask, b: Self::Mask) -> Self::Mask {
        let number = |mask| Self::select(mask, Self::lit(1.0), Self::ZERO);
        Self::ZERO.lt(Self::select(mask, number(a), number(b)))
    }
    /// Is the mask set in some lane?
    fn any(mask: Self::Mask) -> bool;
    /// Is the mask set in every lane?
    fn all(mask: Self::Mask) -> bool;

    /// The slice as `f64`; `None` if the numbers are of another type. Code that computes with `f64` alone is called so.
    #[inline]
    #[must_use]
    fn f64s(numbers: &[Self]) -> Option<&[f64]> {
        let _ = numbers;
        None
    }
    /// [`f64s`](Self::f64s), to be written.
    #[inline]
    #[must_use]
    fn f64s_mut(numbers: &mut [Self]) -> Option<&mut [f64]> {
        let _ = numbers;
        None
    }

    /// Sine of an angle in rad.
    #[inline]
    #[must_use]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine of an angle in rad.
    #[inline]
    #[must_use]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// -1, 0 or 1 by the sign of the number; 0 at both zeros and at NaN (`f64::signum` has no zero).
    #[inline]
    #[must_use]
    fn signum0(self) -> Self {
        let zero = Self::lit(0.0);
        let upper = Self::select(Self::lt(zero, self), Self::lit(1.0), zero);
        Self::select(self.lt(zero), Self::lit(-1.0), upper)
    }
    /// The smaller number; `other` if one of the two is NaN.
    #[inline]
    #[must_use]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// The larger number; `other` if one of the two is NaN.
    #[inline]
    #[must_use]
    fn max(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    /// `self` to the power `n`, by repeated squaring.
    #[inline]
    #[must_use]
    fn powi(self, n: i32) -> Self {
        let mut power = Self::lit(1.0);
        let mut square = self;
        let mut rest = n.unsigned_abs();
        while rest > 0 {
            if rest & 1 == 1 {
                power = power * square;
            }
            square = square * square;
            rest >>= 1;
        }
        if n < 0 { Self::lit(1.0) / power } else { power }
    }
}
