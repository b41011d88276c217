//! Loops that have to be solved together and have no closed form: Newton's iteration from where the unknowns are expected.
//!
//! The count of corrections is fixed, so that the code is straight and its time known. The start is the last state that
//! was looked at, moved on by the rates there and how they change; which of many solutions is meant needs no other
//! memory. A correction turns a body by `2 atan(d / 2)` instead of `d`, which takes no sine and differs by a third power
//! only: a first solution `e` off is `e^2`, then with the same decomposition `e^3`, then `e^6` (J. F. Traub, Iterative
//! Methods for the Solution of Equations, 1964). Whether that was enough is told by the gap that is left.

use plm_cas::{Expr, Number, algebra};

use super::coordinates::{Coordinates, Unknown};
use super::elimination::{Column, Elimination, Plan};
use super::loops::Flow;
use super::memory::Memory;
use super::motion::Motion;
use super::plane::{self, Vec2};
use super::solution::Solution;
use crate::topology::Block;

/// Unknowns that are solved at once; the effort grows with the third power.
pub(crate) const MOST_UNKNOWNS: usize = 8;
/// Corrections with each decomposition of the Jacobian. One more decomposition is made at the solution, for the rates.
const CORRECTIONS: [usize; 2] = [2, 1];
/// The widest gap that counts as closed, in units in the last place of the scene's size.
const CLOSED: i64 = 4096;

/// A block of loops with as many rows as unknowns.
#[derive(Clone, Debug)]
pub(crate) struct Newton {
    pub(crate) closures: Vec<usize>,
    pub(crate) unknowns: Vec<usize>,
    plan: Plan,
}

/// The vectors of a loop that turn with each class.
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
                Unknown::Angle { class, .. } => {
                    let vectors: Vec<(Option<usize>, Vec2)> = chain.of_class(class).collect();
                    match vectors.as_slice() {
                        [] => Column::Absent,
                        &[(None, arm)] => Column::Constant(plane::dot(arm, arm)),
                        _ => Column::Varying,
                    }
                }
                _ => chain
                    .slide(unknown)
                    .map_or(Column::Absent, |(_, axis)| Column::Constant(plane::dot(axis, axis))),
            };
            squares.push(unknowns.iter().map(square).collect());
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
    pub(crate) fn solve(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        memory: &Memory,
        time: Expr,
    ) -> Solution {
        self.predict(coordinates, motion, memory, time);
        let known = self.known(coordinates, motion);
        let mut step = 0;
        for corrections in CORRECTIONS {
            let arms = self.arms(coordinates, motion, &format!("{step}"));
            let jacobian = self.jacobian(coordinates, motion, (&arms, &format!("j{step}")));
            for _ in 0..corrections {
                let arms = self.arms(coordinates, motion, &format!("{step}"));
                let gap = self.gap(&known, &arms, &format!("{step}"));
                let correction = jacobian.solve(gap, &format!("step_{step}"));
                self.correct(coordinates, motion, &correction, step);
                step += 1;
            }
        }
        self.name_axes(coordinates, motion);
        let arms = self.arms(coordinates, motion, "");
        let jacobian = self.jacobian(coordinates, motion, (&arms, "j"));
        self.differentiate(coordinates, motion, (&arms, &jacobian), time);
        let gap = self.gap(&known, &arms, "");
        let closed = is_closed(&gap, memory, motion.length);
        Solution::of_measure(jacobian.measure, closed)
    }

    /// The measure where all unknowns are known.
    pub(crate) fn at_pose(&self, coordinates: &Coordinates, motion: &Motion) -> Solution {
        let arms = self.arms(coordinates, motion, "");
        let measure = self.jacobian(coordinates, motion, (&arms, "j")).measure;
        let closed = Expr::ONE;
        Solution::of_measure(measure, closed)
    }

    /// Writes the unknowns as they should be at `time`.
    fn predict(&self, coordinates: &Coordinates, motion: &mut Motion, memory: &Memory, time: Expr) {
        for &unknown in &self.unknowns {
            let Some([value, moved]) = memory.moved(unknown, time) else { continue };
            let name = format!("{}_expected", motion.names[unknown]);
            let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] else {
                let sum = value + moved;
                let value = sum * motion.length;
                motion.value[unknown] = value.named(&name);
                continue;
            };
            let Some(axis) = memory.axis(unknown) else { continue };
            // tan(x / 2) = x / 2 (1 + x^2 / 12 + ...).
            let square = moved.powi(2);
            let [twelfth, half] = [12, 2].map(fraction);
            let bend = square * twelfth;
            let one = Expr::ONE;
            let factor = one + bend;
            let tangent = algebra::product(&[half, moved, factor]);
            motion.axis[class] = rotated(axis, tangent, &name);
        }
    }

    /// Subtracts a correction from the unknowns.
    fn correct(&self, coordinates: &Coordinates, motion: &mut Motion, correction: &[Expr], step: usize) {
        for (&unknown, &by) in self.unknowns.iter().zip(correction) {
            let name = format!("{}_{step}", motion.names[unknown]);
            if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
                let half = fraction(-2);
                let tangent = half * by;
                motion.axis[class] = rotated(motion.axis[class], tangent, &name);
            } else {
                let value = motion.value[unknown] - by;
                motion.value[unknown] = value.named(&name);
            }
        }
    }

    /// The solution by the names of the unknowns.
    fn name_axes(&self, coordinates: &Coordinates, motion: &mut Motion) {
        for &unknown in &self.unknowns {
            if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
                motion.turn_class(unknown, class, motion.axis[class]);
            } else {
                motion.set_slide(unknown, motion.value[unknown]);
            }
        }
    }

    /// Coefficients and rates of the unknowns.
    fn differentiate(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        (arms, jacobian): (&[Arms], &Elimination),
        time: Expr,
    ) {
        let flows =
            self.closures.iter().zip(arms).map(|(&closure, arms)| {
                Flow::new(coordinates, motion, closure, (&self.unknowns, arms), time)
            });
        let flows: Vec<Flow> = flows.collect();
        let solve = |sums: Vec<Vec2>, what: &str| {
            let values = jacobian.solve(sums, what);
            values.into_iter().map(|value| -value).collect::<Vec<Expr>>()
        };
        for driver in 0..motion.drivers.len() {
            let sums = flows.iter().map(|flow| flow.gain(motion, driver)).collect();
            let values = solve(sums, &format!("gain_{driver}"));
            for (&unknown, value) in self.unknowns.iter().zip(values) {
                motion.gain[unknown][driver] = value;
            }
        }
        let sums = flows.iter().map(|flow| flow.drift(motion)).collect();
        for (&unknown, value) in self.unknowns.iter().zip(solve(sums, "drift")) {
            motion.drift[unknown] = value;
            motion.set_rate(coordinates, unknown);
        }
        let sums = flows.iter().map(|flow| flow.bias(motion, time)).collect();
        for (&unknown, value) in self.unknowns.iter().zip(solve(sums, "bias")) {
            motion.bias[unknown] = value;
        }
    }

    /// The vectors of each loop that move with the unknowns, by class.
    fn arms(&self, coordinates: &Coordinates, motion: &Motion, tag: &str) -> Vec<Arms> {
        let of_loop = |&closure: &usize| {
            let chain = &coordinates.closures[closure];
            let moving = chain.classes().into_iter().filter(|&class| self.moves(coordinates, closure, class));
            let moving: Vec<usize> = moving.collect();
            let arms = moving.into_iter().map(|class| {
                let arm = motion.whole_arm(chain, class);
                let names = ["x", "y"].map(|axis| format!("arm{tag}_{closure}_{class}_{axis}"));
                (class, [arm[0].named(&names[0]), arm[1].named(&names[1])])
            });
            arms.collect()
        };
        self.closures.iter().map(of_loop).collect()
    }

    /// Does the vector of a loop that turns with a class depend on the unknowns?
    fn moves(&self, coordinates: &Coordinates, closure: usize, class: usize) -> bool {
        let turns = coordinates.angle_of_class[class].is_some_and(|angle| self.unknowns.contains(&angle));
        let mut slides = coordinates.closures[closure].of_class(class).filter_map(|(slide, _)| slide);
        turns || slides.any(|slide| self.unknowns.contains(&slide))
    }

    /// The sum of all other vectors of each loop.
    fn known(&self, coordinates: &Coordinates, motion: &Motion) -> Vec<Vec2> {
        let of_loop = |&closure: &usize| {
            let chain = &coordinates.closures[closure];
            let mut sum = [Expr::ZERO; 2];
            for class in chain.classes() {
                if !self.moves(coordinates, closure, class) {
                    let arm = motion.whole_arm(chain, class);
                    sum = plane::add(sum, arm);
                }
            }
            let names = ["x", "y"].map(|axis| format!("loop_{closure}_{axis}"));
            [sum[0].named(&names[0]), sum[1].named(&names[1])]
        };
        self.closures.iter().map(of_loop).collect()
    }

    /// What the vectors of each loop sum to: zero at the solution.
    fn gap(&self, known: &[Vec2], arms: &[Arms], tag: &str) -> Vec<Vec2> {
        let of_loop = |((closure, known), arms): ((&usize, &Vec2), &Arms)| {
            let sum = arms.iter().fold(*known, |sum, (_, arm)| plane::add(sum, *arm));
            let names = ["x", "y"].map(|axis| format!("gap{tag}_{closure}_{axis}"));
            [sum[0].named(&names[0]), sum[1].named(&names[1])]
        };
        self.closures.iter().zip(known).zip(arms).map(of_loop).collect()
    }

    /// The Jacobian by the unknowns.
    fn jacobian(
        &self,
        coordinates: &Coordinates,
        motion: &Motion,
        (arms, name): (&[Arms], &str),
    ) -> Elimination<'_> {
        let of_loop = |(&closure, arms): (&usize, &Arms)| {
            let chain = &coordinates.closures[closure];
            let column = |&unknown: &usize| {
                if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
                    let arm = arms.iter().find(|(own, _)| *own == class);
                    return arm.map_or([Expr::ZERO; 2], |(_, arm)| plane::left(*arm));
                }
                let slide = chain.slide(unknown);
                slide.map_or([Expr::ZERO; 2], |(class, vector)| motion.turned(class, vector))
            };
            self.unknowns.iter().map(column).collect()
        };
        let columns = self.closures.iter().zip(arms).map(of_loop).collect();
        let name = format!("{name}_{}", self.closures.first().copied().unwrap_or(0));
        Elimination::new(&self.plan, columns, &name)
    }
}

/// Did the iteration converge?
fn is_closed(gap: &[Vec2], memory: &Memory, length: Expr) -> Expr {
    let Some(precision) = memory.precision() else { return Expr::ONE };
    let squares: Vec<Expr> = gap.iter().flatten().map(|&gap| gap.powi(2)).collect();
    let gap = algebra::sum(&squares);
    let units = Expr::from(CLOSED);
    let least = algebra::product(&[units, precision, length]);
    let least = least.powi(2);
    gap.less(least)
}

/// `axis` turned by the angle with half the tangent `tangent`; its length is kept to rounding.
fn rotated(axis: Vec2, tangent: Expr, name: &str) -> Vec2 {
    let tangent = tangent.named(format!("{name}_tangent"));
    let (one, square) = (Expr::ONE, tangent.powi(2));
    let (numerator, denominator) = (tangent + tangent, one + square);
    let sine = numerator / denominator;
    let sine = sine.named(format!("{name}_sine"));
    let [cos, sin] = axis;
    let (first, second) = (tangent * cos, tangent * sin);
    let (first, second) = (first + sin, cos - second);
    let (by_first, by_second) = (sine * first, sine * second);
    let (cos, sin) = (cos - by_first, sin + by_second);
    [cos.named(format!("{name}_cos")), sin.named(format!("{name}_sin"))]
}

/// `1 / n`.
fn fraction(n: i64) -> Expr {
    let whole = Expr::from(Number::from_int(n));
    whole.recip()
}
