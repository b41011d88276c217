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
mod constants;
mod damped;
mod disagree;
mod far;
mod held;
mod independent;
mod jump;
mod lack;
mod nearest;
mod newton;
mod placed;
mod project;
mod redundancy;
mod renew;
mod scale;
mod search;

pub use accelerate::{Acceleration, accelerate};
pub use assemble::assemble;
pub use assembly::{Assembly, Found, Status};
pub use branch::Branch;
pub use carry::check_carried;
pub use constants::Constants;
pub(crate) use disagree::disagreement;
pub use far::Far;
pub use held::{Conditional, assemble_held};
pub use jump::{Crossing, jump};
pub use nearest::flat_part;
pub(crate) use nearest::{close, lead, nearest, smallest_pivot};
pub use project::{balance, drift, opening, project, project_state, residuals};
pub(crate) use redundancy::beside;
pub(crate) use renew::allow;
pub use renew::renew;

use crate::scalar::Real;
use crate::start::Start;
use crate::system::Health;
use crate::vector::Vector;

/// The constraints of a mechanism in absolute coordinates; implemented by generated code.
pub trait Absolute<S: Real, const NQ: usize, const NC: usize> {
    /// Names of rows and coordinates, and how many there are: at most `NC` and `NQ`. What stands after the last ones of them is zero.
    fn layout(&self) -> &'static Layout;

    /// Residuals of position, m or rad.
    fn phi(&self, t: S, q: &[S; NQ]) -> [S; NC];

    /// Residuals of velocity, phi_q v - nu, m/s or rad/s.
    fn phi_dot(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> [S; NC];

    /// The Jacobian of `phi`: gives `each` the entries that are not zero by structure, with row and column, row by row.
    fn phi_q(&self, t: S, q: &[S; NQ], each: &mut impl FnMut(usize, usize, S));

    /// dq = W phi_q^T (phi_q W phi_q^T)^-1 r with W = diag(w), w >= 0: of all dq with phi_q dq = r the one that is
    /// smallest in the metric W^-1. Straight-line code without pivoting; it says how healthy that was.
    fn min_norm(&self, t: S, q: &[S; NQ], w: &[S; NQ], r: &[S; NC], dq: &mut [S; NQ]) -> Health<S>;

    /// Inverses of the masses and moments of inertia, 1/kg and 1/(kg m^2).
    fn inverse_mass(&self) -> [S; NQ];

    /// Start position of the centres of gravity, m and rad, with its locks.
    fn start_position(&self) -> [Start<S>; NQ];

    /// Start velocity of the centres of gravity at the assembled position, m/s and rad/s, with its locks.
    fn start_velocity(&self, q: &[S; NQ]) -> [Start<S>; NQ];

    /// Size of the mechanism, m.
    fn length(&self) -> S;

    /// An assembled pose that is so near to a singular one that rounding would decide how the mechanism starts: closed in numbers
    /// of twice the precision, with its start velocity.
    fn refine(&self, t: S, q: &[S; NQ]) -> Option<([S; NQ], [S; NQ])> {
        let _ = (t, q);
        None
    }

    /// The mirror images that joints ask for, from 0; after the last one there is none.
    fn branch(&self, index: usize) -> Option<Branch<S>> {
        let _ = index;
        None
    }
}

/// The rows and coordinates of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Name of each constraint row, as `shoulder.x`.
    pub rows: &'static [&'static str],
    /// Name of the part that each constraint row belongs to, as `shoulder`.
    pub parts: &'static [&'static str],
    /// Name of each coordinate, as `arm.x`, `arm.angle`.
    pub coordinates: &'static [&'static str],
    /// Which constraint rows are in rad; the others are in m.
    pub angular: &'static [bool],
    /// Of each body, whether the declaration gives its start angle; after the last one it does not. Assembly doubts a pose by angles
    /// that were given: by these, and by those that are no longer zero.
    pub given_angles: &'static [bool],
}

impl Layout {
    /// The part that a row belongs to; empty where there is no such row.
    pub(crate) fn part(&self, row: usize) -> &'static str {
        self.parts.get(row).copied().unwrap_or_default()
    }

    /// Is a row in rad?
    pub(crate) fn is_angular(&self, row: usize) -> bool {
        self.angular.get(row) == Some(&true)
    }
}

/// Puts the entries of phi_q into a matrix of zeros.
pub fn phi_q_matrix<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    q: &[S; NQ],
    matrix: &mut [[S; NQ]; NC],
) {
    fill(m, (t, q), &[S::lit(1.0); NQ], matrix);
}

/// Puts the entries of phi_q, times the weight of their column, into a matrix of zeros.
fn fill<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    (t, q): (S, &[S; NQ]),
    weights: &[S; NQ],
    matrix: &mut [[S; NQ]; NC],
) {
    m.phi_q(t, q, &mut |row, column, entry| {
        if let Some(row) = matrix.get_mut(row) {
            row.set(column, entry * weights.at(column));
        }
    });
}

/// Position and velocity of a state [q, v, first-order states].
pub fn split<S: Real, const NX: usize, const NQ: usize>(x: &[S; NX]) -> ([S; NQ], [S; NQ]) {
    (Vector::from_fn(|i| x.at(i)), Vector::from_fn(|i| x.at(NQ + i)))
}

/// Puts position and velocity into a state [q, v, first-order states].
pub fn join<S: Real, const NX: usize, const NQ: usize>(q: &[S; NQ], v: &[S; NQ], x: &mut [S; NX]) {
    for i in 0..NQ {
        x.set(i, q[i]);
        x.set(NQ + i, v[i]);
    }
}
