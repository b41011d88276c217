//! Loops that are solved in charts: which coordinates describe the mechanism, and on which of its mirror images each loop
//! is.
//!
//! A dyad has two solutions, which meet where its determinant vanishes. Which of them is meant is remembered as a sign, and
//! stays as it is: around a state that was looked at, the coordinates have a box in which no loop comes much nearer to
//! flat. A step that ends within it needs no look; one that ends far from it may have passed a flat pose, and is refused.
//! A chart whose worst dyad is flat is left for one that is better by far, if there is one. Where none is good, the
//! mechanism goes on without a chart ([`crate::singular`]).
//!
//! Loops without a closed form are solved by Newton's iteration from where their unknowns should be by the last accepted
//! state, so that these are followed as well: values, rates, and how the rates change.

mod memory;

use memory::{check_followed, check_near, flattest, keep, locked, precise};

use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::{Accepted, System};
use crate::vector::Vector;

/// Below this a chart's measure is worth a look at the other charts: the smallest sine (RRR), cosine (RRP), or length
/// over that of the scene (RPR) of its dyads.
const FLAT: f64 = 0.3;
/// How much better another chart's measure must be.
const BETTER: f64 = 2.0;
/// Below this measure no chart is good: rounding grows with its third power, to `1e-11` in the accelerations ...
const POOR: f64 = 0.03;
/// ... and to `1e-5` in single precision.
const POOR_SINGLE: f64 = 0.2;
/// By this factor a chart must be better than that, where the mechanism goes on in it.
const BACK: f64 = 1.3;

/// Below this square of the measure a loop is open; what is nearer to zero may be a flat pose and rounding.
const OPEN: f64 = -1e-10;
/// Below this part of what is typical, a box is that of a measure below [`FLAT`]: boxes are a tenth of it, and they share it.
const TIGHT: f64 = 0.1 * FLAT;

/// What is held over a step: the inputs, the chart, and what is remembered of the last state that was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<I, Y> {
    /// The inputs.
    pub input: I,
    /// The chart, from 0; [`Charted::CHARTS`] where there is none.
    pub chart: usize,
    /// In a chart: boxes of the coordinates and of the time, angles, determinants, unknowns of iterations. Without one: pose
    /// and velocity of all bodies.
    pub memory: Y,
}

/// A mechanism whose loops are solved in closed form; implemented by generated code.
///
/// The memory begins with two numbers for each coordinate, then for the time: where it was at the last look, and how far it
/// may move until the next one (negative where every state is looked at). Behind them stand an angle, its cosine and its sine for each class of bodies.
pub trait Charted: System<U = Held<Self::Input, Self::Memory>, S: Real> {
    /// The inputs.
    type Input: Copy;
    /// What is remembered.
    type Memory: Vector<Self::S>;
    /// Pose or velocity of all bodies.
    type Q: Vector<Self::S>;
    /// Number of charts.
    const CHARTS: usize;
    /// Numbers in the memory before the determinants.
    const BEFORE_AREAS: usize;
    /// The bodies whose angles are remembered, in that order.
    const TURNING: &'static [&'static str];
    /// Numbers in the memory before the unknowns of iterations, each followed by its rate and half the rate of that: rad, or
    /// of displacements over the size of the scene. Behind them stands a unit in the last place.
    const BEFORE_FOLLOWED: usize;
    /// The bodies and joints of these unknowns, in that order.
    const FOLLOWED: &'static [&'static str];
    /// By chart, by group: the part that closes its loop.
    const CLOSING: &'static [&'static [&'static str]];

    /// Pose and velocity of all bodies, and the square of the measure; negative where a loop cannot be closed.
    fn pose(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q, Self::S);

    /// What is to be remembered of a state, and the square of the measure.
    fn remember(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Memory, Self::S);

    /// The same of a pose and velocity in some chart, but for how far the coordinates may move.
    fn remember_pose(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q) -> (Self::Memory, Self::S);

    /// Writes the coordinates of a chart and their rates; first-order states stay.
    fn project(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q, x: &mut Self::X);
}

/// The state in the best chart at a pose that closes the loops; the first chart if it is not flat, none if all are.
pub fn enter<M: Charted>(system: &M, t: M::S, held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    let (_, first) = system.remember_pose(0, t, q, v);
    let (chart, measure) = if first < square(FLAT) { best(system, t, q, v) } else { (0, first) };
    if measure < regular() {
        free::<M>(held, (q, v), x);
    } else {
        change(system, t, held, (chart, q, v), x);
    }
}

/// Has the mechanism no chart?
#[inline]
pub fn is_free<M: Charted>(held: &M::U) -> bool {
    held.chart >= M::CHARTS
}

/// Pose and velocity of all bodies.
pub fn pose<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> (M::Q, M::Q) {
    if is_free::<M>(held) {
        return (Vector::from_fn(|i| held.memory.at(i)), Vector::from_fn(|i| held.memory.at(M::Q::LEN + i)));
    }
    let (q, v, _) = system.pose(t, held, x);
    (q, v)
}

/// The state in absolute coordinates, [q, v, first-order states].
pub fn full<M: Charted, const N: usize>(system: &M, t: M::S, held: &M::U, x: &M::X) -> [M::S; N] {
    let (q, v) = pose(system, t, held, x);
    let nq = M::Q::LEN;
    Vector::from_fn(|i| match i {
        _ if i < nq => q.at(i),
        _ if i < 2 * nq => v.at(i - nq),
        _ => x.at(2 * M::NQ + i - 2 * nq),
    })
}

/// Holds a state in absolute coordinates, without a chart.
pub fn hold<M: Charted, const N: usize>(held: &mut M::U, x: &mut M::X, full: &[M::S; N]) {
    let nq = M::Q::LEN;
    let (q, v) = (M::Q::from_fn(|i| full.at(i)), M::Q::from_fn(|i| full.at(nq + i)));
    free::<M>(held, (&q, &v), x);
    for i in 2 * nq..N {
        x.set(2 * M::NQ + i - 2 * nq, full.at(i));
    }
}

/// Remembers an accepted state, and leaves its chart if another one is better by far, or if it is not good; not before
/// something can have changed that matters.
///
/// # Errors
/// When the loops cannot be closed there, or cannot have been followed so far.
#[inline]
pub fn accept<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> Result<Accepted, Fault> {
    if is_calm::<M>(t, held, x) {
        return Ok(Accepted::default());
    }
    let moved = if is_free::<M>(held) { come_back(system, t, held, x) } else { watch(system, t, held, x)? };
    Ok(Accepted { moved, passed: None })
}

/// Whether [`accept`] has nothing to look at yet.
#[inline]
pub fn is_calm<M: Charted>(t: M::S, held: &M::U, x: &M::X) -> bool {
    let within = |moved: M::S, k: usize| moved.abs() < held.memory.at(2 * k + 1);
    M::FOLLOWED.is_empty()
        && !is_free::<M>(held)
        && (0..M::NQ).all(|k| within(x.at(k) - held.memory.at(2 * k), k))
        && within(t - held.memory.at(2 * M::NQ), M::NQ)
}

/// Is a step too long for what may be a sharp turn near a flat pose, which no error control resolves? One that changes the
/// measure by a tenth, where it is small.
#[inline]
pub fn is_sharp<M: Charted>(system: &M, t: M::S, held: &M::U, before: &M::X, x: &M::X) -> bool {
    let tight = |k: usize| M::S::lit(TIGHT / M::NQ as f64) * system.typical().at(k);
    !is_free::<M>(held)
        && (0..M::NQ).any(|k| {
            let reach = held.memory.at(2 * k + 1);
            (x.at(k) - before.at(k)).abs() > reach && reach < tight(k)
        })
        && !is_calm::<M>(t, held, x)
}

/// A fault for a state at which the rate cannot be computed in the chart that is held.
#[cold]
pub fn not_regular<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> Fault {
    locked::<M>(t, held, &system.remember(t, held, x).0)
}

/// Looks at a state; whether its chart was left.
fn watch<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> Result<bool, Fault> {
    let (memory, measure) = system.remember(t, held, x);
    if is_open(measure) || !memory.is_finite() {
        return Err(locked::<M>(t, held, &memory));
    }
    check_followed::<M>(t, held, &memory, measure)?;
    check_near::<M>(t, held, &memory)?;
    keep::<M>(t, held, memory)?;
    if measure < square(FLAT) {
        return Ok(leave(system, t, held, measure, x));
    }
    Ok(false)
}

/// Can a loop not be closed at all?
fn is_open<S: Real>(measure: S) -> bool {
    // False for what is not a number.
    let closes = measure >= S::lit(OPEN).min(S::lit(-64.0) * S::EPSILON);
    !closes
}

/// The square of the measure above which a chart is good.
fn regular<S: Real>() -> S {
    square(if S::EPSILON < S::lit(1e-12) { POOR } else { POOR_SINGLE })
}

/// The part that closes the loop which is nearest to flat at a pose.
pub fn flat_part<M: Charted>(system: &M, t: M::S, q: &M::Q, v: &M::Q) -> &'static str {
    flattest::<M>(0, &system.remember_pose(0, t, q, v).0)
}

/// Leaves a chart for one that is better by far, or if it is not good.
#[cold]
fn leave<M: Charted>(system: &M, t: M::S, held: &mut M::U, measure: M::S, x: &mut M::X) -> bool {
    let (q, v, _) = system.pose(t, held, x);
    if !(q.is_finite() && v.is_finite()) {
        return false;
    }
    let (chart, other) = if M::CHARTS > 1 { best(system, t, &q, &v) } else { (held.chart, measure) };
    if chart != held.chart && other > square::<M::S>(BETTER) * measure && other > regular() {
        change(system, t, held, (chart, &q, &v), x);
        return true;
    }
    let poor = measure < regular();
    if poor {
        free::<M>(held, (&q, &v), x);
    }
    poor
}

/// Goes on in a chart where one is good again.
#[cold]
fn come_back<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> bool {
    let (q, v) = pose(system, t, held, x);
    let (chart, measure) = best(system, t, &q, &v);
    if measure < square::<M::S>(BACK) * regular() {
        return false;
    }
    let (alone, rest) = (*held, *x);
    change(system, t, held, (chart, &q, &v), x);
    // Lengths that repeat each other may disagree in what a pose does not tell.
    let closed = !is_open(system.remember(t, held, x).1);
    if !closed {
        (*held, *x) = (alone, rest);
    }
    closed
}

/// Goes on without a chart.
fn free<M: Charted>(held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    held.chart = M::CHARTS;
    for i in 0..M::Q::LEN {
        held.memory.set(i, q.at(i));
        held.memory.set(M::Q::LEN + i, v.at(i));
    }
    for i in 0..2 * M::NQ {
        x.set(i, M::S::lit(0.0));
    }
}

/// The chart with the largest measure at a pose, and its square.
fn best<M: Charted>(system: &M, t: M::S, q: &M::Q, v: &M::Q) -> (usize, M::S) {
    let mut best = (0, system.remember_pose(0, t, q, v).1);
    for chart in 1..M::CHARTS {
        let (_, measure) = system.remember_pose(chart, t, q, v);
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
    held.memory = precise::<M>(system.remember_pose(chart, t, q, v).0);
    system.project(chart, t, q, v, x);
    let (memory, measure) = system.remember(t, held, x);
    if !is_open(measure) && memory.is_finite() {
        held.memory = precise::<M>(memory);
    }
}

fn square<S: Scalar>(value: f64) -> S {
    S::lit(value * value)
}
