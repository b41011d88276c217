//! Numbers over an interval of time: the range of a guard anywhere in a step.
//!
//! Generated code is generic over its scalar, so that running it on an [`Enclosed`] encloses a guard between two times. The
//! range of the slope and the value in the middle give a second range, by the mean value theorem, which shrinks with the
//! square of the interval (R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis, SIAM 2009, 6.4):
//! bisection soon decides the sign of a guard.

mod interval;

use core::ops::{Add, Div, Mul, Neg, Sub};

pub use interval::Interval;

use crate::scalar::{Real, Scalar};

/// A moving number over an interval of its one variable.
#[derive(Clone, Copy, Debug)]
pub struct Enclosed<S> {
    /// Value in the middle of the interval.
    pub middle: S,
    /// Range of its values in the interval.
    pub value: Interval<S>,
    /// Range of its derivative in the interval.
    pub slope: Interval<S>,
}

/// Outcome of a comparison over an interval.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// True if it is satisfied in the middle.
    middle: bool,
    /// True if it may be satisfied somewhere.
    may: bool,
    /// True if it is satisfied everywhere.
    must: bool,
}

impl<S: Real> Enclosed<S> {
    /// A number that does not move.
    #[inline]
    pub fn constant(s: S) -> Self {
        Self { middle: s, value: Interval::point(s), slope: Interval::point(S::ZERO) }
    }

    /// Range of the number over an interval that reaches `radius` to both sides of its middle.
    #[inline]
    pub fn range(self, radius: S) -> Interval<S> {
        let away = radius * self.slope.size();
        let (low, high) = (self.middle - away, self.middle + away);
        // A bound that is NaN has no effect.
        Interval { low: low.max(self.value.low), high: high.min(self.value.high) }
    }

    /// Function of the number by the chain rule: its value in the middle, its range, and the range of its slope.
    #[inline]
    fn chain(self, middle: S, value: Interval<S>, slope: Interval<S>) -> Self {
        Self { middle, value, slope: slope * self.slope }
    }

    /// One of two numbers, if it is unknown which; the function is continuous where they meet.
    #[inline]
    fn either(self, other: Self, middle: S) -> Self {
        Self { middle, value: self.value.hull(other.value), slope: self.slope.hull(other.slope) }
    }
}

impl<S: Real> Add for Enclosed<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            middle: self.middle + other.middle,
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<S: Real> Sub for Enclosed<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            middle: self.middle - other.middle,
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<S: Real> Mul for Enclosed<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            middle: self.middle * other.middle,
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl<S: Real> Div for Enclosed<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            middle: self.middle / other.middle,
            value,
            slope: (self.slope - value * other.slope) / other.value,
        }
    }
}

impl<S: Real> Neg for Enclosed<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { middle: -self.middle, value: -self.value, slope: -self.slope }
    }
}

impl<S: Real> PartialEq for Enclosed<S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.middle == other.middle && self.value == other.value
    }
}

impl<S: Real> Scalar for Enclosed<S> {
    type Mask = Outcome;
    type Turns = i32;

    const ZERO: Self = {
        let nothing = Interval { low: S::ZERO, high: S::ZERO };
        Self { middle: S::ZERO, value: nothing, slope: nothing }
    };
    const HEALTHY: f64 = S::HEALTHY;
    const AGREEMENT: f64 = S::AGREEMENT;
    const PRECISION: f64 = S::PRECISION;
    const HAS_DERIVATIVES: bool = true;

    #[inline]
    fn lit(x: f64) -> Self {
        Self::constant(S::lit(x))
    }
    #[inline]
    fn of_turns(turns: i32) -> Self {
        Self::constant(S::of_turns(turns))
    }
    #[inline]
    fn to_turns(self) -> i32 {
        self.middle.to_turns()
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.middle.to_f64()
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.middle.is_finite() && self.value.is_bounded()
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let sum = self * a + b;
        Self { middle: self.middle.mul_add(a.middle, b.middle), ..sum }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.middle.sin_cos();
        let (sin_low, cos_low) = self.value.low.sin_cos();
        let (sin_high, cos_high) = self.value.high.sin_cos();
        let sines = self.value.sin_with(sin_low, sin_high, 0.0);
        let cosines = self.value.sin_with(cos_low, cos_high, 1.0);
        (self.chain(sin, sines, cosines), self.chain(cos, cosines, -sines))
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let both = angles.map(Self::sin_cos);
        (both.map(|(sin, _)| sin), both.map(|(_, cos)| cos))
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(self.middle.sqrt(), root, Interval::point(S::lit(0.5)) / root)
    }
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        let quotient = sin / cos;
        if cos.value.contains(S::ZERO) {
            return quotient;
        }
        let value = self.value.growing(S::tan);
        self.chain(self.middle.tan(), value, value.square() + Interval::point(S::lit(1.0)))
    }
    fn asin(self) -> Self {
        let value = within_one(self.value).growing(S::asin);
        self.chain(self.middle.asin(), value, reciprocal_half_chord(self.value))
    }
    fn acos(self) -> Self {
        let chords = within_one(self.value);
        let value = Interval::outward(chords.high.acos(), chords.low.acos());
        self.chain(self.middle.acos(), value, -reciprocal_half_chord(self.value))
    }
    fn atan2(self, x: Self) -> Self {
        let (b, a) = (self.value, x.value);
        let square = a.square() + b.square();
        let middle = self.middle.atan2(x.middle);
        let stands =
            |s: &Self| s.value.low == S::ZERO && s.value.high == S::ZERO && s.slope.size() == S::ZERO;
        // On the x axis, or at rest in the origin, the angle does not move.
        if stands(&self) && (stands(&x) || !a.contains(S::ZERO)) {
            return Self::constant(middle);
        }
        // The angle jumps by a revolution where it passes the negative x axis or the origin.
        let passes_axis = b.low < S::ZERO && b.high >= S::ZERO && a.low < S::ZERO;
        if passes_axis || b.contains(S::ZERO) && a.contains(S::ZERO) {
            let half = S::lit(core::f64::consts::PI);
            return Self { middle, value: Interval::outward(-half, half), slope: Interval::everything() };
        }
        // Seen from outside, a rectangle is widest between corners. Negative zero would be on the other side of the axis.
        let corner = |y: S, x: S| Interval::point((y + S::ZERO).atan2(x));
        let left = corner(b.low, a.low).hull(corner(b.high, a.low));
        let corners = left.hull(corner(b.low, a.high)).hull(corner(b.high, a.high));
        let slope = (a * self.slope - b * x.slope) / square;
        Self { middle, value: Interval::outward(corners.low, corners.high), slope }
    }
    fn exp(self) -> Self {
        let value = self.value.growing(S::exp);
        self.chain(self.middle.exp(), value, value)
    }
    fn ln(self) -> Self {
        let positive = Interval { low: self.value.low.max(S::ZERO), high: self.value.high };
        let value = positive.growing(S::ln);
        self.chain(self.middle.ln(), value, Interval::point(S::lit(1.0)) / positive)
    }
    fn abs(self) -> Self {
        if self.value.contains(S::ZERO) {
            let either = self.either(-self, self.middle.abs());
            return Self { value: self.value.abs(), ..either };
        }
        if self.value.low < S::ZERO { -self } else { self }
    }
    /// Its slope is unknown if it may jump.
    fn floor(self) -> Self {
        let value = Interval { low: self.value.low.floor(), high: self.value.high.floor() };
        let still = value.low == value.high;
        let slope = if still { Interval::point(S::ZERO) } else { Interval::everything() };
        Self { middle: self.middle.floor(), value, slope }
    }
    /// Returns itself: it contains zero, with its derivatives, wherever it is chosen as zero.
    #[inline]
    fn as_zero(self) -> Self {
        self
    }
    #[inline]
    fn lt(self, other: Self) -> Outcome {
        Outcome {
            middle: self.middle < other.middle,
            may: self.value.low < other.value.high,
            must: self.value.high < other.value.low,
        }
    }
    /// If both may be chosen the value may jump: its slope is unknown then.
    fn select(mask: Outcome, a: Self, b: Self) -> Self {
        if mask.must {
            return a;
        }
        if !mask.may {
            return b;
        }
        let value = a.value.hull(b.value);
        let middle = if mask.middle { a.middle } else { b.middle };
        let same = value.low == value.high;
        Self { middle, value, slope: if same { a.slope.hull(b.slope) } else { Interval::everything() } }
    }
    #[inline]
    fn any(mask: Outcome) -> bool {
        mask.may
    }
    #[inline]
    fn all(mask: Outcome) -> bool {
        mask.must
    }
    fn signum0(self) -> Self {
        let value = Interval { low: self.value.low.signum0(), high: self.value.high.signum0() };
        let still = value.low == value.high;
        let slope = if still { Interval::point(S::ZERO) } else { Interval::everything() };
        Self { middle: self.middle.signum0(), value, slope }
    }
    fn min(self, other: Self) -> Self {
        let outcome = self.lt(other);
        if outcome.must || !outcome.may {
            return if outcome.must { self } else { other };
        }
        let either = self.either(other, self.middle.min(other.middle));
        let high = self.value.high.min(other.value.high);
        Self { value: Interval { high, ..either.value }, ..either }
    }
    fn max(self, other: Self) -> Self {
        -((-self).min(-other))
    }
    fn powi(self, n: i32) -> Self {
        let slope = if n == 0 {
            Interval::point(S::ZERO)
        } else {
            Interval::point(S::lit(f64::from(n))) * self.value.powi(n.saturating_sub(1))
        };
        self.chain(self.middle.powi(n), self.value.powi(n), slope)
    }
}

/// Part of an interval in which a number is a sine.
fn within_one<S: Real>(x: Interval<S>) -> Interval<S> {
    let one = S::lit(1.0);
    Interval { low: x.low.max(-one).min(one), high: x.high.min(one).max(-one) }
}

/// 1 / sqrt(1 - x^2).
fn reciprocal_half_chord<S: Real>(x: Interval<S>) -> Interval<S> {
    let one = Interval::point(S::lit(1.0));
    one / (one - within_one(x).square()).sqrt()
}
