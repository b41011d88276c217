//! A tolerance: its number, or its numbers, and with the feature `vary-tolerances` a factor.

#[cfg(feature = "vary-tolerances")]
use super::factor::Factor;
use crate::scalar::{Real, Scalar};

/// A tolerance: one number, or several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<V = f64> {
    pub(super) value: V,
    /// Access to the factor of the tolerance.
    #[cfg(feature = "vary-tolerances")]
    pub(super) factor: fn() -> &'static Factor,
}

/// One number for `f64`, another one for `f32`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ByPrecision {
    pub(super) double: f64,
    pub(super) single: f64,
}

impl<V> Tolerance<V> {
    #[cfg(not(feature = "vary-tolerances"))]
    #[allow(clippy::unused_self, reason = "a factor has a name")]
    #[inline]
    fn times(&self, number: f64) -> f64 {
        number
    }

    #[cfg(feature = "vary-tolerances")]
    fn times(&self, number: f64) -> f64 {
        (self.factor)().get() * number
    }
}

impl Tolerance {
    /// The number.
    #[inline]
    pub(crate) fn get(self) -> f64 {
        self.times(self.value)
    }

    /// The number in a scalar type.
    #[inline]
    pub(crate) fn of<S: Scalar>(self) -> S {
        S::lit(self.get())
    }
}

impl<const N: usize> Tolerance<[f64; N]> {
    /// The numbers.
    #[inline]
    pub(crate) fn all(self) -> [f64; N] {
        self.value.map(|number| self.times(number))
    }
}

impl Tolerance<ByPrecision> {
    /// The number for a scalar type.
    #[inline]
    pub(crate) fn get<S: Real>(self) -> f64 {
        let ByPrecision { double, single } = self.value;
        self.times(if is_double::<S>() { double } else { single })
    }

    /// The number in a scalar type.
    #[inline]
    pub(crate) fn of<S: Real>(self) -> S {
        S::lit(self.get::<S>())
    }
}

/// True if the type has the precision of `f64` or more.
#[inline]
pub(crate) fn is_double<S: Real>() -> bool {
    S::EPSILON < S::lit(1e-12)
}

/// Declares tolerances as constants.
macro_rules! tolerances {
    ($($(#[$doc:meta])* $name:ident: $kind:ty = $value:expr;)*) => {
        #[cfg(feature = "vary-tolerances")]
        use super::factor::Factor;
        use super::tolerance::Tolerance;

        $(
            $(#[$doc])*
            pub(crate) const $name: Tolerance<$kind> = Tolerance {
                value: $value,
                #[cfg(feature = "vary-tolerances")]
                factor: || &factors::$name,
            };
        )*

        #[cfg(feature = "vary-tolerances")]
        mod factors {
            $(pub(super) static $name: super::Factor = super::Factor::new(stringify!($name));)*
        }

        /// Factors of all tolerances of this file.
        #[cfg(feature = "vary-tolerances")]
        pub(super) const FACTORS: &[fn() -> &'static Factor] = &[$(|| &factors::$name),*];
    };
}
pub(super) use tolerances;
