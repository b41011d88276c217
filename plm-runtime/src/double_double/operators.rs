//! The operators, each one call.

use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_math::exact::Split;

use super::DoubleDouble;
use crate::scalar::Real;

impl<S: Real> Add for DoubleDouble<S> {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        self.plus(other)
    }
}

impl<S: Real> Sub for DoubleDouble<S> {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self.plus(other.negated())
    }
}

impl<S: Real> Mul for DoubleDouble<S> {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl<S: Real> Div for DoubleDouble<S> {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        self.over(other)
    }
}

impl<S: Real> Neg for DoubleDouble<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.negated()
    }
}

/// The two halves are its words.
impl<S: Real> Split for DoubleDouble<S> {
    const DIGITS: u32 = 2 * S::DIGITS;

    #[inline]
    fn split(self) -> (Self, Self) {
        (Self::of(self.high), Self::of(self.low))
    }
}
