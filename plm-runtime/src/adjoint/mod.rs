//! The gradient of a few results of a run by any number of variables, backward along its steps: the discrete adjoint.
//!
//! A run on [`Traced`] numbers is made once without a record. States of it are saved; then its segments, the last one first, are made once
//! more from there, recorded, and gone through backward. Their places in the [`Trace`] are counted on from segment to segment, so that a
//! number of a saved state is known by its place, and its adjoint is carried to the segment that made it. Whatever a run does is derived
//! so: the steps of any method, events, impacts, changes of modes, assembly, and what a caller does between steps.
//!
//! A segment has as many steps as the trace has room for. Where states cannot be saved for all segments, they are for every second,
//! fourth, ... one, and those between them are made again from there: with K of them, runs of about K^2/4 segments are derived by two runs
//! without record and one with (A. Griewank, A. Walther, Algorithm 799: revolve, ACM Trans. Math. Softw. 26, 2000, has the schedule that is
//! optimal where runs may be made more often).

mod adjoints;
mod carried;
mod lack;
mod saved;

use crate::fault::Fault;
use crate::scalar::Real;
use crate::sim::Reached;
use crate::trace::{Trace, Traced};

use adjoints::Adjoints;
pub use carried::Carried;
pub use lack::{Lack, NoGradient};
pub use saved::Saved;
use saved::Slots;

/// Memory for the way back, beside the trace. `P` is what a run is between two steps, as a [`Sim`](crate::Sim); `R` results are derived.
pub struct Memory<'m, P, S, const R: usize> {
    /// As many as the trace has terms.
    pub adjoints: &'m mut [[S; R]],
    /// At least [`carried`] for `P`.
    pub carried: &'m mut [Carried<S, R>],
    /// States between steps.
    pub saved: &'m mut [Option<Saved<P>>],
}

/// The number of [`Memory::carried`] that surely suffices: two for each number of a state.
pub const fn carried<P, S>() -> usize {
    2 * (size_of::<P>() / size_of::<(S, u64, usize)>() + 1)
}

/// Runs on traced numbers from `start`, step by step with `advance`, and gives the values of `results` at the end; `gradient` gets their
/// derivatives, by variable.
///
/// Steps have the bits of the same steps on numbers without trace. What was computed from the variables before, `start` among it, has to
/// stand in the trace. `advance` and `results` are called several times for the same step, and have to do the same each time.
///
/// # Errors
/// [`NoGradient::Fault`] of the run; [`Cause::Grazes`](crate::Cause::Grazes) and [`Cause::AtOnce`](crate::Cause::AtOnce) where it has no
/// derivatives. [`NoGradient::Short`] where memory does not suffice: it says what does.
pub fn adjoint<'t, P: Copy, S: Real, const R: usize>(
    trace: &'t Trace<'t, S>,
    start: P,
    advance: impl Fn(&mut P) -> Result<Reached, Fault>,
    results: impl Fn(&P) -> [Traced<'t, S>; R],
    memory: Memory<'_, P, S, R>,
    gradient: &mut [[S; R]],
) -> Result<[S; R], NoGradient> {
    let Memory { adjoints, carried, saved } = memory;
    let before = trace.next();
    let prefix = before - trace.variables() as u64;
    let replay = Replay { trace, prefix, advance, results };
    let least = Lack { terms: 0, adjoints: trace.room(), carried: self::carried::<P, S>(), saved: 0 };
    let has =
        Lack { terms: trace.room(), adjoints: adjoints.len(), carried: carried.len(), saved: saved.len() };
    least.met_by(has)?;
    let mut slots = Slots::new(saved);
    let forward = replay.forward(start, &mut slots);
    let outcome = forward.and_then(|forward| {
        let terms = (prefix + forward.longest + forward.longest.div_ceil(FAR - 1)) as usize;
        Lack { terms, adjoints: terms.max(trace.room()), saved: slots.needed(), ..least }.met_by(has)?;
        let mut adjoints = Adjoints::new([gradient, adjoints], carried, (trace.variables() as u64, prefix));
        adjoints.enter(forward.segment, forward.end);
        for (k, result) in forward.results.into_iter().enumerate() {
            adjoints.seed(result.place(), k);
        }
        replay.back(&forward, &mut slots, &mut adjoints)?;
        adjoints.go_back_start(trace);
        Ok(forward.results.map(|result| result.value))
    });
    trace.go_to(before);
    trace.record(before, prefix);
    outcome
}

/// Segments end at a step's end that is at most this part of their length before the last one for which there is room.
const FAR: u64 = 16;

/// A run that is recorded segment by segment, as often as needed.
struct Replay<'t, S, F, G> {
    trace: &'t Trace<'t, S>,
    /// Terms of what was computed before the run.
    prefix: u64,
    advance: F,
    results: G,
}

/// Results of the forward sweep.
struct Forward<'t, S, const R: usize> {
    results: [Traced<'t, S>; R],
    /// The place after its last term.
    end: u64,
    /// The place of the first term of the last segment.
    segment: u64,
    /// Terms of its longest step.
    longest: u64,
}

impl<'t, S, F, G> Replay<'t, S, F, G> {
    /// One step, and the results where it is the last one.
    fn step<P, const R: usize>(&self, state: &mut P) -> Result<Option<[Traced<'t, S>; R]>, Fault>
    where
        F: Fn(&mut P) -> Result<Reached, Fault>,
        G: Fn(&P) -> [Traced<'t, S>; R],
    {
        Ok(match (self.advance)(state)? {
            Reached::Step => None,
            Reached::End => Some((self.results)(state)),
        })
    }
}

impl<'t, S: Real, F, G> Replay<'t, S, F, G> {
    /// Terms for which there is room in a segment.
    fn room(&self) -> u64 {
        (self.trace.room() as u64).saturating_sub(self.prefix)
    }

    /// Saves a state as the end of a segment, if the last saved one is far enough behind: a copy of a state costs as much as part of a
    /// step.
    fn keep<P: Copy>(&self, before: &mut Saved<P>, state: &P) {
        let place = self.trace.next();
        if place - before.place >= self.room() / FAR {
            *before = Saved { state: *state, place };
        }
    }

    /// The run, recorded as long as there is room for all of it.
    fn forward<P: Copy, const R: usize>(
        &self,
        start: P,
        slots: &mut Slots<'_, P>,
    ) -> Result<Forward<'t, S, R>, NoGradient>
    where
        F: Fn(&mut P) -> Result<Reached, Fault>,
        G: Fn(&P) -> [Traced<'t, S>; R],
    {
        let (trace, mut state) = (self.trace, start);
        let (mut segment, mut longest) = (trace.next(), 0);
        slots.put(Saved { state, place: segment });
        trace.record(segment, self.prefix);
        let mut before = Saved { state, place: segment };
        loop {
            let place = trace.next();
            self.keep(&mut before, &state);
            let ended = self.step(&mut state)?;
            longest = longest.max(trace.next() - place);
            if trace.next() - segment > self.room() {
                trace.pause();
                if before.place > segment {
                    slots.put(before);
                    segment = before.place;
                }
            }
            if let Some(results) = ended {
                return Ok(Forward { results, end: trace.next(), segment, longest });
            }
        }
    }

    /// Goes back through all segments.
    fn back<P: Copy, const R: usize>(
        &self,
        forward: &Forward<'t, S, R>,
        slots: &mut Slots<'_, P>,
        adjoints: &mut Adjoints<'_, S, R>,
    ) -> Result<(), NoGradient>
    where
        F: Fn(&mut P) -> Result<Reached, Fault>,
        G: Fn(&P) -> [Traced<'t, S>; R],
    {
        let mut until = forward.end;
        if slots.segments() == 1 {
            return adjoints.go_back(self.trace, until);
        }
        for block in (0..slots.blocks()).rev() {
            self.save_within(block, slots)?;
            for segment in (0..slots.segments_of(block)).rev() {
                let Some(Saved { mut state, place }) = slots.within(block, segment) else { continue };
                self.trace.go_to(place);
                self.trace.record(place, self.prefix);
                while self.trace.next() < until && self.step(&mut state)?.is_none() {}
                if until < forward.end {
                    adjoints.enter(place, until);
                }
                adjoints.go_back(self.trace, until)?;
                until = place;
            }
        }
        Ok(())
    }

    /// Makes the segments of a block once more, and saves the states between them.
    fn save_within<P: Copy, const R: usize>(
        &self,
        block: usize,
        slots: &mut Slots<'_, P>,
    ) -> Result<(), NoGradient>
    where
        F: Fn(&mut P) -> Result<Reached, Fault>,
        G: Fn(&P) -> [Traced<'t, S>; R],
    {
        let Some(Saved { mut state, place: mut segment }) = slots.within(block, 0) else { return Ok(()) };
        let mut count = 1;
        self.trace.go_to(segment);
        self.trace.pause();
        let mut before = Saved { state, place: segment };
        while count < slots.segments_of(block) {
            self.keep(&mut before, &state);
            let ended = self.step(&mut state)?;
            if self.trace.next() - segment > self.room() {
                slots.put_within(count, before);
                segment = before.place;
                count += 1;
            }
            if ended.is_some() {
                break;
            }
        }
        Ok(())
    }
}
