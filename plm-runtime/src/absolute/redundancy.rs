//! Which constraints and locks depend on each other.

use super::independent::{column_sizes, scale_columns};
use super::newton::without_pivoting;
use super::{Absolute, fill};
use crate::linalg::{diagonal, rotate};
use crate::scalar::Real;
use crate::vector::Vector;
use crate::workspace;

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
    /// All of so many rows are independent.
    const fn none(rows: usize) -> Self {
        Self {
            free_rank: rows,
            of_locks: 0,
            of_joints: 0,
            locks: [false; NQ],
            ties: [false; NC],
            rows: [false; NC],
        }
    }

    /// At the position `q`, where a coordinate with `free` = 0 is locked and one with `free` = 1 is not.
    /// `None` if the Jacobian is not finite, or if a solution by rank is refused.
    pub(super) fn at<S: Real, M: Absolute<S, NQ, NC>>(
        m: &M,
        t: S,
        q: &[S; NQ],
        free: &[S; NQ],
    ) -> Option<Self> {
        // Elimination that stays healthy has found every row independent.
        if without_pivoting(m, t, q, free, &[S::lit(0.0); NC]).is_some() {
            return Some(Self::none(m.layout().rows.len()));
        }
        if workspace::refusal::<S, NQ, NC>().is_some() {
            None
        } else {
            Self::by_rank(m, (t, q), free, S::RANK_TOLERANCE)
        }
    }

    /// Dependencies by orthogonalisation; singular values below `tolerance` of the largest count as zero. It stores two matrices, for which
    /// starts of healthy mechanisms must not pay.
    #[cold]
    #[inline(never)]
    pub(super) fn by_rank<S: Real, M: Absolute<S, NQ, NC>>(
        m: &M,
        at: (S, &[S; NQ]),
        free: &[S; NQ],
        tolerance: S,
    ) -> Option<Self> {
        // One by one: a build without optimisation copies what is made as a pair.
        let mut rows = [[S::lit(0.0); NQ]; NC];
        let mut y = [[S::lit(0.0); NC]; NC];
        // Columns scaled to 1, so that units have no say.
        fill(m, at, &[S::lit(1.0); NQ], &mut rows);
        let scale = Vector::map(&column_sizes(&rows), |size| S::lit(1.0) / size);
        scale_columns(&mut rows, &scale);
        scale_columns(&mut rows, free);
        diagonal(&mut y);
        let singular = rotate(&mut rows, &mut y)?;
        let cut = singular.cut(tolerance);

        let mut found = Self { free_rank: singular.rank(cut), ..Self::none(0) };
        // Rows without a combination become zero and mark nothing.
        for (k, sigma) in singular.values.iter().enumerate() {
            rows[k] = [S::lit(0.0); NQ];
            if *sigma > cut {
                y[k] = [S::lit(0.0); NC];
            }
        }
        let locked: [S; NQ] = Vector::from_fn(|i| scale[i] * (S::lit(1.0) - free[i]));
        m.phi_q(at.0, at.1, &mut |row, column, entry| {
            let entry = entry * locked.at(column);
            for (z, y) in rows.iter_mut().zip(&y) {
                z.set(column, y.at(row).mul_add(entry, z.at(column)));
            }
        });
        found.sort(m.layout().rows.len(), &mut rows, &mut y)?;
        Some(found)
    }

    /// Separates combinations `y` of so many rows into those with locks (`z`) and those without.
    fn sort<S: Real>(&mut self, count: usize, z: &mut [[S; NQ]; NC], y: &mut [[S; NC]; NC]) -> Option<()> {
        let (tied, least) = (rotate(z, y)?, S::RANK_TOLERANCE);
        self.of_locks = tied.rank(least);
        self.of_joints = count.saturating_sub(self.free_rank + self.of_locks);
        for (k, sigma) in tied.values.iter().enumerate() {
            if *sigma > least {
                mark(&mut self.locks, &z[k], *sigma);
                mark(&mut self.ties, &y[k], S::lit(1.0));
            } else {
                mark(&mut self.rows, &y[k], S::lit(1.0));
            }
        }
        Some(())
    }
}

/// Marks where a vector of the given size is not zero.
fn mark<S: Real, const N: usize>(marks: &mut [bool; N], vector: &[S; N], size: S) {
    for (mark, entry) in marks.iter_mut().zip(vector) {
        *mark |= entry.abs() > S::RANK_TOLERANCE * size;
    }
}

/// A position beside `q` that no symmetry singles out: free coordinates moved by up to 0.1 (rad, and m, or less where the
/// mechanism is smaller), by the fractions of multiples of the golden ratio. The rank there is the highest that the equations can have, off phi = 0.
pub(crate) fn beside<S: Real, const NQ: usize>(q: &[S; NQ], free: &[S; NQ], length: S) -> [S; NQ] {
    let (mut parts, reach) = (fractions(), S::lit(0.2) * length.min(S::lit(1.0)));
    Vector::from_fn(|i| q[i] + free[i] * reach * S::lit(parts.next().unwrap_or_default()))
}

/// The fractions of multiples of the golden ratio, less a half.
pub(super) fn fractions() -> impl Iterator<Item = f64> {
    let mut fraction = 0.0;
    core::iter::repeat_with(move || {
        fraction += 0.618_033_988_749_894_9;
        if fraction >= 1.0 {
            fraction -= 1.0;
        }
        fraction - 0.5
    })
}
