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
//!
//! # What to read first
//!
//! 1. [`mechanism!`] lists what a declaration may hold. Each mechanism is a type with a module of its own, whose documentation has the
//!    table of its equations: `cargo doc` shows it beside the other items of your crate.
//! 2. [`Start`] assembles a mechanism: it closes the joints from the start values and gives a simulation. [`BodyStart`] says where a
//!    body begins and what assembly must keep.
//! 3. [`Sim`] is a running simulation: it steps, runs to a time, samples, saves and resumes.
//! 4. [`Dop853`] is the method of integration that `start` takes. `start_with` takes another: [`Dopri5`], [`Vern9`], [`Adams`] and
//!    [`RadauIia5`] control their error; [`Rk4`], [`SemiImplicitEuler`], [`MoreauJean`], [`Gauss`] and [`Ros34Pw2`] have fixed steps.
//! 5. [`Fault`] says when, where and why a run ended, and [`Notice`] what is doubtful about one that did not.
//! 6. [`Described`] tells of a mechanism by number: bodies, joints, parameters with their units, and every quantity that can be
//!    observed. Recorders, C, FMUs and Python are written with it.
//!
//! The book has the whole language, each part with its equations, recipes, and a page for each diagnostic. It stands beside the sources,
//! in `docs/`: `mdbook serve docs --open` shows it.
//!
//! # Features
//!
//! | feature | what it adds |
//! |---|---|
//! | `std` | on unless switched off: square roots by the processor, room for 256 guards of conditions and contact in the place of 64, [`read_starts`], [`live`]; the bits of results are the same without |
//! | `analysis` | [`linearise`], [`stabilise`], and [`StartAuto`], which chooses a method by eigenvalues |
//! | `c-source` | `view::c_source`: C99 of a mechanism for compilers of any target; `--c-source FOLDER` of programs |
//! | `dynamic` | [`dynamic`]: mechanisms from text, run without rustc |
//! | `jit` | [`jit`]: machine code of the host for them (unsafe code, in `plm-jit`) |
//! | `optimise` | [`optimise`]: parameters and start values from measurements, inputs of least cost |
//! | `view` | [`view`]: results files, charts, drawings, whole programs with options, and a page that moves |
//! | `foreign` | [`foreign`]: objects for C and C++; with `analysis` also [`python`] |
//! | `fmi` | FMUs of FMI 2.0 and 3.0 in [`foreign`] |
//! | `batch` | [`batch`] and [`study`]: runs over parameter values on all cores, studies on many machines |
//! | `synthesis` | [`synthesis`]: dimensions from what a mechanism has to do, questions of kinematics, balancing, tolerances |
//! | `lanes` | [`Batch`]: eight simulations side by side in vector registers |
//! | `processor-sqrt-f32` | without std: square roots of `f32` by an instruction of the processor (unsafe code, in `plm-processor`) |
//! | `processor-sqrt-f64` | the same for `f64` too |
//! | `fma` | fused multiply-add: faster, and the one feature for use that changes bits; it needs a `target-cpu` that has the instruction |
//!
//! # Targets
//!
//! Generated code and runtime need no std and no allocator:
//!
//! ```toml
//! [dependencies]
//! plm-planar = { version = "0.1.0", default-features = false }
//! ```
// Without a feature its items are not there to be linked to.
#![cfg_attr(
    not(all(
        feature = "analysis",
        feature = "batch",
        feature = "dynamic",
        feature = "foreign",
        feature = "jit",
        feature = "lanes",
        feature = "synthesis",
        feature = "optimise",
        feature = "view"
    )),
    allow(rustdoc::broken_intra_doc_links, reason = "the table of features")
)]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

// Emitted paths begin with `::plm`, in this package's own tests too.
extern crate self as plm;
#[cfg(feature = "std")]
extern crate std;

pub use plm_macros::{mechanism, parts};
#[doc(no_inline)]
pub use plm_runtime as runtime;
#[doc(inline)]
pub use plm_runtime::adjoint;
/// Inverse dynamics: the inputs that a motion needs.
#[doc(inline)]
pub use plm_runtime::inverse;
pub use plm_runtime::method::{Gauss, RadauIia5, Ros34Pw2};
pub use plm_runtime::{
    Adams, BodyMotion, BodyStart, BodyState, By, Cause, Constraints, Described, Dop853, Dopri5, Dual, Events,
    Fault, Found, Labels, Mechanism, Method, Moment, MoreauJean, Names, Notice, Observed, OneSided,
    Operations, Rate, Reached, Real, Rk4, Scalar, SemiImplicitEuler, Side, Sim, Snapshot, Start, Stats,
    System, Term, Trace, Traced, Vern9, to_absolute, to_relative, with_derivatives, with_side, with_trace,
};
#[cfg(doctest)]
mod book;
#[cfg(feature = "std")]
pub mod live;
#[cfg(feature = "std")]
mod starts;

/// Mechanisms at run time: a declaration from text runs without rustc.
#[cfg(feature = "dynamic")]
#[doc(inline)]
pub use plm_dynamic as dynamic;
/// Machine code of the host for mechanisms from text.
#[cfg(feature = "jit")]
#[doc(inline)]
pub use plm_jit as jit;
#[cfg(feature = "analysis")]
pub use plm_studies::analysis::{
    Auto, Change, Choice, Equilibrium, Freedom, Linearisable, Linearisation, Mode, Pace, Residual, Shape,
    Stabilise, StartAuto, Support, Unbalanced, What, control, linearise, stabilise,
};
#[cfg(feature = "lanes")]
pub use plm_studies::lanes::{Batch, F64x8};
/// Parameters, starts and inputs from measurements, or for the least cost.
#[cfg(feature = "optimise")]
#[doc(inline)]
pub use plm_studies::optimise;
/// Dimensions of mechanisms from what they have to do, questions of kinematics, balancing, tolerances.
#[cfg(feature = "synthesis")]
#[doc(inline)]
pub use plm_studies::synthesis;
#[cfg(feature = "batch")]
pub use plm_studies::{batch, study};
#[cfg(feature = "std")]
pub use starts::{BadStarts, StartProblem, read_starts};

/// Results: recordings of runs, files, charts; what records a mechanism, and whole programs over one.
#[cfg(feature = "view")]
#[doc(inline)]
pub use plm_program as view;

/// Runs for a Python package: numbers of a mechanism by index, a method by its name, and interruption during a run.
#[cfg(all(feature = "foreign", feature = "analysis"))]
pub use plm_python::run as python;

/// For C and other languages: objects in memory of the caller, numbers by kind and index, errors as codes with a text.
#[cfg(feature = "foreign")]
#[doc(inline)]
pub use plm_foreign as foreign;
