//! Switching: where it happens, and how often it may.
//!
//! The side of every condition is part of what is held over a step, so that the rate is smooth within it. After a step
//! the guards tell whether a condition left its side. The first that did is located on the dense output, the step is
//! done again to end exactly there, and the other side is held from then on.
//!
//! The step is done again, because what follows starts from that state: it has the accuracy of every other step and the
//! constraints are kept, while the dense output is of lower order and off the constraints.

mod root;

use self::root::{Point, root};
use crate::fault::{Cause, Fault};
use crate::method::{Course, Method};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// More switches than this within a short time are the end of a run.
const MOST_SWITCHES: u32 = 100;
/// That short time, as a fraction of the longest step so far, ...
const SHORT: f64 = 1e-6;
/// ... but not less than so many units in the last place of the time.
const SHORT_ULPS: f64 = 1000.0;
/// A step is looked at so often, evenly, for a guard that is crossed and crossed back.
const LOOKS: usize = 4;
/// A condition that begins a step past its guard may yet come to its side within it: halvings of the step that are
/// looked at to find out.
const HALVINGS: u32 = 10;

/// Switches every condition whose guard is past its band at the state `x`; how many did.
///
/// A condition may switch another one: it is repeated until none is past, but not for ever.
pub fn switch_where_due<M: System<S: Real>>(system: &M, t: M::S, u: &mut M::U, x: &M::X) -> u32 {
    let mut switched = 0;
    for _ in 0..=M::G::LEN {
        let before = switched;
        for i in 0..M::G::LEN {
            if is_past(system, &guards(system, t, u, x), i) {
                system.switch(t, u, x, i);
                switched += 1;
            }
        }
        if switched == before {
            break;
        }
    }
    switched
}

/// What is known of the guards on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch<S, G> {
    /// The guards at the current state, unless it may have been changed.
    guards: Option<G>,
    /// When the present burst of switches began, and how many it has.
    since: S,
    count: u32,
}

impl<S: Real, G: Vector<S>> Watch<S, G> {
    pub(crate) fn new() -> Self {
        Self { guards: None, since: S::lit(0.0), count: 0 }
    }

    /// State, parameters or inputs may have been changed.
    pub(crate) fn forget(&mut self) {
        self.guards = None;
    }

    /// Makes sure that the sides held are those that apply.
    #[inline]
    pub(crate) fn begin<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        course: &mut Course<'_, M>,
    ) -> Result<(), Fault> {
        if G::LEN == 0 || self.guards.is_some() {
            return Ok(());
        }
        self.switch_due(method, course, false)
    }

    /// One step, ended where the first condition leaves its side; that condition.
    #[inline]
    pub(crate) fn step<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        method: &mut I,
        course: &mut Course<'_, M>,
    ) -> Result<Option<usize>, Fault> {
        if G::LEN == 0 || !I::DENSE {
            method.advance(course)?;
            return Ok(None);
        }
        let (before, start) = (*method, Start { time: course.time, held: course.held, x: course.x });
        method.advance(course)?;
        let end = guards_here(course)?;
        let Some((index, time)) = self.first_crossing(method, course, start.time, &end)? else {
            self.guards = Some(end);
            return Ok(None);
        };
        if time >= course.time {
            return Ok(Some(index));
        }
        course.stats.steps -= 1;
        course.stats.rejected += 1;
        (*method, course.time, course.held, course.x) = (before, start.time, start.held, start.x);
        if time <= start.time {
            return Ok(Some(index));
        }
        let whole = core::mem::replace(&mut course.end, time);
        let outcome = method.advance(course);
        course.end = whole;
        outcome?;
        // A shorter step that is rejected all the same has not come as far: the next one will find the crossing again.
        if course.time < time {
            self.guards = Some(guards_here(course)?);
            return Ok(None);
        }
        Ok(Some(index))
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
        self.guards = Some(guards_here(course)?);
        self.count(course, 1, index)
    }

    /// Switches what is past its guard at the current state, where a step led; else a change from outside did.
    fn switch_due<M: System<S = S, G = G>>(
        &mut self,
        method: &mut impl Method<M>,
        course: &mut Course<'_, M>,
        by_step: bool,
    ) -> Result<(), Fault> {
        let here = guards_here(course)?;
        self.guards = Some(here);
        let Some(first) = (0..G::LEN).find(|i| is_past(course.system, &here, *i)) else {
            return Ok(());
        };
        for index in (first..G::LEN).filter(|i| is_past(course.system, &here, *i)) {
            required(course, index)?;
        }
        let mut after = course.held;
        let switched = switch_where_due(course.system, course.time, &mut after, &course.x);
        if by_step {
            hold(course, after)?;
        }
        course.held = after;
        method.restart();
        self.guards = Some(guards_here(course)?);
        self.count(course, switched, first)
    }

    /// The condition that leaves its side first in the last step, and when; the start of the step for one that had left
    /// it before and does not come back.
    fn first_crossing<M: System<S = S, G = G>, I: Method<M>>(
        &self,
        method: &mut I,
        course: &mut Course<'_, M>,
        start: S,
        end: &G,
    ) -> Result<Option<(usize, S)>, Fault> {
        let began = self.guards.unwrap_or(*end);
        let length = course.time - start;
        let at = |look: S| start + look / S::lit(LOOKS as f64) * length;
        let system = course.system;
        let guards_at = |method: &I, course: &Course<'_, M>, time: S| {
            let (held, x) = method.moment(course, time);
            guards(system, time, &held, &x)
        };
        let looks = |method: &I, course: &Course<'_, M>| {
            let inside = [1.0, 2.0, 3.0].map(|look| guards_at(method, course, at(S::lit(look))));
            [began, inside[0], inside[1], inside[2], *end]
        };
        let rough = looks(method, course);
        if (0..G::LEN).all(|i| first_out(rough.map(|g| g.at(i)), system.band(i), |_| true).is_none()) {
            return Ok(None);
        }
        method.densify(course)?;
        let exact = looks(method, course);
        let mut first: Option<(usize, S)> = None;
        for i in 0..G::LEN {
            let (band, guard) = (system.band(i), |time: S| guards_at(method, course, time).at(i));
            let Some(look) = first_out(exact.map(|g| g.at(i)), band, |look| guard(at(look)) < -band) else {
                continue;
            };
            let out = Point { at: at(look), value: guard(at(look)) };
            let crossing = crossing(Point { at: start, value: began.at(i) }, out, guard);
            if first.is_none_or(|(_, time)| crossing < time) {
                first = Some((i, crossing));
            }
        }
        Ok(first)
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
        let short =
            S::lit(SHORT * course.stats.longest_step).max(S::lit(SHORT_ULPS) * S::EPSILON * time.abs());
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

/// Where a step began.
struct Start<S, U, X> {
    time: S,
    held: U,
    x: X,
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
        | Cause::Singular { .. } => {
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

/// The first look at which a guard is beyond its band, or between looks, where the parabola through three of them says
/// so; of those that `is_out` confirms.
fn first_out<S: Real>(g: [S; LOOKS + 1], band: S, is_out: impl Fn(S) -> bool) -> Option<S> {
    (1..=LOOKS).find_map(|k| {
        let (look, value) = (S::lit(k as f64), g[k]);
        if value < -band {
            return is_out(look).then_some(look);
        }
        let (before, after) = (g[k - 1] - value, *g.get(k + 1)? - value);
        // Its lowest point stands `lean / bend` looks after the middle one.
        let (lean, bend) = (S::lit(0.5) * (before - after), before + after);
        let lowest = value - S::lit(0.5) * lean * lean / bend;
        let place = look + lean / bend;
        (lean.abs() < bend && lowest < -band && is_out(place)).then_some(place)
    })
}

/// The first time past the root of a guard between the start of a step and a time at which it is past.
fn crossing<S: Real>(start: Point<S>, end: Point<S>, guard: impl Fn(S) -> S) -> S {
    let zero = S::lit(0.0);
    let tolerance = S::EPSILON * start.at.abs().max(end.at.abs());
    if start.value > zero {
        return root(start, end, tolerance, guard);
    }
    let mut length = end.at - start.at;
    for _ in 0..HALVINGS {
        length = S::lit(0.5) * length;
        let at = start.at + length;
        let value = guard(at);
        if value > zero {
            return root(Point { at, value }, end, tolerance, guard);
        }
    }
    start.at
}
