//! Tolerances of charts and of the near-singular method, with the unit of each and its derivation.
//!
//! The book's chapter on near-singular poses (`docs/src/theory/near-singular.md`) shows the effect of each tolerance on a sweep if it
//! is tenfold or a tenth. With the feature `vary-tolerances`, which only that sweep enables, each number is multiplied by a factor
//! from `set_factor` or the environment; without it each is the constant in this folder.
//!
//! Units: rad; m; a pivot ratio (the smallest pivot of `phi_q W phi_q^T` over its diagonal entry, about the square of the sine of the
//! angle that a loop is away from flat); a measure (that sine itself); units in the last place (of 1: the number's `EPSILON`).

mod bounds;
mod charts;
mod closing;
mod singular;
#[cfg(feature = "vary-tolerances")]
mod vary;

pub(crate) use self::bounds::*;
pub(crate) use self::charts::*;
pub(crate) use self::closing::*;
pub(crate) use self::singular::*;
#[cfg(feature = "vary-tolerances")]
pub use self::vary::{names, set_factor};

use crate::scalar::{Real, Scalar};

/// A tolerance: one number, or several.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance<V = f64> {
    value: V,
    /// Access to the factor of the tolerance.
    #[cfg(feature = "vary-tolerances")]
    factor: fn() -> &'static vary::Factor,
}

/// One number for `f64`, another one for `f32`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ByPrecision {
    double: f64,
    single: f64,
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
        use super::Tolerance;
        #[cfg(feature = "vary-tolerances")]
        use super::vary;

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
            $(pub(super) static $name: super::vary::Factor = super::vary::Factor::new(stringify!($name));)*
        }

        /// Factors of all tolerances of this file.
        #[cfg(feature = "vary-tolerances")]
        pub(super) const FACTORS: &[fn() -> &'static vary::Factor] = &[$(|| &factors::$name),*];
    };
}
use tolerances;
