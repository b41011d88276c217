//! Constants that multiply.

#![allow(clippy::inline_always, reason = "it is the operation")]

use core::ops::{Div, Mul};

use super::Scalar;

/// A constant that multiplies a number or is divided by it. It has the bits of [`Scalar::lit`]; numbers with derivatives compute with it
/// without those of the constant, which are zero.
#[derive(Clone, Copy, Debug)]
pub struct Factor(pub f64);

impl Factor {
    /// `self * a + b`.
    #[inline(always)]
    #[must_use]
    pub fn mul_add<S: Scalar>(self, a: S, b: S) -> S {
        a.scaled_add(self.0, b)
    }
}

impl<S: Scalar> Mul<S> for Factor {
    type Output = S;
    #[inline(always)]
    fn mul(self, number: S) -> S {
        number.scaled(self.0)
    }
}

impl<S: Scalar> Div<S> for Factor {
    type Output = S;
    #[inline(always)]
    fn div(self, number: S) -> S {
        number.dividing(self.0)
    }
}
