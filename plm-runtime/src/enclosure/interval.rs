//! Arithmetic of intervals: the range of every operation over the ranges of its operands (R. E. Moore, R. B. Kearfott,
//! M. J. Cloud, Introduction to Interval Analysis, SIAM 2009, chapters 2 and 5).

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::scalar::Real;

/// All numbers from `low` to `high`; infinite bounds are unknown ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<S> {
    /// Lower bound.
    pub low: S,
    /// Upper bound.
    pub high: S,
}

impl<S: Real> Interval<S> {
    /// Numbers between two, in either order; all numbers if one of them is NaN.
    #[inline]
    pub fn between(a: S, b: S) -> Self {
        if a <= b {
            Self { low: a, high: b }
        } else if b < a {
            Self { low: b, high: a }
        } else {
            Self::everything()
        }
    }

    /// One number.
    #[inline]
    pub fn point(s: S) -> Self {
        Self::between(s, s)
    }

    /// All numbers.
    #[inline]
    pub fn everything() -> Self {
        Self { low: -S::INFINITY, high: S::INFINITY }
    }

    /// Smallest interval that contains both.
    #[inline]
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Largest absolute value.
    #[inline]
    pub fn size(self) -> S {
        self.low.abs().max(self.high.abs())
    }

    /// True if the number is between the bounds.
    #[inline]
    pub fn contains(self, s: S) -> bool {
        self.low <= s && s <= self.high
    }

    /// True if both bounds are finite.
    #[inline]
    pub fn is_bounded(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// True if the only number is zero.
    #[inline]
    fn vanishes(self) -> bool {
        self.low == S::ZERO && self.high == S::ZERO
    }

    /// Interval widened by the rounding of one operation; a bound that is NaN becomes infinite.
    #[inline]
    pub(super) fn outward(low: S, high: S) -> Self {
        let (below, above) = (low - S::EPSILON * low.abs(), high + S::EPSILON * high.abs());
        Self {
            low: if below >= -S::INFINITY { below } else { -S::INFINITY },
            high: if above <= S::INFINITY { above } else { S::INFINITY },
        }
    }

    /// Range of `f` over an interval on which it grows.
    #[inline]
    pub(super) fn growing(self, f: impl Fn(S) -> S) -> Self {
        Self::outward(f(self.low), f(self.high))
    }

    /// Range of the squares.
    #[inline]
    #[must_use]
    pub(super) fn square(self) -> Self {
        let low = if self.contains(S::ZERO) { S::ZERO } else { self.low.abs().min(self.high.abs()) };
        let high = self.size();
        Self::outward(low * low, high * high)
    }

    /// Range of the integer powers.
    #[must_use]
    pub(super) fn powi(self, n: i32) -> Self {
        if n < 0 {
            return Self::point(S::lit(1.0)) / self.powi(n.saturating_neg());
        }
        let (low, high) = (self.low.powi(n), self.high.powi(n));
        if n % 2 == 1 {
            return Self::outward(low, high);
        }
        let least = if n > 0 && self.contains(S::ZERO) { S::ZERO } else { low.min(high) };
        Self::outward(least, low.max(high))
    }

    /// Range of the square roots of the numbers that are not negative; all numbers if there are none.
    #[inline]
    #[must_use]
    pub(super) fn sqrt(self) -> Self {
        if self.high < S::ZERO {
            return Self::everything();
        }
        Self { low: self.low.max(S::ZERO), high: self.high }.growing(S::sqrt)
    }

    /// Range of the absolute values.
    #[inline]
    #[must_use]
    pub(super) fn abs(self) -> Self {
        if S::ZERO <= self.low {
            self
        } else if self.high <= S::ZERO {
            -self
        } else {
            Self { low: S::ZERO, high: self.size() }
        }
    }

    /// Range of the sines, from the sines at both bounds and the crests and troughs between them.
    pub(super) fn sin_with(self, at_low: S, at_high: S, quarter: f64) -> Self {
        let one = S::lit(1.0);
        let turns = |angle: S, from: f64| {
            (angle - S::lit((from - quarter) * core::f64::consts::FRAC_PI_2))
                * S::lit(0.5 * core::f64::consts::FRAC_1_PI)
        };
        // A bound next to a crest counts as beyond it: the range is then too wide by rounding only.
        let slack = S::lit(4.0) * S::EPSILON * (one + self.size());
        let passes =
            |from: f64| (turns(self.high, from) + slack).floor() > (turns(self.low, from) - slack).floor();
        let mut range = Self::outward(at_low.min(at_high), at_low.max(at_high));
        if passes(1.0) {
            range.high = one;
        }
        if passes(3.0) {
            range.low = -one;
        }
        Self { low: range.low.max(-one), high: range.high.min(one) }
    }
}

impl<S: Real> Neg for Interval<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl<S: Real> Add for Interval<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl<S: Real> Sub for Interval<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl<S: Real> Mul for Interval<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        // Bounds stand for finite numbers: zero times an unknown number is zero.
        if self.vanishes() || other.vanishes() {
            return Self { low: S::ZERO, high: S::ZERO };
        }
        let product = |a: S, b: S| if a == S::ZERO || b == S::ZERO { S::ZERO } else { a * b };
        let (a, b) = (product(self.low, other.low), product(self.low, other.high));
        let (c, d) = (product(self.high, other.low), product(self.high, other.high));
        Self::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl<S: Real> Div for Interval<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let one = S::lit(1.0);
        if other.low > S::ZERO || other.high < S::ZERO {
            return self * Self::outward(one / other.high, one / other.low);
        }
        // Next to a pole on one side only the other bound is known.
        let reciprocal = if other.low == S::ZERO && other.high > S::ZERO {
            Self { low: one / other.high, high: S::INFINITY }
        } else if other.high == S::ZERO && other.low < S::ZERO {
            Self { low: -S::INFINITY, high: one / other.low }
        } else {
            Self::everything()
        };
        self * reciprocal
    }
}
