//! Double-double arithmetic: a number as the unevaluated sum of two, some 31 digits.
//!
//! T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971); Y. Hida,
//! X. S. Li, D. H. Bailey, Library for double-double and quad-double arithmetic (2007). Without fused operations, so that
//! every host gives the same bits.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
use std::sync::LazyLock;

/// `hi + lo`, where `lo` is at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dd {
    pub hi: f64,
    pub lo: f64,
}

/// `1/(2k (2k + 1))` and `1/((2k + 1) (2k + 2))` of the terms of sine and cosine.
static INVERSES: LazyLock<[[Dd; 2]; 13]> = LazyLock::new(|| {
    std::array::from_fn(|k| {
        let k = 2.0 * (k as f64 + 1.0);
        [k * (k + 1.0), (k + 1.0) * (k + 2.0)].map(|product| Dd::ONE / Dd::from(product))
    })
});

/// The sum and what rounding took from it, if `a` is the larger.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// The two halves of 26 bits (Veltkamp).
#[inline]
fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

#[inline]
fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Dd {
    pub const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    pub const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    /// pi/2 in two numbers; what is left of it is below 1e-33.
    const HALF_PI: Self = Self { hi: std::f64::consts::FRAC_PI_2, lo: 6.123_233_995_736_766e-17 };

    #[inline]
    fn of_sum((s, e): (f64, f64)) -> Self {
        let (hi, lo) = quick_two_sum(s, e);
        Self { hi, lo }
    }

    /// Times a number.
    #[inline]
    pub fn times(self, factor: f64) -> Self {
        let (p, e) = two_prod(self.hi, factor);
        Self::of_sum((p, e + self.lo * factor))
    }

    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// Sine and cosine: quarter turns off, an eighth of what is left by its series, doubled three times.
    pub fn sin_cos(self) -> (Self, Self) {
        let quarters = (self.hi / Self::HALF_PI.hi).round();
        let rest = (self - Self::HALF_PI * Self::from(quarters)) * Self::from(0.125);
        let square = rest * rest;
        // 1 - cos is carried, so that doubling loses nothing where the angle is small.
        let (mut sine, mut versine) = (rest, square * Self::from(0.5));
        let (mut term_s, mut term_c) = (rest, versine);
        for [by_s, by_c] in *INVERSES {
            term_s = -term_s * square * by_s;
            term_c = -term_c * square * by_c;
            sine += term_s;
            versine += term_c;
        }
        for _ in 0..3 {
            let cosine = Self::ONE - versine;
            versine = sine * sine * Self::from(2.0);
            sine = sine * cosine * Self::from(2.0);
        }
        let cosine = Self::ONE - versine;
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }
}

impl From<f64> for Dd {
    #[inline]
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Dd {
    type Output = Self;

    #[inline]
    fn add(self, b: Self) -> Self {
        let (s, e) = two_sum(self.hi, b.hi);
        let (t, f) = two_sum(self.lo, b.lo);
        let (s, e) = quick_two_sum(s, e + t);
        Self::of_sum((s, e + f))
    }
}

impl Neg for Dd {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Dd {
    type Output = Self;

    #[inline]
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Dd {
    type Output = Self;

    #[inline]
    fn mul(self, b: Self) -> Self {
        let (p, e) = two_prod(self.hi, b.hi);
        Self::of_sum((p, e + (self.hi * b.lo + self.lo * b.hi)))
    }
}

impl Div for Dd {
    type Output = Self;

    fn div(self, b: Self) -> Self {
        let first = self.hi / b.hi;
        let rest = self - b * Self::from(first);
        let second = rest.hi / b.hi;
        let rest = rest - b * Self::from(second);
        Self::of_sum(quick_two_sum(first, second)) + Self::from(rest.hi / b.hi)
    }
}

impl AddAssign for Dd {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl SubAssign for Dd {
    #[inline]
    fn sub_assign(&mut self, b: Self) {
        *self = *self - b;
    }
}

/// A sum of products. What rounding takes from the sum of their larger parts is added up with the smaller parts, as they are: there
/// are as many digits as in additions of `Dd`, and no product waits for the end of the addition before it.
///
/// T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26 (2005), algorithm 5.3.
#[derive(Clone, Copy)]
pub struct Sum {
    large: f64,
    small: f64,
}

impl Sum {
    #[inline]
    pub fn from(start: Dd) -> Self {
        Self { large: start.hi, small: start.lo }
    }

    #[inline]
    #[must_use]
    pub fn plus(self, a: Dd, b: Dd) -> Self {
        let (product, e) = two_prod(a.hi, b.hi);
        let (large, f) = two_sum(self.large, product);
        Self { large, small: self.small + (f + (e + (a.hi * b.lo + a.lo * b.hi))) }
    }

    #[inline]
    pub fn value(self) -> Dd {
        Dd::of_sum(two_sum(self.large, self.small))
    }
}

/// `start` and the sum of products.
#[inline]
pub fn summed(start: Dd, products: impl Iterator<Item = (Dd, Dd)>) -> Dd {
    products.fold(Sum::from(start), |sum, (a, b)| sum.plus(a, b)).value()
}

/// Of order `k` in the product of two series.
#[inline]
pub fn convolved(a: &[Dd], b: &[Dd], k: usize) -> Dd {
    summed(Dd::ZERO, a[..=k].iter().copied().zip(b[..=k].iter().rev().copied()))
}

/// The sum of a series at `h`.
pub fn horner(series: &[Dd], h: Dd) -> Dd {
    series.iter().rev().fold(Dd::ZERO, |sum, coefficient| sum * h + *coefficient)
}

/// The rate of a series at `h`.
pub fn horner_rate(series: &[Dd], h: Dd) -> Dd {
    let mut sum = Dd::ZERO;
    for (k, coefficient) in series.iter().enumerate().skip(1).rev() {
        sum = sum * h + *coefficient * Dd::from(k as f64);
    }
    sum
}
