//! Numbers with a one-sided derivative: how a run changes if the variable of differentiation moves a little to one side.
//!
//! A number is a value and after it an infinitesimal multiple, in lexicographic order: two of equal value are ordered by their derivatives.
//! So each side by itself decides the order of two events at one time, a touch, and a friction at its limit (directional derivatives of
//! piecewise smooth functions: A. Griewank, On stable piecewise linearization and generalized algorithmic differentiation, Optim. Methods
//! Softw. 28, 2013).

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_math::exact::Split;

use crate::dual::Dual;
use crate::scalar::{Real, Scalar};

/// The side to which a number goes from its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// It grows.
    Above,
    /// It falls.
    Below,
}

impl Side {
    /// The derivative of a result by the number that goes to this side.
    pub fn derivative<S: Real>(self, result: OneSided<S>) -> S {
        match self {
            Self::Above => result.slope(),
            Self::Below => -result.slope(),
        }
    }
}

/// A number and its derivative along one direction, to its end alone.
///
/// It is ordered by its value where a run is controlled; what a formula selects by, it selects by the slope where values are equal.
#[derive(Clone, Copy, Debug)]
pub struct OneSided<S>(Dual<S, 1>);

impl<S: Real> OneSided<S> {
    /// A number that does not depend on anything.
    #[inline]
    pub fn constant(value: S) -> Self {
        Self(Dual::constant(value))
    }

    /// The variable, that goes to a side.
    pub fn variable(value: S, side: Side) -> Self {
        let slope = S::lit(if side == Side::Above { 1.0 } else { -1.0 });
        Self(Dual { value, tangents: [slope] })
    }

    /// The number.
    #[inline]
    pub fn value(self) -> S {
        self.0.value
    }

    /// How it changes along the direction.
    #[inline]
    pub fn slope(self) -> S {
        let [slope] = self.0.tangents;
        slope
    }
}

/// A number that does not depend on anything.
impl<S: Real> From<S> for OneSided<S> {
    #[inline]
    fn from(value: S) -> Self {
        Self::constant(value)
    }
}

impl<S: Real> PartialEq for OneSided<S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<S: Real> PartialOrd for OneSided<S> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

macro_rules! operators {
    ($($trait:ident $name:ident),*) => {$(
        impl<S: Real> $trait for OneSided<S> {
            type Output = Self;
            #[inline]
            fn $name(self, other: Self) -> Self {
                Self(self.0.$name(other.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl<S: Real> Neg for OneSided<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Functions of a dual number.
macro_rules! of_dual {
    ($($name:ident),*) => {$(
        #[inline]
        fn $name(self) -> Self {
            Self(self.0.$name())
        }
    )*};
}

impl<S: Real> Scalar for OneSided<S> {
    type Mask = bool;
    type Turns = i32;

    const ZERO: Self = Self(Dual::ZERO);
    const HEALTHY: f64 = S::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = true;

    of_dual!(sqrt, tan, asin, acos, exp, ln, floor, as_zero);

    #[inline]
    fn lit(x: f64) -> Self {
        Self(Dual::lit(x))
    }
    #[inline]
    fn of_turns(turns: i32) -> Self {
        Self(Dual::of_turns(turns))
    }
    #[inline]
    fn to_turns(self) -> i32 {
        self.0.to_turns()
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline]
    fn goes(self) -> Option<f64> {
        Some(self.slope().to_f64())
    }
    #[inline]
    fn has_derivatives_of(self, other: Self, within: f64) -> bool {
        self.0.has_derivatives_of(other.0, within)
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.mul_add(a.0, b.0))
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = Dual::sin_cos_all(angles.map(|angle| angle.0));
        (sines.map(Self), cosines.map(Self))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    #[inline]
    fn powi(self, n: i32) -> Self {
        Self(self.0.powi(n))
    }
    #[inline]
    fn abs(self) -> Self {
        if self.lt(Self::ZERO) { -self } else { self }
    }
    #[inline]
    fn lt(self, other: Self) -> bool {
        let order = self.value().partial_cmp(&other.value());
        order == Some(Ordering::Less) || order == Some(Ordering::Equal) && self.slope() < other.slope()
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
}

/// The halves are those of the value.
impl<S: Real> Split for OneSided<S> {
    const DIGITS: u32 = S::DIGITS;

    #[inline]
    fn split(self) -> (Self, Self) {
        let (high, low) = self.0.split();
        (Self(high), Self(low))
    }
}

impl<S: Real> Real for OneSided<S> {
    type Plain = S::Plain;

    #[inline]
    fn plain(self) -> S::Plain {
        self.0.plain()
    }
    #[inline]
    fn of_plain(plain: S::Plain) -> Self {
        Self(Dual::of_plain(plain))
    }
    #[inline]
    fn with_plain(self, plain: S::Plain) -> Self {
        Self(self.0.with_plain(plain))
    }
    const EPSILON: Self = Self(Dual::EPSILON);
    const RANK_TOLERANCE: Self = Self(Dual::RANK_TOLERANCE);
    const DOUBLE_DOUBLE_EPSILON: Self = Self(Dual::DOUBLE_DOUBLE_EPSILON);
    const INFINITY: Self = Self(Dual::INFINITY);
}
