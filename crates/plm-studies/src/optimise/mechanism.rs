//! Contract of a mechanism whose runs have derivatives, and the methods that they are run by.

use plm_runtime::method::RadauIia5;
use plm_runtime::{Described, Dop853, Dual, Linear, Method, Statics};

/// Directions in which one run on dual numbers differentiates.
pub(crate) const LANES: usize = 4;

/// A number with its derivatives in the directions of one run.
pub(crate) type Number = Dual<f64, LANES>;

/// The mechanism in numbers with derivatives.
pub(crate) type Lifted<M> = <M as Linear>::Lifted<LANES>;

/// A mechanism whose runs can be derived: generated ones are, and those from text.
pub trait Optimisable:
    Described<S = f64, U: Send + Sync, X: Send + Sync>
    + Statics
    + Linear<S = f64, Lifted<LANES>: Described + Statics>
    + Send
    + Sync
{
}

impl<M> Optimisable for M where
    M: Described<S = f64, U: Send + Sync, X: Send + Sync>
        + Statics
        + Linear<S = f64, Lifted<LANES>: Described + Statics>
        + Send
        + Sync
{
}

/// A method of integration for runs in numbers and in numbers with derivatives.
pub trait Integration<M: Optimisable>: Copy + Send + Sync {
    /// The method on numbers.
    type Plain: Method<M>;
    /// The method on numbers with derivatives.
    type Derived: Method<M::Lifted<LANES>>;

    /// Gives the method on numbers.
    fn plain(&self) -> Self::Plain;

    /// Gives the method on numbers with derivatives.
    fn derived(&self) -> Self::Derived;
}

/// Runs by Dormand and Prince of order 8, with this relative tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByDop853(pub f64);

impl Default for ByDop853 {
    /// With the tolerance 1e-10.
    fn default() -> Self {
        Self(1e-10)
    }
}

impl<M: Optimisable> Integration<M> for ByDop853 {
    type Plain = Dop853<M>;
    type Derived = Dop853<Lifted<M>>;

    fn plain(&self) -> Self::Plain {
        Dop853::new(self.0)
    }

    fn derived(&self) -> Self::Derived {
        Dop853::new(self.0.into())
    }
}

/// Runs by Radau IIA of order 5, with this relative tolerance: for stiff mechanisms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByRadau(pub f64);

impl<M: Optimisable> Integration<M> for ByRadau
where
    RadauIia5<M>: Method<M>,
    RadauIia5<Lifted<M>>: Method<Lifted<M>>,
{
    type Plain = RadauIia5<M>;
    type Derived = RadauIia5<Lifted<M>>;

    fn plain(&self) -> Self::Plain {
        RadauIia5::new(self.0)
    }

    fn derived(&self) -> Self::Derived {
        RadauIia5::new(self.0.into())
    }
}
