//! What determines the unknowns that are no coordinates, group by group (L. V. Assur's groups: as many rows as unknowns,
//! and none smaller inside).

use plm_cas::{Expr, Graph};

use super::coordinates::{Coordinates, Unknown};
use super::dyad::{Dyad, Solution};
use super::loops;
use super::memory::Memory;
use super::motion::Motion;
use super::rows;
use super::single::Single;
use crate::topology::Block;

/// Unknowns that follow from those before.
#[derive(Clone, Debug)]
pub(crate) enum Group {
    /// One unknown of a linear row: the place of the row in [`Coordinates::rows`].
    Row { row: usize, unknown: usize },
    /// Two unknowns of a loop.
    Dyad(Dyad),
    /// The one unknown of a loop that says the rest for the second time.
    Single(Single),
}

impl Group {
    /// The group of a block, if there is a form for it. Equations are the loops, then the rows.
    pub(crate) fn of(coordinates: &Coordinates, block: &Block, graph: &mut Graph) -> Option<Group> {
        let loops = coordinates.closures.len();
        match (block.equations.as_slice(), block.unknowns.as_slice()) {
            (&[row], &[unknown]) if row >= loops => Some(Group::Row { row: row - loops, unknown }),
            (&[closure], &[first, second]) if closure < loops => {
                Dyad::of(coordinates, closure, [first, second], graph).map(Group::Dyad)
            }
            (&[closure], &[unknown]) if closure < loops => {
                Single::of(coordinates, closure, unknown).map(Group::Single)
            }
            _ => None,
        }
    }

    /// Effort of its solution, for the choice of coordinates.
    pub(crate) fn cost(&self) -> u32 {
        match self {
            Group::Row { .. } => 0,
            Group::Dyad(dyad) => dyad.cost(),
            Group::Single(_) => 2,
        }
    }

    /// The unknowns that it determines.
    pub(crate) fn unknowns(&self) -> Vec<usize> {
        match self {
            Group::Row { unknown, .. } => vec![*unknown],
            Group::Dyad(dyad) => dyad.unknowns.to_vec(),
            Group::Single(single) => vec![single.unknown],
        }
    }

    /// Is it a loop, which may be flat, and of which something is remembered?
    pub(crate) fn is_loop(&self) -> bool {
        !matches!(self, Group::Row { .. })
    }

    /// Its name in the literature.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Group::Row { .. } => "given",
            Group::Dyad(dyad) => dyad.name(),
            Group::Single(_) => "redundant",
        }
    }

    /// The joint that closes its loop, by its place in [`Coordinates::joints`].
    pub(crate) fn closing(&self, coordinates: &Coordinates) -> Option<usize> {
        match self {
            Group::Row { .. } => None,
            Group::Dyad(dyad) => Some(coordinates.closing(dyad.closure, &dyad.unknowns)),
            Group::Single(single) => Some(coordinates.closing(single.closure, &[single.unknown])),
        }
    }

    /// Writes its unknowns, their coefficients and rates into `motion`; `place` is its place among the loops in the memory.
    pub(crate) fn solve(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        (memory, place): (&Memory, usize),
        time: Expr,
        graph: &mut Graph,
    ) {
        match self {
            Group::Row { row, unknown } => {
                rows::solve(coordinates, motion, &coordinates.rows[*row], *unknown, time, graph);
            }
            Group::Dyad(dyad) => {
                let predicted = if dyad.is_signed() { memory.predicted(place, time, graph) } else { None };
                let solution = dyad.solve(coordinates, motion, predicted, graph);
                loops::differentiate_dyad(coordinates, motion, dyad, &solution, time, graph);
                motion.solutions.push(solution);
            }
            Group::Single(single) => {
                let solution = single.solve(coordinates, motion, time, graph);
                motion.solutions.push(solution);
            }
        }
        for unknown in self.unknowns() {
            if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
                let angle = memory.unwound(unknown, motion.axis[class], graph);
                motion.value[unknown] = angle.filter(|_| self.is_loop()).unwrap_or(motion.value[unknown]);
            }
        }
    }

    /// What is known of a loop where all unknowns are.
    pub(crate) fn at_pose(
        &self,
        coordinates: &Coordinates,
        motion: &Motion,
        graph: &mut Graph,
    ) -> Option<Solution> {
        match self {
            Group::Row { .. } => None,
            Group::Dyad(dyad) => Some(dyad.at_pose(coordinates, motion, graph)),
            Group::Single(_) => Some(Solution::certain(graph)),
        }
    }

    /// The rate of a loop's determinant.
    pub(crate) fn determinant_rate(
        &self,
        coordinates: &Coordinates,
        motion: &Motion,
        solution: &Solution,
        graph: &mut Graph,
    ) -> Expr {
        match self {
            Group::Row { .. } | Group::Single(_) => graph.zero(),
            Group::Dyad(dyad) => loops::determinant_rate(coordinates, motion, dyad, solution, graph),
        }
    }
}
