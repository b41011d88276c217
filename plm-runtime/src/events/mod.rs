//! Switching: where it happens, and how often it may.
//!
//! The side of every condition is part of what is held over a step, so that the rate is smooth within it. After a step
//! the guards tell whether a condition left its side. The first that did is located on the dense output, the step is
//! done again to end exactly there, and the other side is held from then on.
//!
//! The step is done again, because what follows starts from that state: it has the accuracy of every other step and the
//! constraints are kept, while the dense output is of lower order and off the constraints.

mod between;
mod calm;
mod kinks;
mod looks;
mod past;
mod root;
mod search;
mod still;
mod words;

use self::calm::Calm;
use self::kinks::Kinks;
use self::looks::Looks;
use self::past::hold_past;
pub(crate) use self::past::{are_quiet, switch_past};
use self::search::{Found, Search};
use self::still::Still;
use crate::fault::{Cause, Fault};
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::sim::Begun;
use crate::system::System;
use crate::vector::Vector;

/// More switches than this within a short time are the end of a run.
const MOST_SWITCHES: u32 = 100;
/// That short time, as a fraction of the longest step so far, ...
const SHORT: f64 = 1e-6;
/// ... but not less than so many units in the last place of the time.
const SHORT_ULPS: f64 = 1000.0;
/// A step of so many units in the last place of the time is none.
const LEAST_ULPS: f64 = 32.0;

/// Switches every condition whose guard is past its band at the state `x`; how many did.
///
/// A condition may switch another one: it is repeated until none is past, but not for ever.
pub fn switch_where_due<M: System<S: Real>>(system: &M, t: M::S, u: &mut M::U, x: &M::X) -> u32 {
    let mut switched = 0;
    switch_each(system, t, u, x, |_| switched += 1);
    switched
}

/// The same; gives `each` that switches.
pub(crate) fn switch_each<M: System<S: Real>>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &M::X,
    mut each: impl FnMut(usize),
) {
    for _ in 0..=M::G::LEN {
        let mut any = false;
        for i in 0..M::G::LEN {
            if is_past(system, &guards(system, t, u, x), i) {
                system.switch(t, u, x, i);
                each(i);
                any = true;
            }
        }
        if !any {
            break;
        }
    }
}

/// What is known of the guards on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch<S, G> {
    /// The sides held are those that apply, unless the state may have been changed.
    known: bool,
    /// How far each is on the wrong side because it was switched a little before its time; zero for most.
    left_over: G,
    /// Nothing has been done yet: a condition that is on its boundary begins on the side that it goes to.
    is_new: bool,
    /// A condition without dense output that came and went within the last step, and how many did.
    brief: Option<(usize, u64)>,
    /// Where guards need no look, with steps of fixed length.
    calm: Calm<S>,
    /// The last step stayed there.
    is_calm: bool,
    /// When the present burst of switches began, and how many it has.
    since: S,
    count: u32,
}

impl<S: Real, G: Vector<S>> Watch<S, G> {
    pub(crate) fn new() -> Self {
        Self {
            known: false,
            left_over: G::fill(S::ZERO),
            is_new: true,
            brief: None,
            calm: Calm::new(),
            is_calm: false,
            since: S::ZERO,
            count: 0,
        }
    }

    /// State, parameters or inputs may have been changed.
    pub(crate) fn forget(&mut self) {
        self.known = false;
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
        self.switch_due(method, course, false)
    }

    /// Are the sides held those that apply?
    #[inline]
    pub(crate) fn is_known(&self) -> bool {
        G::LEN == 0 || self.known
    }

    /// One step, ended where the first condition leaves its side; that condition.
    #[inline]
    pub(crate) fn step<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
    ) -> Result<Option<usize>, Fault> {
        if G::LEN == 0 && (M::KINKS == 0 || !I::DENSE) {
            method.advance(course)?;
            return Ok(None);
        }
        self.watched(method, course)
    }

    /// The same where there are guards. In a function of its own a build without optimisation holds the method as it was
    /// before the step for those alone.
    #[inline]
    fn watched<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
    ) -> Result<Option<usize>, Fault> {
        let (before, start) = (*method, Begun { time: course.time, held: course.held, x: course.x });
        method.advance(course)?;
        if !I::DENSE {
            return self.look_between(course, &start).map(|()| None);
        }
        self.calm.forget();
        let end = guards_here(course)?;
        if G::LEN > 0 {
            method.densify(course)?;
        }
        let still = method.path().map_or(Still::UNKNOWN, |path| Still::over(course, &path));
        // What would end a step so early that it hardly moves the time happens at once.
        let least = S::lit(LEAST_ULPS) * S::EPSILON * start.time.abs().max(course.end.abs());
        let found = if still.guards {
            (Found::Nothing, course.time)
        } else {
            self.search(method, course, &start, &end)
        };
        let (mut due, mut time) = match found {
            (Found::Crossing(index, _), time) => (Some(index), time),
            (Found::Open(_), time) if time - start.time > least => (None, time),
            _ => (None, course.time),
        };
        if !still.kinks
            && let Some(kink) = kink(method, course, start.time)?.filter(|kink| *kink < time)
        {
            (due, time) = (None, kink);
        }
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
        let whole = core::mem::replace(&mut course.end, time);
        let outcome = method.advance(course);
        course.end = whole;
        outcome?;
        self.arrive(guards_here(course)?);
        // A shorter step that is rejected all the same has not come as far: the next one will find the crossing again.
        Ok(due.filter(|_| course.time >= time))
    }

    /// Holds the other side of the condition that is due; without dense output of all that are past their guards.
    #[inline]
    pub(crate) fn switch<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
        due: Option<usize>,
    ) -> Result<(), Fault> {
        if G::LEN == 0 {
            return Ok(());
        }
        if !I::DENSE {
            if self.is_calm {
                return Ok(());
            }
            if let Some((index, passed_over)) = self.brief.take() {
                course.stats.passed_over += passed_over;
                required(course, index)?;
            }
            return self.switch_due(method, course, true);
        }
        let Some(index) = due else {
            return Ok(());
        };
        required(course, index)?;
        let mut after = course.held;
        course.system.switch(course.time, &mut after, &course.x, index);
        hold(course, after)?;
        method.restart();
        let here = guards_here(course)?;
        self.known = true;
        self.left_over.set(index, here.at(index).min(S::ZERO));
        let switched = u32::from(!core::mem::replace(&mut self.is_new, false));
        self.count(course, switched, index)
    }

    /// The state reached has these guards.
    fn arrive(&mut self, guards: G) {
        (self.is_new, self.known) = (false, true);
        self.left_over = self.left_over.map2(&guards, |left, g| if g < S::ZERO { left } else { S::ZERO });
    }

    /// Switches what is past its guard at the current state, where a step led; else a change from outside did.
    fn switch_due<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        course: &mut Course<'_, M>,
        by_step: bool,
    ) -> Result<(), Fault> {
        let here = guards_here(course)?;
        self.known = true;
        let Some((first, switched)) = hold_past(course, &here, by_step)? else { return Ok(()) };
        method.restart();
        guards_here(course)?;
        self.count(course, switched, first)
    }

    /// Searches the dense output of the last step: what became of the conditions, and when.
    fn search<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        course: &mut Course<'_, M>,
        start: &Begun<M>,
        end: &G,
    ) -> (Found<S>, S) {
        if G::LEN == 0 {
            return (Found::Nothing, course.time);
        }
        let Some(path) = method.path() else {
            let began = guards(course.system, start.time, &start.held, &start.x);
            let looks = Looks { method, course, start: start.time, left_over: &self.left_over };
            return looks.first(&began, end);
        };
        let found = Search::new(course.system, course.held, path, &self.left_over).first();
        match found {
            Found::Crossing(_, theta) | Found::Open(theta) => (found, path.time(theta)),
            Found::Nothing => (found, course.time),
        }
    }

    /// Counts switches; too many in too short a time are a fault of the condition `index`.
    fn count<M: System<S = S, G = G>>(
        &mut self,
        course: &mut Course<'_, M>,
        switched: u32,
        index: usize,
    ) -> Result<(), Fault> {
        course.stats.switches += u64::from(switched);
        let time = course.time;
        let short = (S::lit(SHORT) * *course.longest_step).max(S::lit(SHORT_ULPS) * S::EPSILON * time.abs());
        if time - self.since > short || time < self.since {
            (self.since, self.count) = (time, 0);
        }
        self.count = self.count.saturating_add(switched);
        if self.count <= MOST_SWITCHES {
            return Ok(());
        }
        let cause = Cause::Zeno { events: self.count, within: (time - self.since).to_f64() };
        Err(Fault::of_part(time.to_f64(), course.system.guard_name(index), cause))
    }
}

/// The time of the first kink in the last step that is not smaller than the tolerance.
///
/// The rough output of the step tells whether there is one at all, so that steps without kinks need no more evaluations.
fn kink<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    course: &mut Course<'_, M>,
    start: M::S,
) -> Result<Option<M::S>, Fault> {
    let (Some(tolerance), Some(path), true) = (method.tolerance(), method.path(), M::KINKS > 0) else {
        return Ok(None);
    };
    let (system, held) = (course.system, course.held);
    // Where there are guards, the dense output is known.
    let path = if M::G::LEN > 0 {
        path
    } else {
        if (Kinks { system, held, path }).first().is_none() {
            return Ok(None);
        }
        method.densify(course)?;
        let Some(path) = method.path() else { return Ok(None) };
        path
    };
    let mut outcome = Ok(());
    let theta = Kinks { system, held, path }.first_that_matters(tolerance, |t, x| {
        let mut rate = *x;
        outcome = course.rate(t, x, &mut rate);
        outcome.is_ok().then_some(rate)
    });
    outcome?;
    let least = M::S::lit(LEAST_ULPS) * M::S::EPSILON * start.abs().max(course.end.abs());
    Ok(theta.map(|theta| path.time(theta)).filter(|time| *time - start > least))
}

/// Goes on with the sides of `after`, unless constraint rows would have to jump.
pub(crate) fn hold<M: System<S: Real>>(course: &mut Course<'_, M>, after: M::U) -> Result<(), Fault> {
    if let Some(fault) = course.system.jump(course.time, &course.held, &course.x, Some(&after)) {
        return Err(fault);
    }
    course.held = after;
    Ok(())
}

/// The fault of a step that came to nothing, or of what jumps there: joints that would have to jump come apart.
#[cold]
pub(crate) fn at_a_jump<M: System<S: Real>>(course: &Course<'_, M>, fault: Fault) -> Fault {
    match fault.cause {
        Cause::StepTooSmall { .. }
        | Cause::Drift { .. }
        | Cause::TooManySteps { .. }
        | Cause::Singular { .. }
        | Cause::Workspace { .. } => {
            course.system.jump(course.time, &course.held, &course.x, None).unwrap_or(fault)
        }
        _ => fault,
    }
}

/// The end of a run whose requirement `index` is not met.
fn required<M: System<S: Real>>(course: &Course<'_, M>, index: usize) -> Result<(), Fault> {
    if course.system.must_hold(index) {
        let name = course.system.guard_name(index);
        return Err(Fault::of_part(course.time.to_f64(), name, Cause::Required));
    }
    Ok(())
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

/// The guard `index` is beyond its band.
fn is_past<M: System<S: Real>>(system: &M, g: &M::G, index: usize) -> bool {
    g.at(index) < -system.band(index)
}
