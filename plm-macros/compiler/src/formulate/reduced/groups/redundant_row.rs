//! A loop with more rows than it has unknowns: redundant constraints that agree, like the third of parallel cranks.
//!
//! Its one unknown follows from one of its two rows; that the other holds as well is a matter of dimensions, which is
//! looked at: a mismatch of more than a billionth of the length (`f32`: of a hundred-thousandth) makes the loop one that
//! cannot be closed.

use plm_cas::{Expr, Rotation, Vec2};

use crate::formulate::reduced::groups::loops::{self, Found};
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::solution::Solution;

/// The one unknown of a loop.
#[derive(Clone, Copy)]
pub(crate) struct RedundantRow {
    /// The loop.
    pub(crate) closure: usize,
    pub(crate) unknown: usize,
    /// The orientation that turns, if the unknown is an angle; that along which it slides else.
    orientation: usize,
}

impl RedundantRow {
    pub(crate) fn of(coordinates: &Coordinates, closure: usize, unknown: usize) -> Option<RedundantRow> {
        let orientation = match coordinates.unknowns[unknown] {
            Unknown::Angle { orientation, .. } => orientation,
            Unknown::Displacement { .. } => coordinates.closures[closure].displacement(unknown)?.0,
            Unknown::Centre { .. } => return None,
        };
        Some(RedundantRow { closure, unknown, orientation })
    }

    /// Writes the unknown, its coefficients and rate into `motion`.
    pub(crate) fn solve(&self, motion: &mut Motion) -> Solution {
        let coordinates = motion.coordinates;
        let turns = matches!(coordinates.unknowns[self.unknown], Unknown::Angle { .. });
        let chain = &coordinates.closures[self.closure];
        let turning: &[usize] = if turns { &[self.orientation] } else { &[] };
        let m = motion.known_sum(chain, turning, &[self.unknown]);
        let (column, length, mismatch, arms) = if turns {
            let arm = motion.arm(chain, self.orientation, &[]);
            let square = arm.squared();
            let p = motion.name_arm(self.unknown, -m);
            motion.set_rotation(self.unknown, self.orientation, Rotation::between(arm, p) / square);
            let mismatch = (p.squared() - square) / (square + square);
            (p.left(), square, mismatch, vec![(self.orientation, p)])
        } else {
            let vector = chain.displacement(self.unknown).map_or(Vec2::ZERO, |displacement| displacement.1);
            let e = motion.turned(self.orientation, vector);
            motion.set_value(self.unknown, -m.dot(e));
            (e, Expr::ONE, m.cross(e) / motion.length, Vec::new())
        };
        let square = 1 - (mismatch * motion.agreement).squared();
        // Zero where it does not close, and of the size of a dyad's.
        let determinant = motion.length.squared() * square.max(Expr::ZERO);
        let solution = Solution { determinant, square, arms, ..Solution::certain() };
        let nearest = |sum: Vec2| vec![-sum.dot(column) / length];
        let found =
            Found { closure: self.closure, unknowns: &[self.unknown], solution: &solution, solve: &nearest };
        loops::differentiate(motion, &found);
        solution
    }
}
