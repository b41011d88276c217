//! Loops that are solved in closed form, in charts: which coordinates describe the mechanism, and on which of its mirror
//! images each loop is.
//!
//! A dyad has two solutions, which meet where its determinant vanishes. The determinant and its rates are remembered from
//! the last accepted state; a stage takes the solution whose determinant has the sign that they predict, so that a pose
//! where the solutions meet is passed as the motion passes it. After each accepted step, a chart whose worst dyad is
//! flat is left for one that is better by far, if there is one. So near to a flat pose that rounding would rule, what
//! cannot be computed there is interpolated from both sides.

mod beside;

pub use beside::{pose, rate_beside};

use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Accepted, System};
use crate::vector::Vector;

/// Below this a chart's measure is worth a look at the other charts: the smallest sine (RRR), cosine (RRP), or length
/// over that of the scene (RPR) of its dyads.
const FLAT: f64 = 0.3;
/// How much better another chart's measure must be.
const BETTER: f64 = 2.0;

/// Below this square of the measure a loop is open; what is nearer to zero may be a flat pose and rounding.
const OPEN: f64 = -1e-10;
/// The farthest that a body may turn between two looks, rad: its angle is known but for whole turns.
const FARTHEST: f64 = 1.0;
/// The farthest that a determinant near zero may be from its prediction, as a part of its size before and after.
const FARTHEST_AREA: f64 = 0.05;
/// How far a body, and by which part a determinant, should have moved until the next look.
const CALM: f64 = 0.06;
/// Place in the memory of the time of the last look.
const LAST: usize = 0;
/// Place of the time of the next one, which is followed by an angle, its cosine and its sine for each class of bodies.
const NEXT: usize = 1;

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
    /// Numbers in the memory before the determinants, each followed by its rate and half the rate of that.
    const BEFORE_AREAS: usize;
    /// The bodies whose angles are remembered, in that order.
    const TURNING: &'static [&'static str];
    /// By chart, by dyad: the part that closes its loop.
    const CLOSING: &'static [&'static [&'static str]];

    /// Pose and velocity of all bodies, and the square of the measure; negative where a loop cannot be closed.
    fn place(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q, Self::S);

    /// What is to be remembered of a state, and the square of the measure.
    fn look(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Memory, Self::S);

    /// The same of a pose and velocity in some chart.
    fn survey(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q) -> (Self::Memory, Self::S);

    /// Writes the coordinates of a chart and their rates; first-order states stay.
    fn project(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q, x: &mut Self::X);
}

/// The state in the best chart at a pose that closes the loops; the first chart if it is not flat.
pub fn enter<M: Charted>(system: &M, t: M::S, held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    let (_, first) = system.survey(0, t, q, v);
    let chart = if first < square(FLAT) { best(system, t, q, v).0 } else { 0 };
    change(system, t, held, (chart, q, v), x);
}

/// Remembers an accepted state, and leaves its chart if another one is better by far; not before something can have
/// changed that matters.
///
/// # Errors
/// When the loops cannot be closed there, or cannot have been followed so far.
#[inline]
pub fn accept<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> Result<Accepted, Fault> {
    if is_calm::<M>(t, held) {
        return Ok(Accepted::default());
    }
    let (mut memory, mut measure) = system.look(t, held, x);
    let since = t - held.memory.at(LAST);
    // False for what is not a number.
    let far = |k: usize| (M::S::lit(2.0) * since * memory.at(k + 1)).abs().lt(memory.at(k).abs());
    if !areas::<M>().all(far) {
        (memory, measure) = look_closely(system, t, held, x)?;
    }
    if measure < M::S::lit(OPEN).min(M::S::lit(-64.0) * M::S::EPSILON) {
        return Err(locked::<M>(t, held.chart, &memory));
    }
    let passed = remember::<M>(t, since, held, memory)?;
    let moved = M::CHARTS > 1 && measure < square(FLAT) && leave(system, t, held, measure, x);
    Ok(Accepted { moved, passed: if moved { None } else { passed } })
}

/// Whether [`accept`] has nothing to look at yet.
#[inline]
pub fn is_calm<M: Charted>(t: M::S, held: &M::U) -> bool {
    t < held.memory.at(NEXT)
}

/// Writes the memory of a state, with what two states tell together; the part that closes a loop which went through a
/// flat pose.
fn remember<M: Charted>(
    t: M::S,
    since: M::S,
    held: &mut M::U,
    mut memory: M::Memory,
) -> Result<Option<&'static str>, Fault> {
    let (old, zero) = (held.memory, M::S::lit(0.0));
    let (mut passed, mut turned) = (None, zero);
    for (body, k) in M::TURNING.iter().zip((NEXT + 1..M::BEFORE_AREAS).step_by(3)) {
        turned = turned.max((memory.at(k) - old.at(k)).abs());
        if turned > M::S::lit(FARTHEST) {
            return Err(Fault::of_part(t.to_f64(), body, Cause::TurnedTooFar { angle: turned.to_f64() }));
        }
    }
    // What has moved by so little since the last look does not move far in a like time.
    let mut calm = M::S::lit(CALM) / turned.max(M::S::lit(CALM / 1.5));
    for (dyad, k) in areas::<M>().enumerate() {
        let (area, change) = (memory.at(k), memory.at(k) - old.at(k));
        if old.at(k) * area < zero {
            passed = M::CLOSING.get(held.chart).and_then(|parts| parts.get(dyad)).copied();
        }
        calm = calm.min(M::S::lit(CALM) * area.abs() / change.abs());
        if since > zero {
            memory.set(k + 2, M::S::lit(0.5) * (memory.at(k + 1) - old.at(k + 1)) / since);
        }
    }
    memory.set(NEXT, if calm > zero { t + calm * since } else { t });
    held.memory = memory;
    Ok(passed)
}

/// Looks at a state near a flat pose, where the sign of a small determinant was predicted and its rate tells more.
///
/// The determinant and its rate are continuous, those of the mirror image are their negatives: after a step `h` the image
/// is taken for which `D_predicted D + h^2 D'_predicted D'` is positive.
#[cold]
fn look_closely<M: Charted>(
    system: &M,
    t: M::S,
    held: &mut M::U,
    x: &M::X,
) -> Result<(M::Memory, M::S), Fault> {
    let last = held.memory;
    let since = t - last.at(LAST);
    let predicted = |k: usize| {
        let (area, rate, bend) = (last.at(k), last.at(k + 1), last.at(k + 2));
        (area + (rate + bend * since) * since, rate + M::S::lit(2.0) * bend * since)
    };
    for k in areas::<M>() {
        let (now, _) = system.look(t, held, x);
        let (area, rate) = predicted(k);
        if area * now.at(k) + since * since * rate * now.at(k + 1) < M::S::lit(0.0) {
            let other = if now.at(k) < M::S::lit(0.0) { 1.0 } else { -1.0 };
            for (place, value) in [other, 0.0, 0.0].into_iter().enumerate() {
                held.memory.set(k + place, M::S::lit(value));
            }
        }
    }
    let (mut memory, measure) = system.look(t, held, x);
    held.memory = last;
    for k in areas::<M>() {
        let (area, rate) = predicted(k);
        if !memory.at(k + 1).is_finite() {
            memory.set(k + 1, rate);
        }
        let size = last.at(k).abs().max(memory.at(k).abs());
        if (memory.at(k) - area).abs() > M::S::lit(FARTHEST_AREA) * size {
            let cause = Cause::TurnedTooFar { angle: (since * rate / size).to_f64().abs() };
            return Err(Fault { cause, ..locked::<M>(t, held.chart, &memory) });
        }
    }
    if memory.is_finite() { Ok((memory, measure)) } else { Err(locked::<M>(t, held.chart, &memory)) }
}

/// Places of the determinants in the memory.
fn areas<M: Charted>() -> impl Iterator<Item = usize> {
    (M::BEFORE_AREAS..M::Memory::LEN).step_by(3)
}

/// The fault of the dyad of a chart whose determinant is nearest to zero.
fn locked<M: Charted>(t: M::S, chart: usize, memory: &M::Memory) -> Fault {
    let parts = M::CLOSING.get(chart).copied().unwrap_or_default();
    let (mut part, mut least) = ("", M::S::INFINITY);
    for (closing, k) in parts.iter().zip(areas::<M>()) {
        let area = memory.at(k).abs();
        if !least.lt(area) {
            (part, least) = (closing, area);
        }
    }
    Fault::of_part(t.to_f64(), part, Cause::Locked)
}

#[cold]
fn leave<M: Charted>(system: &M, t: M::S, held: &mut M::U, measure: M::S, x: &mut M::X) -> bool {
    let (q, v) = pose(system, t, held, x);
    let (chart, other) = best(system, t, &q, &v);
    let better = chart != held.chart && other > square::<M::S>(BETTER) * measure.max(M::S::lit(0.0));
    if better && q.is_finite() && v.is_finite() {
        change(system, t, held, (chart, &q, &v), x);
        return true;
    }
    false
}

/// The chart with the largest measure at a pose, and its square.
fn best<M: Charted>(system: &M, t: M::S, q: &M::Q, v: &M::Q) -> (usize, M::S) {
    let mut best = (0, system.survey(0, t, q, v).1);
    for chart in 1..M::CHARTS {
        let (_, measure) = system.survey(chart, t, q, v);
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
    held.memory = system.survey(chart, t, q, v).0;
    system.project(chart, t, q, v, x);
}

fn square<S: Scalar>(value: f64) -> S {
    S::lit(value * value)
}
