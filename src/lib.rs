//! Planar mechanisms, declared in Rust source and compiled to exact, allocation-free simulations.
//!
//! [`mechanism!`] parses bodies and joints, derives the equations of motion symbolically while rustc compiles, and emits
//! straight-line code for them; the runtime assembles the mechanism and steps it. Mistakes are reported by rustc at the
//! joint that makes them.
//!
//! ```
//! plm::mechanism! {
//!     /// A pendulum of 1 kg on a bar of 1 m.
//!     pub Pendulum {
//!         gravity: 9.81 m/s^2;
//!         ground { port o: (0, 0) m; }
//!         body bob {
//!             mass: 1 kg;
//!             inertia: 0.01 kg*m^2;
//!             port pivot: (0, 1) m;
//!             start angle: 30 deg, locked;
//!         }
//!         revolute hinge(ground.o, bob.pivot);
//!         output hinge.force;
//!     }
//! }
//!
//! fn main() -> Result<(), plm::Fault> {
//!     let mut sim = Pendulum::new().start()?;
//!     sim.step(0.5)?;
//!     let energy = sim.kinetic_energy() + sim.gravity_energy();
//!     assert!((energy + 9.81 * 30_f64.to_radians().cos()).abs() < 1e-6);
//!     Ok(())
//! }
//! ```
#![no_std]

// Emitted paths begin with `::plm`, in this package's own tests too.
extern crate self as plm;
#[cfg(feature = "std")]
extern crate std;

pub use plm_macros::{mechanism, parts};
#[doc(no_inline)]
pub use plm_runtime as runtime;
pub use plm_runtime::method::{Gauss, RadauIia5, Ros34Pw2};
pub use plm_runtime::{
    Adams, BodyMotion, BodyStart, BodyState, Cause, Constraints, Described, Dop853, Dopri5, Dual, Events,
    Fault, Found, Labels, Mechanism, Method, Moment, Names, Notice, Observed, Operations, Rate, Real, Rk4,
    Scalar, SemiImplicitEuler, Sim, Snapshot, Start, Stats, System, Vern9, to_absolute, to_relative,
};
#[cfg(doctest)]
mod book;
#[cfg(feature = "lanes")]
mod lanes;
#[cfg(feature = "std")]
pub mod live;
#[cfg(feature = "std")]
mod starts;

#[cfg(feature = "lanes")]
pub use lanes::{Batch, F64x8};
#[cfg(feature = "analysis")]
pub use plm_analysis::{
    Auto, Change, Choice, Equilibrium, Freedom, Linearisable, Linearisation, Mode, Pace, Residual, Stabilise,
    StartAuto, Unbalanced, What, linearise, stabilise,
};
#[cfg(feature = "batch")]
pub use plm_study::{batch, study};
#[cfg(feature = "std")]
pub use starts::{BadStarts, StartProblem, read_starts};

/// Results: recordings of runs, files, charts; what records a mechanism, and whole programs over one.
#[cfg(feature = "view")]
pub use plm_program as view;

/// What a package of Python has of a mechanism: a run by number, by a method that is named, which can be ended on its way.
#[cfg(all(feature = "foreign", feature = "analysis"))]
pub use plm_python::run as python;

/// For C and other languages: objects in memory of the caller, numbers by kind and index, errors as codes with a text.
#[cfg(feature = "foreign")]
pub use plm_foreign as foreign;
