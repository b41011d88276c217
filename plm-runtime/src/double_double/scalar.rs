//! Double-double numbers as scalars of generated code and of methods.

use super::{DoubleDouble, functions};
use crate::scalar::{Real, Scalar};

/// Is `x` a whole multiple of 2^-16? Compilers know the answer for a constant, so that a half costs nothing.
#[inline]
fn is_dyadic(x: f64) -> bool {
    // Numbers from 2^52 on are whole; the half more keeps sums of both signs there.
    const WHOLE: f64 = 1.5 * (1_u64 << 52) as f64;
    let many = x * 65536.0;
    (many + WHOLE) - WHOLE == many
}

impl<S: Real> Scalar for DoubleDouble<S> {
    type Mask = bool;
    type Turns = i32;

    const ZERO: Self = Self::of(S::ZERO);
    /// Pivot ratios of rows that are redundant but for the rounding of the lengths in `S` are below: at the distance d from a flat pose the
    /// square of a unit in the last place over d. Lengths that differ by more than their rounding are above: by about their difference.
    const HEALTHY: f64 = S::HEALTHY * S::HEALTHY * 3e-5;
    const MOST_GROWTH: f64 = 1.0 / Self::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;

    /// The constant `x` [as it was written](DoubleDouble::written); with 48 of its 53 bits where the words are of `f32`.
    #[inline]
    fn lit(x: f64) -> Self {
        let high = S::lit(x);
        let low = x - high.to_f64();
        match () {
            () if low == 0.0 && is_dyadic(x) => Self::of(high),
            () if low == 0.0 => Self::written(high),
            () if high.is_finite() => Self { high, low: S::lit(low) },
            () => Self::of(high),
        }
    }
    #[inline]
    fn of_turns(turns: i32) -> Self {
        Self::lit(turns.into())
    }
    #[inline]
    fn to_turns(self) -> i32 {
        self.high.to_turns()
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.high.to_f64() + self.low.to_f64()
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.high.is_finite()
    }
    /// `self * a + b`, rounded twice with any feature.
    #[inline(never)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self.times(a).plus(b)
    }
    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        functions::sin_cos(self)
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let both = angles.map(Self::sin_cos);
        (both.map(|(sin, _)| sin), both.map(|(_, cos)| cos))
    }
    /// Square root; NaN below zero.
    #[inline(never)]
    fn sqrt(self) -> Self {
        functions::sqrt(self)
    }
    #[inline(never)]
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }
    #[inline(never)]
    fn asin(self) -> Self {
        self.atan2(functions::half_chord(self))
    }
    #[inline(never)]
    fn acos(self) -> Self {
        functions::half_chord(self).atan2(self)
    }
    #[inline(never)]
    fn atan2(self, x: Self) -> Self {
        functions::atan2(self, x)
    }
    #[inline(never)]
    fn exp(self) -> Self {
        functions::exp(self)
    }
    #[inline(never)]
    fn ln(self) -> Self {
        functions::ln(self)
    }
    #[inline]
    fn abs(self) -> Self {
        Self { high: self.high.abs(), low: if self.high < S::ZERO { -self.low } else { self.low } }
    }
    #[inline]
    fn lt(self, other: Self) -> bool {
        self < other
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
    #[inline(never)]
    fn floor(self) -> Self {
        let high = self.high.floor();
        // Only under a whole number does the low word decide.
        if high == self.high { Self::sum(high, self.low.floor()) } else { Self::of(high) }
    }
}

impl<S: Real> Real for DoubleDouble<S> {
    type Plain = DoubleDouble<S::Plain>;

    #[inline]
    fn plain(self) -> Self::Plain {
        DoubleDouble { high: self.high.plain(), low: self.low.plain() }
    }
    #[inline]
    fn of_plain(plain: Self::Plain) -> Self {
        Self { high: S::of_plain(plain.high), low: S::of_plain(plain.low) }
    }
    #[inline]
    fn with_plain(self, plain: Self::Plain) -> Self {
        Self { high: self.high.with_plain(plain.high), low: self.low.with_plain(plain.low) }
    }
    /// A unit of errors, not the distance to the next number: next to 1 that is far smaller.
    const EPSILON: Self = Self::of(S::DOUBLE_DOUBLE_EPSILON);
    /// Lengths are known as exactly as in `S`.
    const RANK_TOLERANCE: Self = Self::of(S::RANK_TOLERANCE);
    /// Two of these in one are no more precise than one: constants have two words.
    const DOUBLE_DOUBLE_EPSILON: Self = Self::EPSILON;
    const INFINITY: Self = Self::of(S::INFINITY);
}
