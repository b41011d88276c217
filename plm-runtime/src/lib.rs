//! Runtime of the programs that `plm` generates: contracts, integrators, assembly, small linear algebra.
//!
//! Nothing here allocates, prints, reads a clock or panics; sizes are constants of the types. Generated code
//! implements [`System`] (and [`Absolute`] where it works with absolute coordinates and multipliers), users hold a
//! [`Sim`].
//!
//! | module | content |
//! |---|---|
//! | [`scalar`], [`vector`] | numbers (`f32`, `f64`, lanes of them) and fixed arrays of them |
//! | [`system`], [`mechanism`], [`start`] | what generated code provides |
//! | [`fault`] | errors as values that name the time and the part |
//! | [`events`] | event detection, and events that reset the state |
//! | [`contact`] | friction and unilateral contact: modes, impacts, the next modes |
//! | [`method`] | explicit, symplectic and stiff one-step methods |
//! | [`protocol`] | one step: proposed, judged, committed |
//! | [`sim`] | a running simulation |
//! | [`step`] | a step of fixed length by itself |
//! | [`held`] | discrete state: constant during a step |
//! | [`charts`] | loops in closed form: mirror images, and changes of coordinates |
//! | [`singular`] | near-singular poses: absolute coordinates in double-double numbers |
//! | [`absolute`] | assembly, projection, accelerations by rank for constrained absolute coordinates |
//! | [`limits`] | allowed values of parameters |
//! | [`ports`] | inputs and outputs by number |
//! | [`described`] | bodies, parts, parameters and observed quantities, by number |
//! | [`lanes`] | several trajectories side by side |
//! | [`dual`], [`linear`] | derivatives by dual numbers |
//! | [`inverse`] | inverse dynamics: the inputs that a motion needs |
//! | [`linearised`] | a mechanism near a moment as a linear system |
//! | [`enclosure`] | values and slopes enclosed over an interval of time |
//! | [`double_double`] | double-double numbers: twice the precision |
//! | [`statics`] | equations of static equilibrium |
//! | [`words`] | a run as 64-bit words, for files and other processes |
//! | [`workspace`] | how much of the stack a solution by rank takes, and may take |
//! | [`linalg`] | orthogonalisation of rows: rank, pseudo-inverse, null space; elimination |
//!
//! Symbols: q coordinates, v = q', a = v', phi(t, q) = 0 constraints, phi_q their Jacobian, phi_q v = nu,
//! phi_q a = gamma, M a + phi_q^T lambda = Q; the reaction of the joints is -phi_q^T lambda.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

pub mod absolute;
pub mod adjoint;
mod axes;
mod body;
mod catalogue;
pub mod charts;
#[doc(hidden)]
pub mod compact;
pub mod contact;
pub mod described;
pub mod double_double;
pub mod dual;
pub mod enclosure;
pub mod events;
pub mod fault;
#[doc(hidden)]
pub mod generated;
pub mod gradient;
pub mod held;
pub mod inverse;
pub mod lanes;
pub mod limits;
pub mod linalg;
pub mod linear;
pub mod linearised;
pub mod mechanism;
pub mod method;
mod observed;
pub mod one_sided;
pub mod ports;
pub mod protocol;
pub mod scalar;
pub mod sim;
pub mod singular;
pub mod start;
pub mod statics;
mod stats;
pub mod step;
pub mod switched;
pub mod system;
#[cfg(feature = "vary-tolerances")]
pub mod tolerances;
#[cfg(not(feature = "vary-tolerances"))]
mod tolerances;
pub mod trace;
pub mod turns;
pub mod vector;
pub mod words;
pub mod workspace;

pub use absolute::{Absolute, Assembly, Found};
pub use axes::{to_absolute, to_relative};
pub use body::{BodyMotion, BodyState};
pub use described::Described;
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use enclosure::{Enclosed, Interval};
pub use fault::{Cause, Fault, Names};
pub use gradient::{By, Jacobian, Unknown, with_derivatives, with_side, with_trace};
pub use held::Held;
pub use limits::{Least, Limit};
pub use linear::Linear;
#[doc(hidden)]
pub use mechanism::HasMasses;
pub use mechanism::{AsMoment, At, InPlace, Mechanism, Moment};
pub use method::{Adams, Dop853, Dopri5, Method, MoreauJean, Rk4, SemiImplicitEuler, Vern9};
pub use observed::{Common, Observed};
pub use one_sided::{OneSided, Side};
pub use plm_math::Operations;
pub use ports::Ports;
pub use scalar::{Real, Scalar};
pub use sim::{Notice, Reached, Seen, Sim, Snapshot};
pub use start::{BodyStart, Start, StartValues};
pub use statics::Statics;
pub use stats::Stats;
pub use switched::{Switched, Switches};
pub use system::{
    Constraints, Drift, Energy, Events, Health, LabelTable, Labels, PartNames, Rate, Step, System, Updated,
};
pub use trace::{Term, Trace, Traced};
pub use vector::Vector;
