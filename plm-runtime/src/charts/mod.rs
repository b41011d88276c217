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

mod continuation;
mod continuity;
mod lanes;
mod revolutions;
mod words;

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
    /// Whole turns, by count.
    type Turns: Copy + AsMut<[i32]>;
    /// What is held of the contact rows.
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

    /// Pose and velocity of all bodies, and the square of the measure; negative where a loop cannot be closed, zero without a
    /// chart.
    fn pose(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Q, Self::Q, Self::S);

    /// The continuation data of a state, and the square of the measure; nothing and zero without a chart.
    fn continuation(&self, t: Self::S, held: &Self::U, x: &Self::X) -> (Self::Continuation, Self::S);

    /// The same of a pose and velocity in some chart, but for how far the coordinates may move.
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

/// What charts hold, whatever the state.
#[derive(Clone, Copy, Debug)]
pub struct Charts {
    /// Number of charts.
    pub count: usize,
    /// The angles of each count of turns.
    pub revolutions: &'static [Revolutions],
    /// A coordinate whose turns are counted moves no loop: how far it goes is looked at in every step.
    pub is_loose: bool,
    /// The bodies whose angles are continued, in the order of the data.
    pub turning: &'static [&'static str],
    /// By chart, by place among those angles, which of them loops give: known but for whole turns.
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

/// Remembers an accepted state, and leaves its chart if another one is better by far, or if it is not good; not before
/// something can have changed that matters.
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

/// Whether [`update`] has nothing to look at yet.
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

/// How much of its box a coordinate has crossed in a step, the most of all; zero where all loops are far from flat.
///
/// A box is a tenth of the way on which the measure changes by its own size, so that this tells how long a step is beside the
/// turn that it follows. A coordinate that turns back has gone farther than the ends of the step say: it turns back in each flat pose.
#[inline]
pub fn crossed<M: Charted>(step: &Step<'_, M>) -> M::S {
    let OfLoops::InChart { continuation, .. } = &step.held.of_loops else { return M::S::ZERO };
    let system = step.system;
    let tight = |k: usize| M::S::lit(tight() / system.coordinates() as f64) * system.typical_at(k);
    continuation.coordinates().iter().enumerate().fold(M::S::ZERO, |most, (k, &Reach { reach, .. })| {
        if reach < tight(k) { most.max(way(step, k) / reach) } else { most }
    })
}

/// The way of a coordinate in a step, by its places and rates at both ends: to the place at which it turns back, or from there.
#[cold]
#[inline(never)]
fn way<M: Charted>(step: &Step<'_, M>, k: usize) -> M::S {
    let ((t0, before), (t1, x)) = (step.from, step.to);
    let (moved, v0, v1) = ((x.at(k) - before.at(k)).abs(), before.at(M::NQ + k), x.at(M::NQ + k));
    let (fastest, both) = (v0.abs().max(v1.abs()), v0.abs() + v1.abs());
    if v0 * v1 < M::S::ZERO { moved.max(fastest * fastest * (t1 - t0).abs() / (both + both)) } else { moved }
}

/// Looks at a state that has come from what is remembered in a chart; the chart may be left.
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
    // False for what is not a number.
    let closes = measure >= S::lit(-OPEN.get()).min(S::lit(-64.0) * S::EPSILON);
    !closes
}

/// The name of a coordinate or its rate in the chart that is held, of `count` names for each chart; none of other states, and
/// without a chart.
pub fn name_of<M: Charted>(
    held: &M::U,
    index: usize,
    (names, count): (&[&'static str], usize),
) -> Option<&'static str> {
    match held.of_loops {
        OfLoops::InChart { chart, .. } if index < count => names.get(chart * count + index).copied(),
        _ => None,
    }
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
    // Lengths that repeat each other may disagree in what a pose does not tell.
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
