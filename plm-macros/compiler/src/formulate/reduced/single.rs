//! A loop with more rows than it has unknowns: redundant constraints that agree, like the third of parallel cranks.
//!
//! Its one unknown follows from one of its two rows; that the other holds as well is a matter of dimensions, which is
//! looked at: a mismatch of more than a billionth of the length (`f32`: of a hundred-thousandth) makes the loop one that
//! cannot be closed.

use plm_cas::{Expr, Graph};

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
    pub(crate) fn solve(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        time: Expr,
        graph: &mut Graph,
    ) -> Solution {
        let turns = matches!(coordinates.unknowns[self.unknown], Unknown::Angle { .. });
        let chain = &coordinates.closures[self.closure];
        let turning: &[usize] = if turns { &[self.class] } else { &[] };
        let m = known(chain, turning, &[self.unknown], motion, graph);
        let (column, length, mismatch, arms) = if turns {
            let arm = motion.arm(chain, self.class, &[], graph);
            let square = plane::dot(graph, arm, arm);
            let p = plane::negated(graph, m);
            let p = motion.name_arm(self.unknown, p, graph);
            let axis = [plane::dot(graph, arm, p), plane::cross(graph, arm, p)];
            let axis = axis.map(|product| graph.div(product, square));
            motion.turn_class(self.unknown, self.class, axis, graph);
            let distance = plane::dot(graph, p, p);
            let mismatch = graph.sub(distance, square);
            let twice = graph.add(square, square);
            (plane::left(graph, p), square, graph.div(mismatch, twice), vec![(self.class, p)])
        } else {
            let vector = chain.slide(self.unknown).map_or([graph.zero(); 2], |slide| slide.1);
            let e = motion.turned(graph, self.class, vector);
            let along = plane::dot(graph, m, e);
            let along = graph.neg(along);
            motion.set_slide(self.unknown, along, graph);
            let aside = plane::cross(graph, m, e);
            (e, graph.one(), graph.div(aside, motion.length), Vec::new())
        };
        let mismatch = graph.mul(mismatch, motion.agreement);
        let mismatch = graph.powi(mismatch, 2);
        let one = graph.one();
        let square = graph.sub(one, mismatch);
        let zero = graph.zero();
        // Zero where it does not close, and of the size of a dyad's.
        let closes = graph.max(square, zero);
        let area = graph.powi(motion.length, 2);
        let determinant = graph.mul(area, closes);
        let solution = Solution { determinant, square, arms, ..Solution::certain(graph) };
        let nearest = |sum: Vec2, graph: &mut Graph| {
            let along = plane::dot(graph, sum, column);
            let along = graph.neg(along);
            vec![graph.div(along, length)]
        };
        let found =
            Found { closure: self.closure, unknowns: &[self.unknown], solution: &solution, solve: &nearest };
        loops::differentiate(coordinates, motion, &found, time, graph);
        solution
    }
}
