//! Loops that are solved in charts: which coordinates describe the mechanism, and on which of its mirror images each loop
//! is.
//!
//! A dyad has two solutions, which meet where its determinant vanishes. The sign of the determinant is stored and selects one of them. It
//! stays valid near a checked state: each coordinate has an interval in which no loop comes much nearer to a flat pose. A step that ends
//! within the intervals needs no check; one that ends far outside may have passed a flat pose, and is refused. A chart whose worst dyad is
//! flat is left for one that is better by far, if there is one. If no chart is good, the mechanism goes on without one
//! ([`crate::singular`]).
//!
//! Loops without a closed form are solved by Newton's iteration from where their unknowns should be by the last accepted
//! state, so that these are followed as well: values, rates, and how the rates change.

mod constants;
mod continuation;
mod continuity;
mod lanes;
mod revolutions;
mod words;

pub use constants::Constants;
pub use continuation::{Angle, Continuation, ContinuationData, Iterated, OfLoops, Reach};
pub use continuity::not_regular;
use continuity::{Looks, flattest};
pub use lanes::{are_calm, are_short, look};
pub use revolutions::Revolutions;
use revolutions::{are_due, unwind};

use crate::fault::Fault;
use crate::held::Held;
use crate::scalar::{Real, Scalar};
use crate::system::{Step, System, Updated};
use crate::tolerances::{BACK, BETTER, BOXES, FLAT, OPEN, PROBE, regular_chart, tight};
use crate::vector::Vector;

/// A mechanism whose loops are solved in closed form; implemented by generated code.
pub trait Charted:
    System<
        U = Held<
            Self::Input,
            Self::Switches,
            Self::Turns,
            OfLoops<Self::Continuation, Self::Q>,
            Self::Contact,
        >,
        S: Real,
    >
{
    /// The inputs.
    type Input: Copy;
    /// The sides of the switches.
    type Switches: Copy;
    /// Revolutions, by count.
    type Turns: Copy + AsMut<[i32]>;
    /// Discrete state of the contact rows.
    type Contact: Copy;
    /// Continuation data, a [`Continuation`].
    type Continuation: ContinuationData<Self::S>;
    /// Pose or velocity of all bodies.
    type Q: Vector<Self::S>;
    /// The charts of all mechanisms of this type.
    const CHARTS: Charts;

    /// The charts.
    #[inline]
    fn charts(&self) -> &'static Charts {
        const { &Self::CHARTS }
    }

    /// True if the mechanism has charts: always of a type that has some, and by value of one from text.
    #[inline]
    fn has_charts(&self) -> bool {
        true
    }

    /// Pose and velocity of all bodies, and the square of the measure; negative where a loop cannot be closed, zero without a
    /// chart.
    fn pose(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q, Self::S);

    /// The continuation data of a state, and the square of the measure; nothing and zero without a chart.
    fn continuation(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Continuation, Self::S);

    /// Continuation data at a pose and velocity in some chart, without how far the coordinates may move.
    fn continuation_at(
        &self,
        chart: usize,
        t: Self::S,
        q: &Self::Q,
        v: &Self::Q,
    ) -> (Self::Continuation, Self::S);

    /// Writes the coordinates of a chart and their rates; first-order states stay.
    fn to_chart(&self, chart: usize, t: Self::S, q: &Self::Q, v: &Self::Q, x: &mut Self::X);
}

/// Constants of the charts of a mechanism, for every state.
#[derive(Clone, Copy, Debug)]
pub struct Charts {
    /// Number of charts.
    pub count: usize,
    /// The angles of each count of revolutions.
    pub revolutions: &'static [Revolutions],
    /// True if a coordinate whose revolutions are counted moves no loop: how far it has turned is then checked in every step.
    pub is_loose: bool,
    /// The bodies whose angles are continued, in the order of the data.
    pub turning: &'static [&'static str],
    /// By chart: indices of those angles that loops give, known but for whole revolutions.
    pub found: &'static [&'static [usize]],
    /// The bodies and joints of the unknowns of iterations, in the order of the data.
    pub iterated: &'static [&'static str],
    /// By chart, by group: the part that closes its loop.
    pub closing: &'static [&'static [&'static str]],
}

/// The state in the best chart at a pose that closes the loops; the first chart if it is not flat, none if all are.
pub fn enter<M: Charted>(system: &M, t: M::S, held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    let (_, first) = system.continuation_at(0, t, q, v);
    let (chart, measure) = if first < square(FLAT.get()) { best(system, t, q, v) } else { (0, first) };
    if measure < regular_chart() {
        free::<M>(held, (q, v), x);
    } else {
        change(system, t, held, (chart, q, v), x);
    }
}

/// Has the mechanism no chart?
#[inline]
pub fn is_free<M: Charted>(held: &M::U) -> bool {
    matches!(held.of_loops, OfLoops::Free { .. })
}

/// Pose and velocity of all bodies.
pub fn pose<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> (M::Q, M::Q) {
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

/// Stores the continuation data of an accepted state, and leaves its chart if another one is better by far, or if it is not good. It does
/// nothing as long as the state is within its intervals.
///
/// # Errors
/// When the loops cannot be closed there, or cannot have been followed so far.
#[inline]
pub fn update<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> Result<Updated, Fault> {
    if is_calm(system, t, held, x) {
        return Ok(Updated::default());
    }
    match held.of_loops {
        OfLoops::InChart { chart, continuation } => watch(system, t, held, (chart, &continuation), x),
        OfLoops::Free { .. } => Ok(Updated { moved: come_back(system, t, held, x), ..Updated::default() }),
    }
}

/// True if [`update`] has nothing to check yet.
#[inline]
pub fn is_calm<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> bool {
    let OfLoops::InChart { continuation, .. } = &held.of_loops else { return false };
    let quiet = |k: usize, at: &Reach<M::S>| {
        let ample = M::S::lit(BOXES.get() * tight() / system.coordinates() as f64) * system.typical_at(k);
        let reach = if at.reach < ample { at.reach } else { BOXES.of::<M::S>() * at.reach };
        Reach { reach, ..*at }.holds(x.at(k))
    };
    let charts = system.charts();
    charts.iterated.is_empty()
        && continuation.coordinates().iter().enumerate().all(|(k, at)| quiet(k, at))
        && continuation.time().holds(t)
        && !(charts.is_loose && are_due::<M>(charts, held, x))
}

/// Largest part of its interval that a coordinate has crossed in a step; zero if all loops are far from flat poses.
///
/// Half an interval is a tenth of the distance on which the measure changes by its own size, so that the result compares the length of a
/// step with that of the turn that it follows. A coordinate that reverses has gone farther than the ends of the step show: it reverses in
/// each flat pose.
#[inline]
pub fn crossed<M: Charted>(step: &Step<'_, M>) -> M::S {
    let OfLoops::InChart { continuation, .. } = &step.held.of_loops else { return M::S::ZERO };
    let (system, (t0, before), (t1, x)) = (step.system, step.from, step.to);
    let tight = |k: usize| M::S::lit(tight() / system.coordinates() as f64) * system.typical_at(k);
    continuation.coordinates().iter().enumerate().fold(M::S::ZERO, |most, (k, &Reach { reach, .. })| {
        if reach < tight(k) { most.max(way::<M>(t1 - t0, [before, x], k) / reach) } else { most }
    })
}

/// The distance that a coordinate covers in a step of this length, by its values and rates at both ends: the change, or if it reverses, at
/// least the distance to or from the point of reversal.
#[cold]
#[inline(never)]
fn way<M: Charted>(h: M::S, [before, x]: [&M::X; 2], k: usize) -> M::S {
    let (moved, v0, v1) = ((x.at(k) - before.at(k)).abs(), before.at(M::NQ + k), x.at(M::NQ + k));
    let (fastest, both) = (v0.abs().max(v1.abs()), v0.abs() + v1.abs());
    if v0 * v1 < M::S::ZERO { moved.max(fastest * fastest * h.abs() / (both + both)) } else { moved }
}

/// Checks a state that continues the stored data in a chart; the chart may be left.
fn watch<M: Charted>(
    system: &M,
    t: M::S,
    held: &mut M::U,
    (chart, before): (usize, &M::Continuation),
    x: &mut M::X,
) -> Result<Updated, Fault> {
    let (after, measure) = system.continuation(t, held, x);
    let looks = Looks { system, t, chart, before, after: &after };
    if is_open(measure) || !after.is_finite() {
        return Err(looks.locked());
    }
    looks.check_iterated(measure)?;
    looks.check_near()?;
    held.of_loops = OfLoops::InChart { chart, continuation: looks.updated()? };
    let turned = unwind::<M>(system.charts(), held, x);
    let moved = measure < square(FLAT.get()) && leave(system, t, held, (chart, measure), x);
    Ok(Updated { moved, turned, passed: None })
}

/// Can a loop not be closed at all?
fn is_open<S: Real>(measure: S) -> bool {
    // False for NaN.
    let closes = measure >= S::lit(-OPEN.get()).min(S::lit(-64.0) * S::EPSILON);
    !closes
}

/// The part that closes the loop which is nearest to flat at a pose.
pub fn flat_part<M: Charted>(system: &M, t: M::S, q: &M::Q, v: &M::Q) -> &'static str {
    flattest(system, 0, &system.continuation_at(0, t, q, v).0)
}

/// Leaves a chart for one that is better by far, or if it is not good.
#[cold]
fn leave<M: Charted>(
    system: &M,
    t: M::S,
    held: &mut M::U,
    (own, measure): (usize, M::S),
    x: &mut M::X,
) -> bool {
    let (q, v, _) = system.pose(t, held, x);
    if !(q.is_finite() && v.is_finite()) {
        return false;
    }
    let (chart, other) = if system.charts().count > 1 { best(system, t, &q, &v) } else { (own, measure) };
    if chart != own && other > square::<M::S>(BETTER.get()) * measure && other > regular_chart() {
        change(system, t, held, (chart, &q, &v), x);
        return true;
    }
    let is_flat = measure < regular_chart();
    if is_flat {
        free::<M>(held, (&q, &v), x);
    }
    is_flat
}

/// Goes on in a chart where one is good again.
#[cold]
fn come_back<M: Charted>(system: &M, t: M::S, held: &mut M::U, x: &mut M::X) -> bool {
    let (q, v) = pose(system, t, held, x);
    let (chart, measure) = best(system, t, &q, &v);
    if measure < square::<M::S>(BACK.get()) * regular_chart() {
        return false;
    }
    let (alone, rest) = (*held, *x);
    change(system, t, held, (chart, &q, &v), x);
    // Redundant lengths may disagree in a way that a pose does not show.
    let closed = !is_open(system.continuation(t, held, x).1);
    if !closed {
        (*held, *x) = (alone, rest);
    }
    closed
}

/// Goes on without a chart.
fn free<M: Charted>(held: &mut M::U, (q, v): (&M::Q, &M::Q), x: &mut M::X) {
    held.of_loops = OfLoops::Free { q: *q, v: *v };
    for i in 0..2 * M::NQ {
        x.set(i, M::S::lit(0.0));
    }
}

/// The chart with the largest measure at a pose, and its square.
fn best<M: Charted>(system: &M, t: M::S, q: &M::Q, v: &M::Q) -> (usize, M::S) {
    let mut best = (0, system.continuation_at(0, t, q, v).1);
    for chart in 1..system.charts().count {
        let (_, measure) = system.continuation_at(chart, t, q, v);
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
    held.of_loops = OfLoops::InChart { chart, continuation: system.continuation_at(chart, t, q, v).0 };
    system.to_chart(chart, t, q, v, x);
    let (mut continuation, measure) = system.continuation(t, held, x);
    if is_open(measure) || !continuation.is_finite() {
        return;
    }
    held.of_loops = OfLoops::InChart { chart, continuation };
    if !system.charts().iterated.is_empty() {
        let after = system.continuation(t, held, &probe(system, &continuation, x)).0;
        continuation.narrow(Looks { system, t, chart, before: &continuation, after: &after }.narrowed());
        held.of_loops = OfLoops::InChart { chart, continuation };
    }
}

/// A state a little ahead.
fn probe<M: Charted>(system: &M, continuation: &M::Continuation, x: &M::X) -> M::X {
    let mut probe = *x;
    for (k, at) in continuation.coordinates().iter().enumerate() {
        let by = PROBE.of::<M::S>() * at.reach.min(system.typical_at(k));
        probe.set(k, x.at(k) + if x.at(M::NQ + k) < M::S::ZERO { -by } else { by });
    }
    probe
}

fn square<S: Scalar>(value: f64) -> S {
    S::lit(value * value)
}
