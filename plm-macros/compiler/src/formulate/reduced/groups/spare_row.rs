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
pub(crate) struct SpareRow {
    /// The loop.
    pub(crate) closure: usize,
    pub(crate) unknown: usize,
    /// The class that turns, if the unknown is an angle; that along which it slides else.
    class: usize,
}

impl SpareRow {
    pub(crate) fn of(coordinates: &Coordinates, closure: usize, unknown: usize) -> Option<SpareRow> {
        let class = match coordinates.unknowns[unknown] {
            Unknown::Angle { class, .. } => class,
            Unknown::Slide { .. } => coordinates.closures[closure].slide(unknown)?.0,
            Unknown::Centre { .. } => return None,
        };
        Some(SpareRow { closure, unknown, class })
    }

    /// Writes the unknown, its coefficients and rate into `motion`.
    pub(crate) fn solve(&self, motion: &mut Motion) -> Solution {
        let coordinates = motion.coordinates;
        let turns = matches!(coordinates.unknowns[self.unknown], Unknown::Angle { .. });
        let chain = &coordinates.closures[self.closure];
        let turning: &[usize] = if turns { &[self.class] } else { &[] };
        let m = motion.known_sum(chain, turning, &[self.unknown]);
        let (column, length, mismatch, arms) = if turns {
            let arm = motion.arm(chain, self.class, &[]);
            let square = arm.squared();
            let p = motion.name_arm(self.unknown, -m);
            motion.turn_class(self.unknown, self.class, Rotation::between(arm, p) / square);
            let mismatch = (p.squared() - square) / (square + square);
            (p.left(), square, mismatch, vec![(self.class, p)])
        } else {
            let vector = chain.slide(self.unknown).map_or(Vec2::ZERO, |slide| slide.1);
            let e = motion.turned(self.class, vector);
            motion.set_slide(self.unknown, -m.dot(e));
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
