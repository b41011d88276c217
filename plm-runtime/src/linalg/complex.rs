//! Complex numbers, as far as an elimination needs them.

use core::ops::{Add, Mul, Sub};

use crate::scalar::Real;

/// An entry of a matrix: real or complex.
pub trait Entry<S>: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The real number as such an entry.
    fn real(s: S) -> Self;
    /// A measure of the absolute value that is cheap and right to a factor of sqrt(2).
    fn size(self) -> S;
    /// `s self`.
    #[must_use]
    fn times(self, s: S) -> Self;
    /// 1 / self.
    #[must_use]
    fn reciprocal(self) -> Self;
    /// `self - a b`.
    #[must_use]
    fn less_product(self, a: Self, b: Self) -> Self;
}

impl<S: Real> Entry<S> for S {
    #[inline]
    fn real(s: S) -> Self {
        s
    }
    #[inline]
    fn size(self) -> S {
        self.abs()
    }
    #[inline]
    fn times(self, s: S) -> Self {
        s * self
    }
    #[inline]
    fn reciprocal(self) -> Self {
        S::lit(1.0) / self
    }
    #[inline]
    fn less_product(self, a: Self, b: Self) -> Self {
        (-a).mul_add(b, self)
    }
}

/// `re + i im`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<S> {
    /// Real part.
    pub re: S,
    /// Imaginary part.
    pub im: S,
}

/// A real number and a complex one that have nothing to do with each other: two systems of the same pattern, solved side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Both<S> {
    /// That of the first system.
    pub real: S,
    /// That of the second.
    pub complex: Complex<S>,
}

impl<S: Real> Both<S> {
    /// `f` of each.
    #[inline]
    fn join(
        self,
        other: Self,
        real: fn(S, S) -> S,
        complex: fn(Complex<S>, Complex<S>) -> Complex<S>,
    ) -> Self {
        Self { real: real(self.real, other.real), complex: complex(self.complex, other.complex) }
    }
}

impl<S: Real> Add for Both<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.join(other, S::add, Complex::add)
    }
}

impl<S: Real> Sub for Both<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.join(other, S::sub, Complex::sub)
    }
}

impl<S: Real> Mul for Both<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.join(other, S::mul, Complex::mul)
    }
}

impl<S: Real> Entry<S> for Both<S> {
    #[inline]
    fn real(s: S) -> Self {
        Self { real: s, complex: Complex::real(s) }
    }
    #[inline]
    fn size(self) -> S {
        self.real.abs().max(self.complex.size())
    }
    #[inline]
    fn times(self, s: S) -> Self {
        Self { real: s * self.real, complex: self.complex.times(s) }
    }
    #[inline]
    fn reciprocal(self) -> Self {
        Self { real: self.real.reciprocal(), complex: self.complex.reciprocal() }
    }
    #[inline]
    fn less_product(self, a: Self, b: Self) -> Self {
        Self {
            real: self.real.less_product(a.real, b.real),
            complex: self.complex.less_product(a.complex, b.complex),
        }
    }
}

impl<S: Real> Add for Complex<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<S: Real> Sub for Complex<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<S: Real> Mul for Complex<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl<S: Real> Entry<S> for Complex<S> {
    #[inline]
    fn real(s: S) -> Self {
        Self { re: s, im: S::ZERO }
    }
    #[inline]
    fn size(self) -> S {
        self.re.abs() + self.im.abs()
    }
    #[inline]
    fn times(self, s: S) -> Self {
        Self { re: s * self.re, im: s * self.im }
    }
    #[inline]
    fn reciprocal(self) -> Self {
        // Scaled, so that squares neither overflow nor vanish.
        let scale = S::lit(1.0) / self.size();
        let (re, im) = (self.re * scale, self.im * scale);
        let factor = scale / (re * re + im * im);
        Self { re: re * factor, im: -(im * factor) }
    }
    #[inline]
    fn less_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}
