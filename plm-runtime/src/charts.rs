//! Loops that are solved in closed form, in charts: which coordinates describe the mechanism, and on which of its mirror
//! images each loop is.
//!
//! A dyad has two solutions, which meet where its determinant vanishes. The determinant and its rate are remembered from
//! the last accepted state; a stage takes the solution whose determinant has the sign that they predict, so that a pose
//! where the solutions meet is passed as the motion passes it. After each accepted step, a chart whose worst dyad is
//! flat is left for one that is better by far, if there is one.

use crate::scalar::{Real, Scalar};
use crate::system::{Accepted, System};
use crate::vector::Vector;

/// Below this a chart's measure is worth a look at the other charts: the smallest sine (RRR), cosine (RRP), or length
/// over that of the scene (RPR) of its dyads.
const FLAT: f64 = 0.3;
/// How much better another chart's measure must be.
const BETTER: f64 = 2.0;

/// What is held over a step: the inputs, the chart, and what is remembered of the last state that was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<I, Y> {
    /// The inputs.
    pub input: I,
    /// The chart, from 0.
    pub chart: usize,
    /// Time, angles, determinants and their rates.
    pub memory: Y,
}

/// A mechanism whose loops are solved in closed form; implemented by generated code.
pub trait Charted: System<U = Held<Self::Input, Self::Memory>, S: Real> {
    /// The inputs.
    type Input: Copy;
    /// What is remembered.
    type Memory: Vector<Self::S>;
    /// Pose or velocity of all bodies.
    type Q: Vector<Self::S>;
    /// Number of charts.
    const CHARTS: usize;
    /// Numbers in the memory before the determinants, each followed by its rate.
    const BEFORE_AREAS: usize;

    /// Pose and velocity of all bodies.
    fn place(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q);

    /// What is to be remembered of a state, and the square of its measure; negative where a loop cannot be closed.
    fn look(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Memory, Self::S);

    /// The same of a pose in some chart, with determinants at rest.
    fn survey(&self, chart: usize, t: Self::S, q: &Self::Q) -> (Self::Memory, Self::S);

    /// Writes the coordinates of a chart and their rates; first-order states stay.
    fn project(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q, x: &mut Self::X);
}

/// The state in the best chart at a pose that closes the loops; the first chart if it is not flat.
pub fn enter<M: Charted>(system: &M, t: M::S, held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    let (_, first) = system.survey(0, t, q);
    let chart = if first < square(FLAT) { best(system, t, q).0 } else { 0 };
    change(system, t, held, (chart, q, v), x);
}

/// Remembers an accepted state, and leaves its chart if another one is better by far.
#[inline]
pub fn accept<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> Accepted {
    let (memory, measure) = system.look(t, held, x);
    let mirrored = |k: usize| held.memory.at(k) * memory.at(k) < M::S::lit(0.0);
    let passed = (M::BEFORE_AREAS..M::Memory::LEN).step_by(2).any(mirrored);
    if memory.is_finite() {
        held.memory = memory;
    }
    let moved = M::CHARTS > 1 && measure < square(FLAT) && leave(system, t, held, measure, x);
    Accepted { moved, passed: passed && !moved }
}

#[cold]
fn leave<M: Charted>(system: &M, t: M::S, held: &mut M::U, measure: M::S, x: &mut M::X) -> bool {
    let (q, v) = system.place(t, held, x);
    let (chart, other) = best(system, t, &q);
    let better = chart != held.chart && other > square::<M::S>(BETTER) * measure.max(M::S::lit(0.0));
    if better && q.is_finite() && v.is_finite() {
        change(system, t, held, (chart, &q, &v), x);
        return true;
    }
    false
}

/// The chart with the largest measure at a pose, and its square.
fn best<M: Charted>(system: &M, t: M::S, q: &M::Q) -> (usize, M::S) {
    let mut best = (0, system.survey(0, t, q).1);
    for chart in 1..M::CHARTS {
        let (_, measure) = system.survey(chart, t, q);
        if best.1 < measure {
            best = (chart, measure);
        }
    }
    best
}

fn change<M: Charted>(
    system: &M,
    t: M::S,
    held: &mut M::U,
    (chart, q, v): (usize, &M::Q, &M::Q),
    x: &mut M::X,
) {
    held.chart = chart;
    held.memory = system.survey(chart, t, q).0;
    system.project(chart, t, q, v, x);
    let (memory, _) = system.look(t, held, x);
    if memory.is_finite() {
        held.memory = memory;
    }
}

fn square<S: Scalar>(value: f64) -> S {
    S::lit(value * value)
}
