//! Which constraints and locks depend on each other.

use super::Absolute;
use super::newton::weighted_jacobian;
use crate::linalg::{dot, identity, largest, rotate};
use crate::scalar::Real;

/// Dependencies among the rows of [phi_q; E], where E holds a unit row for every locked coordinate.
///
/// A combination y of joint rows that vanishes in the free columns is balanced by the locks with z = -y^T phi_q: with
/// z = 0 the joints depend on each other, otherwise they tie the locks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dependencies<const NQ: usize, const NC: usize> {
    /// Rank of phi_q without the locked columns.
    pub(super) free_rank: usize,
    /// How many dependencies contain locks: so many locks are too many.
    pub(super) of_locks: usize,
    /// How many are among joints alone.
    pub(super) of_joints: usize,
    /// Locked coordinates in a dependency.
    pub(super) locks: [bool; NQ],
    /// Joint rows that tie locks.
    pub(super) ties: [bool; NC],
    /// Joint rows that depend on each other.
    pub(super) rows: [bool; NC],
}

impl<const NQ: usize, const NC: usize> Dependencies<NQ, NC> {
    /// All rows are independent.
    const fn none() -> Self {
        Self {
            free_rank: NC,
            of_locks: 0,
            of_joints: 0,
            locks: [false; NQ],
            ties: [false; NC],
            rows: [false; NC],
        }
    }

    /// At the position `q`, where a coordinate with `free` = 0 is locked and one with `free` = 1 is not.
    /// `None` if the Jacobian is not finite.
    pub(super) fn at<S: Real, M: Absolute<S, NQ, NC>>(
        m: &M,
        t: S,
        q: &[S; NQ],
        free: &[S; NQ],
    ) -> Option<Self> {
        let zero = S::lit(0.0);
        // Good pivots prove full rank at linear cost.
        if m.min_norm(t, q, free, &[zero; NC], &mut [zero; NQ]).is_good() {
            return Some(Self::none());
        }
        let rotated = rotate(weighted_jacobian(m, t, q, free), identity())?;
        let cut = rotated.cut(S::RANK_TOLERANCE);
        let locked = free.map(|free| S::lit(1.0) - free);
        let jacobian = weighted_jacobian(m, t, q, &locked);
        let size = largest(&rotated.sigma).max(largest(&jacobian.map(|row| dot(&row, &row).sqrt())));

        let (mut z, mut y) = ([[zero; NQ]; NC], [[zero; NC]; NC]);
        for (place, combination) in z.iter_mut().zip(&mut y).zip(rotated.null(cut)) {
            *place.1 = *combination;
            for (weight, row) in combination.iter().zip(&jacobian) {
                for (z, entry) in place.0.iter_mut().zip(row) {
                    *z = weight.mul_add(*entry, *z);
                }
            }
        }
        let tied = rotate(z, y)?;
        // Rows without a combination are zero: they count as ties of nothing, and carry no mark.
        let (least, free_rank) = (S::RANK_TOLERANCE * size, rotated.rank(cut));
        let of_locks = tied.rank(least);
        let mut found = Self {
            free_rank,
            of_locks,
            of_joints: NC.saturating_sub(free_rank + of_locks),
            locks: [false; NQ],
            ties: [false; NC],
            rows: [false; NC],
        };
        for (sigma, z, y) in tied.range(least) {
            mark(&mut found.locks, z, sigma);
            mark(&mut found.ties, y, S::lit(1.0));
        }
        for y in tied.null(least) {
            mark(&mut found.rows, y, S::lit(1.0));
        }
        Some(found)
    }
}

/// Marks where a vector of the given size is not zero.
fn mark<S: Real, const N: usize>(marks: &mut [bool; N], vector: &[S; N], size: S) {
    for (mark, entry) in marks.iter_mut().zip(vector) {
        *mark |= entry.abs() > S::RANK_TOLERANCE * size;
    }
}

/// A position beside `q` that no symmetry singles out: free coordinates moved by up to 0.1 (m, rad), by the fractions of
/// multiples of the golden ratio. The rank there is the highest that the equations can have, off phi = 0.
pub(super) fn beside<S: Real, const NQ: usize>(q: &[S; NQ], free: &[S; NQ]) -> [S; NQ] {
    let mut fraction = 0.0;
    core::array::from_fn(|i| {
        fraction += 0.618_033_988_749_894_9;
        if fraction >= 1.0 {
            fraction -= 1.0;
        }
        q[i] + free[i] * S::lit(0.2 * (fraction - 0.5))
    })
}
