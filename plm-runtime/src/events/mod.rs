//! Switching: where it happens, and how often it may.
//!
//! The side of every condition is part of what is held over a step, so that the rate is smooth within it. After a step
//! the guards tell whether a condition left its side. The first that did is located on the dense output, the step is
//! done again to end exactly there, and the other side is held from then on.
//!
//! The step is done again, because what follows starts from that state: it has the accuracy of every other step and the
//! constraints are kept, while the dense output is of lower order and off the constraints.

mod between;
mod border;
mod burst;
mod calm;
mod heeded;
mod jumps;
mod kinks;
mod looks;
mod past;
mod root;
mod search;
mod still;
mod violated;
mod words;

use self::border::{Border, decide, meet};
use self::burst::Burst;
use self::calm::Calm;
pub use self::heeded::holds;
pub(crate) use self::heeded::refresh;
use self::heeded::{Heeded, bit};
pub(crate) use self::jumps::{at_a_jump, before_settling, hold};
use self::kinks::kink;
use self::looks::Looks;
use self::past::{Switched, hold_past, required};
pub(crate) use self::past::{are_quiet, switch_past};
use self::search::{Found, Search};
use self::still::Still;
pub(crate) use self::violated::switch_each;
pub use self::violated::switch_where_due;
use self::violated::{is_below, is_past};
use crate::fault::{Cause, Fault};
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::sim::Begun;
use crate::system::System;
use crate::vector::Vector;

/// A step of so many units in the last place of the time is none.
const LEAST_ULPS: f64 = 32.0;

/// What a step ends with.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Ends {
    /// Nothing that switches.
    Whole,
    /// This condition switches.
    Due(usize),
    /// A kink, before which a condition may switch: the dense output that says so goes over the kink, and knows little of what is
    /// before it.
    BeforeKink,
}

/// What happens at the end of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Event {
    /// No condition is triggered.
    None,
    /// This condition is triggered, where the detector has ended the step.
    At(usize),
    /// The step was not ended by the detector: conditions whose guards are violated at its end switch there. Others were `missed`:
    /// they came and went within it; the first of them, and how many.
    Behind {
        /// A condition, by its index, and a count.
        missed: Option<(usize, u64)>,
    },
}

/// What is known of the modes that the discrete state holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Modes {
    /// Nothing has been done yet: a condition on its boundary begins in the mode that the motion goes to.
    New,
    /// They were decided at the beginning, and no step has been made.
    Begun,
    /// State, parameters or inputs may have been changed since.
    Unknown,
    /// They are those of the state.
    Known,
}

/// What is known of the guards on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch<S, G> {
    modes: Modes,
    /// How far each is on the wrong side because it was switched a little before its time; zero for most.
    left_over: G,
    /// Where guards need no look, with steps of fixed length.
    calm: Calm<S>,
    /// Switches in a short time.
    burst: Burst<S>,
}

impl<S: Real, G: Vector<S>> Watch<S, G> {
    pub(crate) fn new() -> Self {
        Self { modes: Modes::New, left_over: G::fill(S::ZERO), calm: Calm::new(), burst: Burst::new() }
    }

    /// State, parameters or inputs may have been changed.
    pub(crate) fn forget(&mut self) {
        self.modes = match self.modes {
            Modes::New | Modes::Begun => Modes::New,
            Modes::Unknown | Modes::Known => Modes::Unknown,
        };
        self.calm.forget();
        self.left_over = G::fill(S::ZERO);
    }

    /// Makes sure that the sides held are those that apply.
    #[inline]
    pub(crate) fn begin<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        course: &mut Course<'_, M>,
    ) -> Result<(), Fault> {
        if self.is_known() {
            return Ok(());
        }
        let here = guards_here(course)?;
        let is_new = self.modes == Modes::New;
        let border = decide(course, &here, is_new)?;
        if border.switched != 0 {
            method.restart();
            let count = if is_new { 0 } else { border.switched.count_ones() };
            self.burst.count(course, border.switched, count)?;
        }
        self.switch_due(method, course, Some(border))?;
        if border.decided != 0 {
            let here = guards_here(course)?;
            let own = |i: usize| {
                if border.decided & bit(i) == 0 { self.left_over.at(i) } else { here.at(i).min(S::ZERO) }
            };
            self.left_over = G::from_fn(own);
        }
        Ok(())
    }

    /// Are the sides held those that apply?
    #[inline]
    pub(crate) fn is_known(&self) -> bool {
        G::LEN == 0 || matches!(self.modes, Modes::Begun | Modes::Known)
    }

    /// A step as the method proposes it; with dense output it ends where the first condition leaves its side.
    #[inline]
    pub(crate) fn step<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
    ) -> Result<Event, Fault> {
        if !I::DENSE || G::LEN == 0 && M::KINKS == 0 {
            method.advance(course)?;
            return Ok(Event::None);
        }
        Ok(self.located(method, course)?.map_or(Event::None, Event::At))
    }

    /// The same where there are guards, with the condition that ends it. In a function of its own a build without optimisation holds the method as it was
    /// before the step for those alone.
    #[inline]
    fn located<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
    ) -> Result<Option<usize>, Fault> {
        let (before, start): (I, Begun<M>) =
            (*method, Begun { time: course.time, held: course.held, x: course.x });
        method.advance(course)?;
        self.calm.forget();
        // What would end a step so early that it hardly moves the time happens at once.
        let least = S::lit(LEAST_ULPS) * S::EPSILON * start.time.abs().max(course.end.abs());
        let mut beyond_kinks = false;
        loop {
            let end = guards_here(course)?;
            let (ends, time) = self.ends(method, course, (&start, &end), (least, beyond_kinks))?;
            let due = if let Ends::Due(index) = ends { Some(index) } else { None };
            if time >= course.time {
                self.arrive(end);
                return Ok(due);
            }
            course.stats.steps -= 1;
            course.stats.rejected += 1;
            (*method, course.time, course.held, course.x) = (before, start.time, start.held, start.x);
            // What happens at once needs no step.
            if time - start.time <= least {
                return Ok(due);
            }
            advance_to(method, course, time)?;
            if ends != Ends::BeforeKink {
                // A shorter step that is rejected all the same has not come as far: the next one will find the crossing again.
                let mut due = due.filter(|_| course.time >= time);
                if let Some(index) = due.filter(|index| course.system.must_hold(*index)) {
                    due = meet(method, course, (&before, &start), index)?.then_some(index);
                }
                self.arrive(guards_here(course)?);
                return Ok(due);
            }
            beyond_kinks = true;
        }
    }

    /// Where the last step is to end, and why.
    fn ends<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        course: &mut Course<'_, M>,
        (start, end): (&Begun<M>, &G),
        (least, beyond_kinks): (S, bool),
    ) -> Result<(Ends, S), Fault> {
        if G::LEN > 0 {
            method.densify(course)?;
        }
        let path = method.path();
        let still = path
            .map_or_else(|| Still::unknown(course.system, &course.held), |path| Still::over(course, &path));
        let found = if still.guards {
            (Found::Nothing, course.time)
        } else {
            self.search(method, course, (start, end), still.heeded)
        };
        let (ends, time) = match found {
            (Found::Crossing(index, _), time) => (Ends::Due(index), time),
            (Found::Open(_), time) if time - start.time > least => (Ends::Whole, time),
            _ => (Ends::Whole, course.time),
        };
        let bends = still.kinks != 0 && !beyond_kinks;
        let crossing = matches!(ends, Ends::Due(_)).then_some(time);
        let kink = if bends { kink(method, course, (start.time, crossing), still.kinks)? } else { None };
        Ok(match kink.filter(|kink| *kink < course.time) {
            Some(kink) if time < kink => (Ends::BeforeKink, kink),
            Some(kink) => (Ends::Whole, kink),
            None => (ends, time),
        })
    }

    /// Holds the other side of the condition that is due; without dense output of all that are past their guards.
    #[inline]
    pub(crate) fn switch<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
        event: Event,
    ) -> Result<(), Fault> {
        if G::LEN == 0 {
            return Ok(());
        }
        if let Event::Behind { missed } = event {
            if let Some((index, passed_over)) = missed {
                course.stats.passed_over += passed_over;
                required(course, index)?;
            }
            return self.switch_due(method, course, None);
        }
        if !I::DENSE {
            return Ok(());
        }
        let (time, x) = (course.time, course.x);
        let changed = refresh(course.system, time, &mut course.held, &x);
        if changed != 0 {
            self.left_over =
                G::from_fn(|i| if changed & bit(i) == 0 { self.left_over.at(i) } else { S::ZERO });
        }
        // One that does not matter here has switched with the others.
        let Event::At(index) = event else { return Ok(()) };
        if changed & bit(index) != 0 {
            return Ok(());
        }
        required(course, index)?;
        let (mut after, mut x) = (course.held, course.x);
        course.system.switch(course.time, &mut after, &mut x, index)?;
        hold(course, after)?;
        course.x = x;
        method.restart();
        let here = guards_here(course)?;
        self.left_over.set(index, here.at(index).min(S::ZERO));
        let before = core::mem::replace(&mut self.modes, Modes::Known);
        let switched = u32::from(!matches!(before, Modes::New | Modes::Begun));
        self.burst.count(course, bit(index), switched)
    }

    /// The state reached has these guards.
    fn arrive(&mut self, guards: G) {
        self.modes = Modes::Known;
        self.release(&guards);
    }

    /// Guards that are on their side again have nothing left over.
    fn release(&mut self, guards: &G) {
        self.left_over = self.left_over.map2(guards, |left, g| if g < S::ZERO { left } else { S::ZERO });
    }

    /// Switches what is past its guard at the current state, where a step led; else a change from outside did, and what is on the
    /// border is decided.
    fn switch_due<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        course: &mut Course<'_, M>,
        border: Option<Border>,
    ) -> Result<(), Fault> {
        let here = guards_here(course)?;
        self.modes = match self.modes {
            Modes::New | Modes::Begun => Modes::Begun,
            Modes::Unknown | Modes::Known => Modes::Known,
        };
        self.release(&here);
        let Some(Switched { conditions, count }) = hold_past(course, &here, (border, self.left_over))? else {
            return Ok(());
        };
        method.restart();
        let here = guards_here(course)?;
        let own =
            |i: usize| if conditions & bit(i) == 0 { self.left_over.at(i) } else { here.at(i).min(S::ZERO) };
        self.left_over = G::from_fn(own);
        self.burst.count(course, conditions, count)
    }

    /// Searches the dense output of the last step: what became of the conditions, and when.
    fn search<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        course: &mut Course<'_, M>,
        (start, end): (&Begun<M>, &G),
        heeded: Heeded,
    ) -> (Found<S>, S) {
        if G::LEN == 0 {
            return (Found::Nothing, course.time);
        }
        let Some(path) = method.path() else {
            let began = guards(course.system, start.time, &start.held, &start.x);
            let looks = Looks { method, course, start: start.time, left_over: &self.left_over, heeded };
            return looks.first(&began, end);
        };
        let found = Search::new((course.system, course.held), path, &self.left_over, heeded).first();
        match found {
            Found::Crossing(_, theta) | Found::Open(theta) => (found, path.time(theta)),
            Found::Nothing => (found, course.time),
        }
    }
}

/// One step that ends at a time within the interval at the latest.
fn advance_to<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    time: M::S,
) -> Result<(), Fault> {
    let whole = core::mem::replace(&mut course.end, time);
    let outcome = method.advance(course);
    course.end = whole;
    outcome
}

/// The guards at the state reached.
fn guards_here<M: System<S: Real>>(course: &Course<'_, M>) -> Result<M::G, Fault> {
    let g = guards(course.system, course.time, &course.held, &course.x);
    if g.is_finite() {
        return Ok(g);
    }
    let index = (0..M::G::LEN).find(|i| !g.at(*i).is_finite()).unwrap_or(0);
    Err(Fault::of_part(course.time.to_f64(), course.system.guard_name(index), Cause::NotFinite))
}

/// The guards of a state.
fn guards<M: System>(system: &M, t: M::S, u: &M::U, x: &M::X) -> M::G {
    let mut g = M::G::fill(M::S::lit(0.0));
    system.guards(t, u, x, &mut g);
    g
}
