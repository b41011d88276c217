//! Near-singular poses: how a mechanism goes on if its own coordinates are not regular.
//!
//! If every chart of a mechanism is poor, the constraints alone determine how it moves. It goes on in absolute coordinates, with every
//! state projected onto the constraints before its rate is computed, in double-double numbers (`equations`): the rate is then a smooth
//! function of the state however near a singular pose is.
//!
//! The distance to it follows from the smallest pivot of `phi_q M^-1 phi_q^T`. Along the motion that is `c + k (s - s0)^2` (`distance`):
//!
//! * Away from zero, the pose is passed by: steps follow the turn, which takes place over a length of `sqrt(c / k)`.
//! * Where `c` vanishes, the rank of `phi_q` does too (A. Mueller, Higher derivatives of the kinematic mapping and some
//!   applications, Mech. Mach. Theory 76, 2014, on the branches that meet there). The motion through it is analytic; a step by
//!   collocation leads over the pose, with nodes on both sides of it (`crossing`).
//!
//! The lengths decide if `c` vanishes (`critical`): the singular pose is the critical point of a combination of constraints, and its value
//! there the difference of lengths by which it is missed. Within their rounding the joints are closed to the pose (`meeting`); else it is
//! passed by. If a row prescribes a motion, that value changes with the time, and at its zero the motion ends (`lock`). If no such pose is
//! found, the gap that the polynomial of a step over it leaves in the joints decides.

mod collocation;
mod combined;
mod conditioning;
mod contract;
mod coordinates;
mod critical;
mod crossing;
mod distance;
mod equations;
mod here;
mod lock;
mod meeting;
mod near_singular;
mod never;
mod start;

pub use self::contract::{Coordinates, ExtendedPrecision};
pub use self::coordinates::{ByMechanism, InAbsolute, InCharts};
pub use self::near_singular::NearSingular;
pub use self::never::Never;
pub use self::start::refine;

pub use crate::protocol::{Nearness, Rescue};
use crate::scalar::Real;

/// The largest number of a vector over its typical size.
fn size<S: Real, const N: usize>(numbers: &[S; N], typical: impl Fn(usize) -> S) -> S {
    let mut largest = S::ZERO;
    for (i, number) in numbers.iter().enumerate() {
        largest = largest.max((*number / typical(i)).abs());
    }
    largest
}
