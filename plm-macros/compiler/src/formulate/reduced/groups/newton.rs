//! Loops that have to be solved together and have no closed form: Newton's iteration from where the unknowns are expected.
//!
//! The count of corrections is fixed, so that the code is straight and its time known. The start is the last state that
//! was looked at, moved on by the rates there and how they change; which of many solutions is meant needs no other
//! memory. A correction turns a body by `2 atan(d / 2)` instead of `d`, which takes no sine and differs by a third power
//! only: a first solution `e` off is `e^2`, then with the same decomposition `e^3`, then `e^6` (J. F. Traub, Iterative
//! Methods for the Solution of Equations, 1964). Whether that was enough is told by the gap that is left.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Rotation, Vec2, algebra};

use crate::formulate::reduced::groups::elimination::{Column, Elimination, Plan};
use crate::formulate::reduced::groups::loops::Flow;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::formulate::reduced::motion::solution::Solution;
use crate::topology::Block;

/// Unknowns that are solved at once; the effort grows with the third power.
pub(crate) const MOST_UNKNOWNS: usize = 8;
/// Corrections with each decomposition of the Jacobian. One more decomposition is made at the solution, for the rates.
const CORRECTIONS: [usize; 2] = [2, 1];
/// The widest gap that counts as closed, in units in the last place of the scene's size.
const CLOSED: i32 = 4096;

/// A block of loops with as many rows as unknowns.
#[derive(Clone)]
pub(crate) struct Newton {
    pub(crate) closures: Vec<usize>,
    pub(crate) unknowns: Vec<usize>,
    plan: Plan,
}

/// The vectors of a loop that turn with each orientation.
type Arms = Vec<(usize, Vec2)>;

impl Newton {
    /// The group of a block, if it holds nothing but loops, is small enough, and has enough bars of constant length.
    pub(crate) fn of(coordinates: &Coordinates, block: &Block) -> Option<Newton> {
        let (closures, unknowns) = (&block.equations, &block.unknowns);
        let loops = closures.iter().all(|&equation| equation < coordinates.closures.len());
        let fits = 2 * closures.len() == unknowns.len() && (4..=MOST_UNKNOWNS).contains(&unknowns.len());
        if !(loops && fits) {
            return None;
        }
        let mut squares = Vec::new();
        for &closure in closures {
            let chain = &coordinates.closures[closure];
            let square = |&unknown: &usize| match coordinates.unknowns[unknown] {
                Unknown::Angle { orientation, .. } => {
                    let vectors: Vec<(Option<usize>, Vec2)> = chain.of_orientation(orientation).collect_vec();
                    match vectors.as_slice() {
                        [] => Column::Absent,
                        &[(None, arm)] => Column::Constant(arm.dot(arm)),
                        _ => Column::Varying,
                    }
                }
                _ => chain
                    .displacement(unknown)
                    .map_or(Column::Absent, |(_, axis)| Column::Constant(axis.dot(axis))),
            };
            squares.push(unknowns.iter().map(square).collect_vec());
        }
        let plan = Plan::new(&squares)?;
        Some(Newton { closures: closures.clone(), unknowns: unknowns.clone(), plan })
    }

    /// Its name in the report.
    pub(crate) fn name(&self) -> String {
        let steps: usize = CORRECTIONS.iter().sum();
        format!("Newton of {} unknowns in {steps} steps:", self.unknowns.len())
    }

    /// Solves for the unknowns and writes them, their coefficients and rates into `motion`.
    pub(crate) fn solve(&self, motion: &mut Motion, memory: &Memory) -> Solution {
        self.predict(motion, memory);
        let known = self.known(motion);
        let mut step = 0;
        for corrections in CORRECTIONS {
            let arms = self.arms(motion, &format!("{step}"));
            let decomposed = self.decomposed(motion, (&arms, &format!("j{step}")));
            for _ in 0..corrections {
                let arms = self.arms(motion, &format!("{step}"));
                let gap = self.gap(&known, &arms, &format!("{step}"));
                let correction = decomposed.solve(gap, &format!("step_{step}"));
                self.correct(motion, &correction, step);
                step += 1;
            }
        }
        self.name_axes(motion);
        let arms = self.arms(motion, "");
        let decomposed = self.decomposed(motion, (&arms, "j"));
        self.differentiate(motion, (&arms, &decomposed));
        let gap = self.gap(&known, &arms, "");
        let closed = is_closed(&gap, motion);
        Solution::of_measure(decomposed.measure, closed)
    }

    /// The measure where all unknowns are known.
    pub(crate) fn at_pose(&self, motion: &Motion) -> Solution {
        let arms = self.arms(motion, "");
        let measure = self.decomposed(motion, (&arms, "j")).measure;
        let closed = Expr::ONE;
        Solution::of_measure(measure, closed)
    }

    /// Writes the unknowns as they should be at `time`.
    fn predict(&self, motion: &mut Motion, memory: &Memory) {
        let coordinates = motion.coordinates;
        for &unknown in &self.unknowns {
            let Some([value, moved]) = memory.moved(unknown, motion.time) else { continue };
            let name = format!("{}_expected", motion.names[unknown]);
            let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] else {
                motion.value[unknown] = ((value + moved) * motion.length).named(&name);
                continue;
            };
            let Some(rotation) = memory.rotation(unknown) else { continue };
            // tan(x / 2) = x / 2 (1 + x^2 / 12 + ...).
            let [twelfth, half] = [12, 2].map_each(|n| Expr::from(n).recip());
            let bend = moved.squared() * twelfth;
            let tangent = algebra::product(&[half, moved, 1 + bend]);
            motion.rotation[orientation] = turned_on(rotation, tangent, &name);
        }
    }

    /// Subtracts a correction from the unknowns.
    fn correct(&self, motion: &mut Motion, correction: &[Expr], step: usize) {
        let coordinates = motion.coordinates;
        for (&unknown, &by) in self.unknowns.iter().zip(correction) {
            let name = format!("{}_{step}", motion.names[unknown]);
            if let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] {
                let tangent = Expr::from(-2).recip() * by;
                motion.rotation[orientation] = turned_on(motion.rotation[orientation], tangent, &name);
            } else {
                motion.value[unknown] = (motion.value[unknown] - by).named(&name);
            }
        }
    }

    /// The solution by the names of the unknowns.
    fn name_axes(&self, motion: &mut Motion) {
        let coordinates = motion.coordinates;
        for &unknown in &self.unknowns {
            if let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] {
                motion.set_rotation(unknown, orientation, motion.rotation[orientation]);
            } else {
                motion.set_value(unknown, motion.value[unknown]);
            }
        }
    }

    /// Coefficients and rates of the unknowns.
    fn differentiate(&self, motion: &mut Motion, (arms, decomposed): (&[Arms], &Elimination)) {
        let flows = self
            .closures
            .iter()
            .zip(arms)
            .map(|(&closure, arms)| Flow::new(motion, closure, (&self.unknowns, arms)));
        let flows: Vec<Flow> = flows.collect_vec();
        let solve = |sums: Vec<Vec2>, what: &str| {
            let values = decomposed.solve(sums, what);
            values.into_iter().map(|value| -value).collect_vec()
        };
        for coordinate in 0..motion.independent.len() {
            let sums = flows.iter().map(|flow| flow.coefficient(motion, coordinate)).collect_vec();
            let values = solve(sums, &format!("coefficient_{coordinate}"));
            for (&unknown, value) in self.unknowns.iter().zip(values) {
                motion.coefficient[unknown][coordinate] = value;
            }
        }
        let sums = flows.iter().map(|flow| flow.time_rate(motion)).collect_vec();
        for (&unknown, value) in self.unknowns.iter().zip(solve(sums, "time_rate")) {
            motion.time_rate[unknown] = value;
            motion.set_rate(unknown);
        }
        let sums = flows.iter().map(|flow| flow.bias(motion)).collect_vec();
        for (&unknown, value) in self.unknowns.iter().zip(solve(sums, "bias")) {
            motion.bias[unknown] = value;
        }
    }

    /// The vectors of each loop that move with the unknowns, by orientation.
    fn arms(&self, motion: &Motion, tag: &str) -> Vec<Arms> {
        let coordinates = motion.coordinates;
        let of_loop = |&closure: &usize| {
            let chain = &coordinates.closures[closure];
            let moving = chain
                .orientations()
                .into_iter()
                .filter(|&orientation| self.moves(coordinates, closure, orientation));
            let moving: Vec<usize> = moving.collect_vec();
            let arms = moving.into_iter().map(|orientation| {
                (
                    orientation,
                    motion
                        .absolute_arm(chain, orientation)
                        .named(format!("arm{tag}_{closure}_{orientation}")),
                )
            });
            arms.collect_vec()
        };
        self.closures.iter().map(of_loop).collect_vec()
    }

    /// Does the vector of a loop that turns with an orientation depend on the unknowns?
    fn moves(&self, coordinates: &Coordinates, closure: usize, orientation: usize) -> bool {
        let turns =
            coordinates.angle_of_orientation[orientation].is_some_and(|angle| self.unknowns.contains(&angle));
        let mut displacements = coordinates.closures[closure]
            .of_orientation(orientation)
            .filter_map(|(displacement, _)| displacement);
        turns || displacements.any(|displacement| self.unknowns.contains(&displacement))
    }

    /// The sum of all other vectors of each loop.
    fn known(&self, motion: &Motion) -> Vec<Vec2> {
        let coordinates = motion.coordinates;
        let of_loop = |&closure: &usize| {
            let chain = &coordinates.closures[closure];
            let still = chain
                .orientations()
                .into_iter()
                .filter(|&orientation| !self.moves(coordinates, closure, orientation));
            let sum: Vec2 = still.map(|orientation| motion.absolute_arm(chain, orientation)).sum();
            sum.named(format!("loop_{closure}"))
        };
        self.closures.iter().map(of_loop).collect_vec()
    }

    /// Sums of the vectors of each loop: zero at the solution.
    fn gap(&self, known: &[Vec2], arms: &[Arms], tag: &str) -> Vec<Vec2> {
        let of_loop = |((closure, known), arms): ((&usize, &Vec2), &Arms)| {
            let sum = arms.iter().fold(*known, |sum, (_, arm)| sum + *arm);
            sum.named(format!("gap{tag}_{closure}"))
        };
        self.closures.iter().zip(known).zip(arms).map(of_loop).collect_vec()
    }

    /// The derivatives of the loops by the unknowns, decomposed.
    fn decomposed(&self, motion: &Motion, (arms, name): (&[Arms], &str)) -> Elimination<'_> {
        let coordinates = motion.coordinates;
        let of_loop = |(&closure, arms): (&usize, &Arms)| {
            let chain = &coordinates.closures[closure];
            let column = |&unknown: &usize| {
                if let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] {
                    let arm = arms.iter().find(|(own, _)| *own == orientation);
                    return arm.map_or(Vec2::ZERO, |(_, arm)| (*arm).left());
                }
                let displacement = chain.displacement(unknown);
                displacement.map_or(Vec2::ZERO, |(orientation, vector)| motion.turned(orientation, vector))
            };
            self.unknowns.iter().map(column).collect_vec()
        };
        let columns = self.closures.iter().zip(arms).map(of_loop).collect_vec();
        let name = format!("{name}_{}", self.closures.first().copied().unwrap_or(0));
        Elimination::new(&self.plan, columns, (&name, motion.length))
    }
}

/// Did the iteration converge?
fn is_closed(gap: &[Vec2], motion: &Motion) -> Expr {
    let squares: Expr = gap.iter().flat_map(|gap| gap.components()).map(Expr::squared).sum();
    let least = algebra::product(&[Expr::from(CLOSED), motion.precision, motion.length]);
    squares.less(least.squared())
}

/// A rotation, and another one after it by twice the angle with this tangent; its length is kept to rounding.
fn turned_on(rotation: Rotation, tangent: Expr, name: &str) -> Rotation {
    let t = tangent.named(format!("{name}_tangent"));
    let denominator = 1 + t.squared();
    let sine = ((t + t) / denominator).named(format!("{name}_sine"));
    let Rotation { cos, sin } = rotation;
    let (across, along) = (t * cos + sin, cos - t * sin);
    let turned = Rotation { cos: cos - sine * across, sin: sin + sine * along };
    turned.named(format!("{name}_cos"), format!("{name}_sin"))
}
