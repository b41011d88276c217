//! Two numbers as one: what depends on the poses of two stages alone is computed side by side.

#![allow(clippy::inline_always, reason = "a call would end the vectors of its caller")]

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::Scalar;
use crate::vector::Vector;

/// Two values of `S` as one number; every operation gives each the bits that `S` gives, and compilers join the two in a
/// vector.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Two<S>(pub [S; 2]);

impl<S: Scalar> Two<S> {
    /// A number with two equal values.
    #[inline(always)]
    #[must_use]
    pub fn both(s: S) -> Self {
        Self([s; 2])
    }

    /// The first value, or the `SECOND`.
    #[inline(always)]
    pub fn of<const SECOND: bool>(self) -> S {
        let Self([first, second]) = self;
        if SECOND { second } else { first }
    }

    /// The first numbers of two states, as one.
    #[inline(always)]
    #[must_use]
    pub fn beginning<const N: usize, const K: usize>([first, second]: [&[S; N]; 2]) -> [Self; K] {
        Vector::from_fn(|i| Self([first.at(i), second.at(i)]))
    }

    #[inline(always)]
    fn each(self, f: impl Fn(S) -> S) -> Self {
        let Self([a, b]) = self;
        Self([f(a), f(b)])
    }

    #[inline(always)]
    fn join(self, other: Self, f: impl Fn(S, S) -> S) -> Self {
        let (Self([a, b]), Self([c, d])) = (self, other);
        Self([f(a, c), f(b, d)])
    }
}

macro_rules! operator {
    ($trait:ident, $name:ident) => {
        impl<S: Scalar> $trait for Two<S> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                self.join(other, S::$name)
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Scalar> Neg for Two<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(S::neg)
    }
}

impl<S: Scalar> Scalar for Two<S> {
    type Mask = [S::Mask; 2];
    type Turns = [S::Turns; 2];

    const ZERO: Self = Self([S::ZERO; 2]);
    const HEALTHY: f64 = S::HEALTHY;
    const MOST_GROWTH: f64 = S::MOST_GROWTH;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = S::HAS_DERIVATIVES;

    #[inline(always)]
    fn lit(x: f64) -> Self {
        Self::both(S::lit(x))
    }
    #[inline(always)]
    fn of_turns([a, b]: [S::Turns; 2]) -> Self {
        Self([S::of_turns(a), S::of_turns(b)])
    }
    #[inline(always)]
    fn to_turns(self) -> [S::Turns; 2] {
        self.0.map(S::to_turns)
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.of::<false>().to_f64()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        let Self([a, b]) = self;
        a.is_finite() && b.is_finite()
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let (Self([x, y]), Self([a, c]), Self([b, d])) = (self, a, b);
        Self([x.mul_add(a, b), y.mul_add(c, d)])
    }
    #[inline(always)]
    fn scaled(self, by: f64) -> Self {
        self.each(|s| s.scaled(by))
    }
    #[inline(always)]
    fn scaled_add(self, by: f64, b: Self) -> Self {
        self.join(b, |s, b| s.scaled_add(by, b))
    }
    #[inline(always)]
    fn dividing(self, constant: f64) -> Self {
        self.each(|s| s.dividing(constant))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sines, cosines) = S::sin_cos_all(self.0);
        (Self(sines), Self(cosines))
    }
    /// Two angles at a time: four values fill a vector.
    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sines, mut cosines) = ([Self::lit(0.0); N], [Self::lit(0.0); N]);
        let (pairs, rest) = angles.as_chunks::<2>();
        let (of_sines, last_sine) = sines.as_chunks_mut::<2>();
        let (of_cosines, last_cosine) = cosines.as_chunks_mut::<2>();
        for ((angles, s), c) in pairs.iter().zip(of_sines).zip(of_cosines) {
            let [Self([a, b]), Self([e, f])] = *angles;
            let [[s0, s1, s2, s3], [c0, c1, c2, c3]] = four([a, b, e, f]);
            (*s, *c) = ([Self([s0, s1]), Self([s2, s3])], [Self([c0, c1]), Self([c2, c3])]);
        }
        for ((angle, s), c) in rest.iter().zip(last_sine).zip(last_cosine) {
            (*s, *c) = angle.sin_cos();
        }
        (sines, cosines)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(S::sqrt)
    }
    #[inline(always)]
    fn tan(self) -> Self {
        self.each(S::tan)
    }
    #[inline(always)]
    fn asin(self) -> Self {
        self.each(S::asin)
    }
    #[inline(always)]
    fn acos(self) -> Self {
        self.each(S::acos)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.join(x, S::atan2)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        self.each(S::exp)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.each(S::ln)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.each(S::abs)
    }
    #[inline(always)]
    fn floor(self) -> Self {
        self.each(S::floor)
    }
    #[inline(always)]
    fn as_zero(self) -> Self {
        self.each(S::as_zero)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> [S::Mask; 2] {
        let (Self([a, b]), Self([c, d])) = (self, other);
        [a.lt(c), b.lt(d)]
    }
    #[inline(always)]
    fn select([first, second]: [S::Mask; 2], a: Self, b: Self) -> Self {
        let (Self([a, c]), Self([b, d])) = (a, b);
        Self([S::select(first, a, b), S::select(second, c, d)])
    }
    #[inline(always)]
    fn any([first, second]: [S::Mask; 2]) -> bool {
        S::any(first) | S::any(second)
    }
    #[inline(always)]
    fn all([first, second]: [S::Mask; 2]) -> bool {
        S::all(first) & S::all(second)
    }
}

/// Sines and cosines of four angles. Compilers begin to build vectors where results are stored: a function of its own.
#[inline(never)]
fn four<S: Scalar>(angles: [S; 4]) -> [[S; 4]; 2] {
    let (sines, cosines) = S::sin_cos_all(angles);
    [sines, cosines]
}
