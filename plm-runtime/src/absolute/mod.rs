//! Constrained absolute coordinates: q = (x, y, theta) of every centre of gravity, phi(t, q) = 0 for the joints.
//!
//! | function | does |
//! |---|---|
//! | [`assemble`] | finds a start position and velocity that the joints allow |
//! | [`assemble_held`] | as `assemble`, with the conditional constraints that are in force |
//! | [`renew`] | reassembles a running mechanism from its present pose, after a parameter was changed |
//! | [`jump`] | checks prescribed motions for jumps at boundaries of their conditions |
//! | [`check_carried`] | checks bodies without mass |
//! | [`project`] | projects a state that drifted back onto the constraints |
//! | [`accelerate`] | accelerations and multipliers by rank, where elimination without pivoting is unhealthy |

mod accelerate;
mod assemble;
mod assembly;
mod branch;
mod carry;
mod change_point;
mod contract;
mod damped;
mod disagree;
mod far;
mod held;
mod images;
mod independent;
mod jump;
mod lack;
mod nearest;
mod newton;
mod placed;
mod pose;
mod project;
mod redundancy;
mod renew;
mod scale;
mod search;

pub use accelerate::{Acceleration, accelerate};
pub use assemble::assemble;
pub use assembly::{Assembly, Far, Found, Status};
pub use branch::Branch;
pub use carry::check_carried;
use contract::fill;
pub use contract::{Absolute, Layout, join, phi_q_matrix, split};
pub(crate) use disagree::disagreement;
pub use held::{Conditional, assemble_held};
pub use jump::{Crossing, jump};
pub use nearest::flat_part;
pub(crate) use nearest::{close, lead, nearest, smallest_pivot};
pub use project::{balance, drift, opening, project, project_state, residuals};
pub(crate) use redundancy::beside;
pub(crate) use renew::allow;
pub use renew::renew;
