//! A number and its place in a trace.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Trace;
use crate::scalar::Real;

/// A number whose operations are recorded.
///
/// Whatever decides decides by the value, as that of [`Dual`](crate::Dual) does, so that values have the bits of the scalar alone.
#[derive(Clone, Copy)]
pub struct Traced<'t, S = f64> {
    /// The number.
    pub value: S,
    place: u64,
    /// None for a constant.
    trace: Option<&'t Trace<'t, S>>,
}

impl<'t, S: Real> Traced<'t, S> {
    /// A number that does not depend on anything.
    #[inline]
    pub const fn constant(value: S) -> Self {
        Self { value, place: 0, trace: None }
    }

    /// The number at a place of a trace.
    #[inline]
    pub(super) const fn at(value: S, place: u64, trace: &'t Trace<'t, S>) -> Self {
        Self { value, place, trace: Some(trace) }
    }

    /// Its place in the trace; none for a constant.
    #[inline]
    pub(crate) fn place(self) -> Option<u64> {
        self.trace.map(|_| self.place)
    }

    /// Its trace; none for a constant.
    #[inline]
    pub(super) fn trace(self) -> Option<&'t Trace<'t, S>> {
        self.trace
    }

    /// A number with this dependence and another value.
    #[inline]
    pub(super) fn with_value(self, value: S) -> Self {
        Self { value, ..self }
    }

    /// A function of the number: its value and its derivative.
    #[inline]
    pub(super) fn chain(self, value: S, slope: S) -> Self {
        match self.trace {
            None => Self::constant(value),
            Some(trace) => Self::at(value, trace.push([(self.place, slope)]), trace),
        }
    }

    /// A function of two numbers: its value and its derivatives by both.
    #[inline]
    pub(super) fn join(self, other: Self, value: S, by: impl FnOnce() -> [S; 2]) -> Self {
        match (self.trace, other.trace) {
            (None, None) => Self::constant(value),
            (Some(trace), None) => Self::at(value, trace.push([(self.place, by()[0])]), trace),
            (None, Some(trace)) => Self::at(value, trace.push([(other.place, by()[1])]), trace),
            (Some(trace), Some(_)) => {
                let [a, b] = by();
                Self::at(value, trace.push([(self.place, a), (other.place, b)]), trace)
            }
        }
    }

    /// `self * a + b`.
    #[inline]
    pub(super) fn add_product(self, a: Self, b: Self) -> Self {
        let value = self.value.mul_add(a.value, b.value);
        let (x, y) = (self.place, a.place);
        let one = S::lit(1.0);
        let Some(trace) = b.trace else {
            return self.join(a, value, || [a.value, self.value]);
        };
        let place = match (self.trace, a.trace) {
            (None, None) => trace.push([(b.place, one)]),
            (Some(_), None) => trace.push([(x, a.value), (b.place, one)]),
            (None, Some(_)) => trace.push([(y, self.value), (b.place, one)]),
            (Some(_), Some(_)) => trace.push([(x, a.value), (y, self.value), (b.place, one)]),
        };
        Self::at(value, place, trace)
    }
}

impl<S: fmt::Debug> fmt::Debug for Traced<'_, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

/// A number that does not depend on anything.
impl<S: Real> From<S> for Traced<'_, S> {
    #[inline]
    fn from(value: S) -> Self {
        Self::constant(value)
    }
}

impl<S: Real> Add for Traced<'_, S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.join(other, self.value + other.value, || [S::lit(1.0); 2])
    }
}

impl<S: Real> Sub for Traced<'_, S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.join(other, self.value - other.value, || [S::lit(1.0), S::lit(-1.0)])
    }
}

impl<S: Real> Mul for Traced<'_, S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.join(other, self.value * other.value, || [other.value, self.value])
    }
}

impl<S: Real> Div for Traced<'_, S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.join(other, value, || [S::lit(1.0) / other.value, -value / other.value])
    }
}

impl<S: Real> Neg for Traced<'_, S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, S::lit(-1.0))
    }
}

impl<S: Real> PartialEq for Traced<'_, S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: Real> PartialOrd for Traced<'_, S> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}
