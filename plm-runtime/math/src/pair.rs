//! Unevaluated differences of two numbers, about twice as precise as one.
//!
//! Method: T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18,
//! 1971: the error of a sum and of a product are themselves floating-point numbers. The small part is subtracted, not
//! added, so that a zero keeps its sign: -0 - 0 is -0, whereas -0 + 0 is 0.

use core::ops::Neg;

use crate::float::Float;

/// The number `high - less`; `less` is of the size of a rounding error of `high`, or some bits larger.
#[derive(Clone, Copy)]
pub(crate) struct Pair<F> {
    pub(crate) high: F,
    pub(crate) less: F,
}

impl<F: Float> Neg for Pair<F> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Pair { high: -self.high, less: -self.less }
    }
}

impl<F: Float> Pair<F> {
    #[inline]
    pub(crate) fn value(self) -> F {
        self.high - self.less
    }

    /// Equal number with `high` its rounded value; needs |less| <= |high|.
    #[inline]
    pub(crate) fn rounded(self) -> Self {
        let high = self.value();
        Pair { high, less: (high - self.high) + self.less }
    }

    /// a + b, for |a| >= |b| or a = 0.
    #[inline]
    pub(crate) fn sum(a: F, b: F) -> Self {
        let high = a + b;
        Pair { high, less: (high - a) - b }
    }

    /// a b, unless a term overflows or underflows.
    #[inline]
    pub(crate) fn product(a: F, b: F) -> Self {
        let high = a * b;
        let (a_head, b_head) = (a.head(), b.head());
        let (a_tail, b_tail) = (a - a_head, b - b_head);
        Pair { high, less: ((high - a_head * b_head) - a_head * b_tail - a_tail * b_head) - a_tail * b_tail }
    }

    /// self / d, for pairs whose `high` are rounded values.
    #[inline]
    pub(crate) fn over(self, d: Self) -> Self {
        let high = self.high / d.high;
        let product = Pair::product(high, d.high);
        let excess = (product.high - self.high) - product.less;
        Pair { high, less: (excess + self.less - high * d.less) / d.high }
    }

    /// The rounded value of self + factor * small, for a factor that is a power of two, with
    /// |self| >= |factor * small| or self = 0.
    #[inline]
    pub(crate) fn plus(self, factor: F, small: Self) -> F {
        let sum = Pair::sum(self.high, factor * small.high);
        sum.high - (sum.less + (self.less + factor * small.less))
    }
}
