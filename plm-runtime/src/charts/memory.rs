//! What is remembered of the last state that was looked at, and whether the next one can have come from it.

use crate::charts::{Charted, square};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// A state may be so many times as far from the last look as it may be without one: at 10, a loop could be flat.
const FAR: f64 = 7.0;
/// The farthest that a body may turn between two looks, rad: its angle is known but for whole turns.
const FARTHEST: f64 = 1.0;
/// The farthest that an unknown of an iteration may be from where the rates before and after take it, as a part of the
/// measure; other solutions are at least about twice the measure away.
const FARTHEST_FOLLOWED: f64 = 0.25;
/// Up to this distance an iteration that does not converge has no solution to find.
const NEAR: f64 = 0.1;
/// Below this square the measure does not narrow that any further.
const NARROWEST: f64 = 1e-4;

/// Is the state so near to the last one that was looked at that no loop can have gone through a flat pose? What the
/// distances tell of it at one of the two is enough; for the time it must hold at both.
pub(super) fn check_near<M: Charted>(t: M::S, held: &M::U, memory: &M::Memory) -> Result<(), Fault> {
    let old = &held.memory;
    let moved = |k: usize| (memory.at(2 * k) - old.at(2 * k)).abs();
    let reach = |k: usize| [old, memory].map(|at| M::S::lit(FAR) * at.at(2 * k + 1).abs());
    let within = (0..M::NQ).all(|k| {
        let [before, after] = reach(k);
        moved(k) <= before.max(after)
    });
    let [before, after] = reach(M::NQ);
    if within && moved(M::NQ) <= before.min(after) {
        return Ok(());
    }
    let angle = turned::<M>(held, memory).0.to_f64();
    Err(Fault { cause: Cause::TurnedTooFar { angle }, ..locked::<M>(t, held, memory) })
}

/// Are the unknowns of iterations where their rates have taken them, and not at another solution?
#[inline]
pub(super) fn check_followed<M: Charted>(
    t: M::S,
    held: &M::U,
    memory: &M::Memory,
    measure: M::S,
) -> Result<(), Fault> {
    let half = M::S::lit(0.5) * (t - last::<M>(held));
    let farthest = square::<M::S>(FARTHEST_FOLLOWED) * measure.max(M::S::lit(NARROWEST));
    for (part, k) in M::FOLLOWED.iter().zip(followed::<M>()) {
        let moved = memory.at(k) - held.memory.at(k);
        let off = moved - half * (memory.at(k + 1) + held.memory.at(k + 1));
        // False for what is not a number.
        let near = off * off < farthest;
        if !near {
            return Err(Fault::of_part(
                t.to_f64(),
                part,
                Cause::TurnedTooFar { angle: moved.to_f64().abs() },
            ));
        }
    }
    Ok(())
}

/// The time of the last look.
fn last<M: Charted>(held: &M::U) -> M::S {
    held.memory.at(2 * M::NQ)
}

/// The farthest that a body has turned since the last look, rad, and which one.
fn turned<M: Charted>(held: &M::U, memory: &M::Memory) -> (M::S, &'static str) {
    let mut most = (M::S::lit(0.0), "");
    for (body, k) in M::TURNING.iter().zip((2 * M::NQ + 2..M::BEFORE_AREAS).step_by(3)) {
        let turned = (memory.at(k) - held.memory.at(k)).abs();
        if turned > most.0 {
            most = (turned, body);
        }
    }
    most
}

/// Writes the memory of a state, with what two states tell together.
pub(super) fn keep<M: Charted>(t: M::S, held: &mut M::U, mut memory: M::Memory) -> Result<(), Fault> {
    let (angle, body) = turned::<M>(held, &memory);
    if angle > M::S::lit(FARTHEST) {
        return Err(Fault::of_part(t.to_f64(), body, Cause::TurnedTooFar { angle: angle.to_f64() }));
    }
    let since = t - last::<M>(held);
    for k in followed::<M>() {
        if since > M::S::lit(0.0) {
            memory.set(k + 2, M::S::lit(0.5) * (memory.at(k + 1) - held.memory.at(k + 1)) / since);
        }
    }
    held.memory = precise::<M>(memory);
    Ok(())
}

/// Places in the memory of the unknowns of iterations.
fn followed<M: Charted>() -> impl Iterator<Item = usize> {
    (0..M::FOLLOWED.len()).map(|k| M::BEFORE_FOLLOWED + 3 * k)
}

/// A memory with what iterations need to know of the arithmetic.
pub(super) fn precise<M: Charted>(mut memory: M::Memory) -> M::Memory {
    if !M::FOLLOWED.is_empty() {
        memory.set(M::BEFORE_FOLLOWED + 3 * M::FOLLOWED.len(), M::S::EPSILON);
    }
    memory
}

/// The fault of the group of a chart that is nearest to not being closed.
pub(super) fn locked<M: Charted>(t: M::S, held: &M::U, memory: &M::Memory) -> Fault {
    let moved = expected_move::<M>(t, held);
    let angle = moved.to_f64();
    let cause = if moved > M::S::lit(NEAR) { Cause::TurnedTooFar { angle } } else { Cause::Locked };
    Fault::of_part(t.to_f64(), flattest::<M>(held.chart, memory), cause)
}

/// The part that closes the loop of a chart with the smallest determinant.
pub(super) fn flattest<M: Charted>(chart: usize, memory: &M::Memory) -> &'static str {
    let parts = M::CLOSING.get(chart).copied().unwrap_or_default();
    let (mut part, mut least) = ("", M::S::INFINITY);
    for (closing, k) in parts.iter().zip(M::BEFORE_AREAS..M::BEFORE_FOLLOWED) {
        let area = memory.at(k).abs();
        if !least.lt(area) {
            (part, least) = (closing, area);
        }
    }
    part
}

/// How far the unknowns of iterations should have moved since the last look.
fn expected_move<M: Charted>(t: M::S, held: &M::U) -> M::S {
    let since = t - last::<M>(held);
    let rate = |k: usize| held.memory.at(k + 1) + held.memory.at(k + 2) * since;
    followed::<M>().map(|k| (rate(k) * since).abs()).fold(M::S::lit(0.0), M::S::max)
}
