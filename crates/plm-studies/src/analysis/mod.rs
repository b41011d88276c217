//! A mechanism near a state: linearised ([`linearise()`]), controlled ([`control`]), at an equilibrium ([`stabilise()`]), run by a method that is chosen by
//! eigenvalues ([`Auto`]).
//!
//! `plm` has all of it at its top, behind the feature `analysis`.

mod auto;
pub mod control;
mod linearise;
mod shapes;
mod stabilise;

pub use auto::{Auto, Choice, Pace, StartAuto};
#[doc(hidden)]
pub use linearise::{Derivatives, derivatives};
pub use linearise::{Linearisable, Linearisation, Mode, linearise};
#[doc(hidden)]
pub use nalgebra::DMatrix;
pub use shapes::Shape;
pub use stabilise::{
    Change, Equilibrium, Freedom, Residual, Stabilise, Support, Unbalanced, What, stabilise,
};
