//! Continuity check: could a state have come from the last checked one, and the continuation data that both give together.

use crate::charts::{Charted, ContinuationData, OfLoops, square};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::tolerances::{
    BOX, FAR, FARTHEST, FARTHEST_ITERATED, NARROWEST_BOX, NOTICED, UNREACHED, narrowest_square,
};

/// The continuation data of the last checked state in a chart, and of the state at the time `t`.
pub(super) struct Looks<'a, M: Charted> {
    pub(super) system: &'a M,
    pub(super) t: M::S,
    pub(super) chart: usize,
    pub(super) before: &'a M::Continuation,
    pub(super) after: &'a M::Continuation,
}

impl<M: Charted> Looks<'_, M> {
    /// Checks that the state is so near to the last checked one that no loop can have gone through a flat pose. Each coordinate must be
    /// within a multiple of the reach of either state, the time within that of both.
    pub(super) fn check_near(&self) -> Result<(), Fault> {
        let far = |reach: M::S| FAR.of::<M::S>() * reach.abs();
        let within = self.before.coordinates().iter().zip(self.after.coordinates()).all(|(before, after)| {
            (after.last - before.last).abs() <= far(before.reach).max(far(after.reach))
        });
        let (before, after) = (self.before.time(), self.after.time());
        let in_time = (after.last - before.last).abs() <= far(before.reach).min(far(after.reach));
        if within && in_time {
            return Ok(());
        }
        let angle = self.turned().0.to_f64();
        Err(Fault { cause: Cause::TurnedTooFar { angle }, ..self.locked() })
    }

    /// Checks that the unknowns of iterations are where their rates have taken them, and not at another solution.
    #[inline]
    pub(super) fn check_iterated(&self, measure: M::S) -> Result<(), Fault> {
        let half = M::S::lit(0.5) * self.since();
        let farthest = square::<M::S>(FARTHEST_ITERATED.get()) * measure.max(narrowest_square());
        let iterated = self.before.iterated().iter().zip(self.after.iterated());
        for (part, (before, after)) in self.system.charts().iterated.iter().zip(iterated) {
            let moved = after.value - before.value;
            let off = moved - half * (after.rate + before.rate);
            // False for NaN.
            let near = off * off < farthest;
            if !near {
                let angle = moved.to_f64().abs();
                return Err(Fault::of_part(self.t.to_f64(), part, Cause::TurnedTooFar { angle }));
            }
        }
        Ok(())
    }

    /// The continuation data of the state, with the curvatures and widths that two states give together.
    pub(super) fn updated(&self) -> Result<M::Continuation, Fault> {
        let (angle, body) = self.turned();
        if angle > FARTHEST.of::<M::S>() {
            let cause = Cause::TurnedTooFar { angle: angle.to_f64() };
            return Err(Fault::of_part(self.t.to_f64(), body, cause));
        }
        let (since, mut continuation) = (self.since(), *self.after);
        if since > M::S::lit(0.0) {
            for (after, before) in continuation.iterated_mut().iter_mut().zip(self.before.iterated()) {
                after.bend = M::S::lit(0.5) * (after.rate - before.rate) / since;
            }
        }
        continuation.narrow(self.narrowed());
        Ok(continuation)
    }

    /// Factor by which the intervals become narrower. The rates of the unknowns determine how fast a dyad approaches a flat pose, but not
    /// how fast the measure of an iterated group changes. It should change by a tenth of itself within an interval; if it changed by more
    /// since the last check, the intervals become narrower by as much.
    pub(super) fn narrowed(&self) -> M::S {
        let one = M::S::lit(1.0);
        if self.system.charts().iterated.is_empty() {
            return one;
        }
        let coordinates = self.before.coordinates().iter().zip(self.after.coordinates());
        let times = (&self.before.time(), &self.after.time());
        let boxes = coordinates.chain([times]).fold(M::S::ZERO, |boxes, (before, after)| {
            boxes + ((after.last - before.last) / after.reach).abs()
        });
        let measures = self.before.determinants().iter().zip(self.after.determinants());
        let narrowed = measures.fold(one, |narrowed, (before, after)| {
            let (changed, expected) = ((*after - *before).abs(), BOX.of::<M::S>() * boxes * after.abs());
            let noticed = NOTICED.of::<M::S>() * after.abs();
            // False for NaN.
            if expected.max(noticed) < changed { narrowed.min(expected / changed) } else { narrowed }
        });
        narrowed.max(NARROWEST_BOX.of::<M::S>())
    }

    /// The fault of the loop that is nearest to not being closed.
    pub(super) fn locked(&self) -> Fault {
        let since = self.since();
        // How far the unknowns of iterations should have moved.
        let moved = self.before.iterated().iter().map(|at| ((at.rate + at.bend * since) * since).abs());
        let moved = moved.fold(M::S::lit(0.0), M::S::max);
        let angle = moved.to_f64();
        let cause =
            if moved > UNREACHED.of::<M::S>() { Cause::TurnedTooFar { angle } } else { Cause::Locked };
        Fault::of_part(self.t.to_f64(), flattest(self.system, self.chart, self.after), cause)
    }

    /// The time since the last check.
    fn since(&self) -> M::S {
        self.t - self.before.time().last
    }

    /// The farthest that a body of a loop has turned since the last check, rad, and which one.
    fn turned(&self) -> (M::S, &'static str) {
        let (before, after) = (self.before.angles(), self.after.angles());
        let mut most = (M::S::lit(0.0), "");
        let charts = self.system.charts();
        for &k in charts.found.get(self.chart).copied().unwrap_or_default() {
            let (Some(before), Some(after), Some(body)) =
                (before.get(k), after.get(k), charts.turning.get(k))
            else {
                continue;
            };
            let turned = (after.angle - before.angle).abs();
            if turned > most.0 {
                most = (turned, body);
            }
        }
        most
    }
}

/// The part that closes the loop of a chart with the smallest determinant.
pub(super) fn flattest<M: Charted>(system: &M, chart: usize, continuation: &M::Continuation) -> &'static str {
    let parts = system.charts().closing.get(chart).copied().unwrap_or_default();
    let (mut part, mut least) = ("", M::S::INFINITY);
    for (closing, determinant) in parts.iter().zip(continuation.determinants()) {
        let determinant = determinant.abs();
        if !least.lt(determinant) {
            (part, least) = (closing, determinant);
        }
    }
    part
}

/// A fault for a state at which the rate cannot be computed in the present chart.
#[cold]
pub fn not_regular<M: Charted>(system: &M, t: M::S, held: &M::U, x: &M::X) -> Fault {
    let after = &system.continuation(t, held, x).0;
    match &held.of_loops {
        &OfLoops::InChart { chart, continuation: ref before } => {
            Looks { system, t, chart, before, after }.locked()
        }
        OfLoops::Free { .. } => Fault::new(t.to_f64(), Cause::Locked),
    }
}
