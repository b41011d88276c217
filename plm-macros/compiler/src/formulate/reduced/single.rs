//! A loop with more rows than it has unknowns: redundant constraints that agree, like the third of parallel cranks.
//!
//! Its one unknown follows from one of its two rows; that the other holds as well is a matter of dimensions, which is
//! looked at: a mismatch of more than a billionth of the length (`f32`: of a hundred-thousandth) makes the loop one that
//! cannot be closed.

use plm_cas::Expr;

use super::coordinates::{Coordinates, Unknown};
use super::dyad::known;
use super::loops::{self, Found};
use super::motion::Motion;
use super::plane::{self, Vec2};
use super::solution::Solution;

/// The one unknown of a loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Single {
    /// The loop.
    pub(crate) closure: usize,
    pub(crate) unknown: usize,
    /// The class that turns, if the unknown is an angle; that along which it slides else.
    class: usize,
}

impl Single {
    pub(crate) fn of(coordinates: &Coordinates, closure: usize, unknown: usize) -> Option<Single> {
        let class = match coordinates.unknowns[unknown] {
            Unknown::Angle { class, .. } => class,
            Unknown::Slide { .. } => coordinates.closures[closure].slide(unknown)?.0,
            Unknown::Centre { .. } => return None,
        };
        Some(Single { closure, unknown, class })
    }

    /// Writes the unknown, its coefficients and rate into `motion`.
    pub(crate) fn solve(&self, coordinates: &Coordinates, motion: &mut Motion, time: Expr) -> Solution {
        let turns = matches!(coordinates.unknowns[self.unknown], Unknown::Angle { .. });
        let chain = &coordinates.closures[self.closure];
        let turning: &[usize] = if turns { &[self.class] } else { &[] };
        let m = known(chain, turning, &[self.unknown], motion);
        let (column, length, mismatch, arms) = if turns {
            let arm = motion.arm(chain, self.class, &[]);
            let square = plane::dot(arm, arm);
            let p = plane::negated(m);
            let p = motion.name_arm(self.unknown, p);
            let axis = [plane::dot(arm, p), plane::cross(arm, p)];
            let axis = axis.map(|product| product / square);
            motion.turn_class(self.unknown, self.class, axis);
            let distance = plane::dot(p, p);
            let mismatch = distance - square;
            let twice = square + square;
            (plane::left(p), square, mismatch / twice, vec![(self.class, p)])
        } else {
            let vector = chain.slide(self.unknown).map_or([Expr::ZERO; 2], |slide| slide.1);
            let e = motion.turned(self.class, vector);
            let along = plane::dot(m, e);
            let along = -along;
            motion.set_slide(self.unknown, along);
            let aside = plane::cross(m, e);
            (e, Expr::ONE, aside / motion.length, Vec::new())
        };
        let mismatch = mismatch * motion.agreement;
        let mismatch = mismatch.powi(2);
        let one = Expr::ONE;
        let square = one - mismatch;
        let zero = Expr::ZERO;
        // Zero where it does not close, and of the size of a dyad's.
        let closes = square.max(zero);
        let area = motion.length.powi(2);
        let determinant = area * closes;
        let solution = Solution { determinant, square, arms, ..Solution::certain() };
        let nearest = |sum: Vec2| {
            let along = plane::dot(sum, column);
            let along = -along;
            vec![along / length]
        };
        let found =
            Found { closure: self.closure, unknowns: &[self.unknown], solution: &solution, solve: &nearest };
        loops::differentiate(coordinates, motion, &found, time);
        solution
    }
}
