//! Groups of unknowns that are no coordinates, in the order of their solution (L. V. Assur's groups: as many rows as unknowns,
//! and none smaller inside).

pub(crate) mod crank;
pub(crate) mod dyad;
pub(crate) mod elimination;
pub(crate) mod explicit_row;
pub(crate) mod loops;
pub(crate) mod newton;
pub(crate) mod redundant_row;

use crate::collect::CollectVec;
use plm_cas::Expr;

use crate::formulate::reduced::groups::dyad::{Dyad, Kind};
use crate::formulate::reduced::groups::explicit_row::ExplicitRow;
use crate::formulate::reduced::groups::newton::Newton;
use crate::formulate::reduced::groups::redundant_row::RedundantRow;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::formulate::reduced::motion::solution::Solution;
use crate::topology::Block;

/// Unknowns that follow from those before.
#[derive(Clone)]
pub(crate) enum Group {
    /// One unknown, of a row that is explicit in it.
    ExplicitRow(ExplicitRow),
    /// Two unknowns of a loop.
    Dyad(Dyad),
    /// The one unknown of a loop with a redundant row.
    RedundantRow(RedundantRow),
    /// Unknowns of several loops that must be solved together.
    Newton(Newton),
}

impl Group {
    /// The group of a block, if there is a form for it. Equations are the loops, then the rows.
    pub(crate) fn of(coordinates: &Coordinates, block: &Block) -> Option<Group> {
        let loops = coordinates.closures.len();
        match (block.equations.as_slice(), block.unknowns.as_slice()) {
            (&[row], &[unknown]) if row >= loops => {
                ExplicitRow::of(coordinates, row - loops, unknown).map(Group::ExplicitRow)
            }
            (&[closure], &[first, second]) if closure < loops => {
                Dyad::of(coordinates, closure, [first, second]).map(Group::Dyad)
            }
            (&[closure], &[unknown]) if closure < loops => {
                RedundantRow::of(coordinates, closure, unknown).map(Group::RedundantRow)
            }
            _ => Newton::of(coordinates, block).map(Group::Newton),
        }
    }

    /// Effort of its solution, for the choice of coordinates; none without a closed form.
    pub(crate) fn cost(&self) -> Option<u32> {
        match self {
            Group::ExplicitRow(_) => Some(0),
            Group::Dyad(dyad) => Some(dyad.cost()),
            Group::RedundantRow(_) => Some(2),
            Group::Newton(_) => None,
        }
    }

    /// The unknowns that it determines.
    pub(crate) fn unknowns(&self) -> Vec<usize> {
        match self {
            Group::ExplicitRow(row) => vec![row.unknown],
            Group::Dyad(dyad) => dyad.unknowns.to_vec(),
            Group::RedundantRow(group) => vec![group.unknown],
            Group::Newton(newton) => newton.unknowns.clone(),
        }
    }

    /// True for a loop: it can be flat, and has a record in the memory.
    pub(crate) fn is_loop(&self) -> bool {
        !matches!(self, Group::ExplicitRow(_))
    }

    /// Its name in the literature.
    pub(crate) fn name(&self) -> String {
        match self {
            Group::ExplicitRow(_) => "explicit".to_owned(),
            Group::Dyad(dyad) => dyad.name().to_owned(),
            Group::RedundantRow(_) => "redundant".to_owned(),
            Group::Newton(newton) => newton.name(),
        }
    }

    /// The joint that closes its loop, by its place in [`Coordinates::joints`].
    pub(crate) fn closing(&self, coordinates: &Coordinates) -> Option<usize> {
        match self {
            Group::ExplicitRow(_) => None,
            Group::Dyad(dyad) => Some(coordinates.closing(dyad.closure, &dyad.unknowns)),
            Group::RedundantRow(group) => Some(coordinates.closing(group.closure, &[group.unknown])),
            Group::Newton(newton) => {
                newton.closures.iter().find_map(|&k| coordinates.loops[k].last().copied())
            }
        }
    }

    /// Writes its unknowns, their coefficients and rates into `motion`; `place` is its place among the loops in the memory.
    pub(crate) fn solve(&self, motion: &mut Motion, (memory, place): (&Memory, usize)) {
        let coordinates = motion.coordinates;
        let solution = match self {
            Group::ExplicitRow(row) => return row.solve(motion),
            Group::Dyad(dyad) => {
                let side = if dyad.is_signed() { memory.area(place) } else { None };
                dyad.solve(motion, side)
            }
            Group::RedundantRow(group) => group.solve(motion),
            Group::Newton(newton) => newton.solve(motion, memory),
        };
        motion.solutions.push(solution);
        for unknown in self.unknowns() {
            if let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] {
                let angle = memory.unwound(unknown, motion.rotation[orientation]);
                motion.value[unknown] = angle.unwrap_or(motion.value[unknown]);
            }
        }
    }

    /// Solution of a loop where all unknowns are known.
    pub(crate) fn at_pose(&self, motion: &Motion) -> Option<Solution> {
        match self {
            Group::ExplicitRow(_) => None,
            Group::Dyad(dyad) => Some(dyad.at_pose(motion)),
            Group::RedundantRow(_) => Some(Solution::certain()),
            Group::Newton(newton) => Some(newton.at_pose(motion)),
        }
    }

    /// How fast a loop comes nearer to flat, rad, when the unknowns move at some rates: its two lines turn towards each
    /// other, or its displacement covers the scene's length.
    pub(crate) fn closing_in(
        &self,
        coordinates: &Coordinates,
        (rate, length): (&dyn Fn(usize) -> Expr, Expr),
    ) -> Vec<Expr> {
        let is_length = |unknown: usize| !matches!(coordinates.unknowns[unknown], Unknown::Angle { .. });
        match self {
            Group::ExplicitRow(_) | Group::RedundantRow(_) => Vec::new(),
            Group::Dyad(dyad) => {
                let turning = |orientation: usize| {
                    coordinates.angle_of_orientation[orientation].map_or(Expr::ZERO, rate)
                };
                match dyad.kind {
                    Kind::Angles([a, b])
                    | Kind::Displacements([a, b])
                    | Kind::Across { orientation: a, along: b } => {
                        let turning = [turning(a), turning(b)];
                        vec![turning[0] - turning[1]]
                    }
                    Kind::Along { .. } => vec![rate(dyad.unknowns[1]) / length],
                }
            }
            Group::Newton(newton) => {
                let one = |&unknown: &usize| {
                    if is_length(unknown) { rate(unknown) / length } else { rate(unknown) }
                };
                newton.unknowns.iter().map(one).collect_vec()
            }
        }
    }
}
