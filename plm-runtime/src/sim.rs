//! A running simulation: a mechanism at a moment, a method, and what was done.

mod changes;
mod clock;
mod contacts;
mod count;
mod fast;
mod notice;
mod reached;
mod samples;
mod times;
mod watched;

pub(crate) use self::clock::Clock;
pub use self::notice::Notice;
pub use self::reached::Reached;
pub use self::samples::Seen;
use self::samples::{Sampler, Samples, Times};
use crate::events::{Detector, History};
use crate::fault::Fault;
use crate::mechanism::{Mechanism, Moment};
use crate::method::{Context, Dop853, Method};
use crate::protocol::{Advance, Guarded, Limits, Observer, Unobserved};
use crate::scalar::{Real, Scalar};
pub use crate::stats::Stats;
use crate::system::Drift;

/// A running simulation.
///
/// It dereferences to the mechanism's state: `sim.arm_angle()`, `sim.input.drive = 1.0`. Any mutable access makes the method discard its
/// stored rate, because state, parameters or inputs may have been changed. The next step checks for changes: a parameter whose value the
/// equations do not allow is a fault, and one that joints read makes the mechanism reassemble from the present pose ([`Mechanism::renew`]).
#[derive(Clone, Copy)]
pub struct Sim<M: Mechanism, I = Dop853<M>> {
    pub(crate) state: M::State,
    pub(crate) method: I,
    pub(crate) stats: Stats,
    pub(crate) detector: Detector<M::S, M::G>,
    pub(crate) limits: Limits<M::S>,
    /// Clock that carries the rounding error of the time.
    pub(crate) clock: Clock<M::S>,
    /// The longest step so far, s.
    pub(crate) longest_step: M::S,
    pub(crate) history: History<M>,
    /// When it began, s.
    pub(crate) start_time: M::S,
    /// The caller may have changed something since the last step.
    pub(crate) changed: bool,
    /// Fingerprint of the parameters at the last check.
    pub(crate) parameters: u64,
}

/// A simulation as it was at one moment; resuming from it gives the same bits again.
#[derive(Clone, Copy)]
pub struct Snapshot<M: Mechanism, I = Dop853<M>>(Sim<M, I>);

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// A simulation that begins in `state`.
    pub fn new(mut state: M::State, method: I) -> Self {
        if state.mechanism().contact_count() > 0 {
            M::change_contact(state.in_place().held, method.change());
        }
        Self {
            parameters: state.mechanism().fingerprint(),
            start_time: state.time(),
            history: History::new(),
            state,
            method,
            stats: Stats::default(),
            detector: Detector::new(),
            limits: Limits::NONE,
            clock: Clock { time: M::S::ZERO, rest: M::S::ZERO },
            longest_step: M::S::ZERO,
            changed: false,
        }
    }

    /// Runs for the communication interval `dt`, in s, and ends exactly there.
    ///
    /// The rounding error of the time is carried into the following intervals: a million intervals of a millisecond end at 1000 s, in `f32`
    /// as well.
    ///
    /// # Errors
    /// When the interval cannot be integrated; the state is then that of the last accepted step.
    #[inline]
    pub fn step(&mut self, dt: M::S) -> Result<(), Fault> {
        let clock = self.clock.after(self.state.time(), dt);
        self.advance(clock.time, dt, &mut Unobserved)?;
        self.clock = clock;
        Ok(())
    }

    /// Runs until the time `until` and gives a sample at the current time and after every `every`, in s.
    ///
    /// Methods with dense output are not made to step shorter by samples. A sample that drifted is projected.
    ///
    /// # Errors
    /// When the run cannot be continued; the samples before that moment have been given. Before all, when `until` has passed,
    /// or when `every` is not positive or too short to move the time.
    pub fn run(&mut self, until: M::S, every: M::S, mut sample: impl FnMut(&M::State)) -> Result<(), Fault> {
        let times = self.times(until, every)?;
        let one = M::S::lit(1.0);
        sample(&self.state);
        let mut k = one;
        if !self.method.is_dense() {
            while k <= times.last {
                self.advance(times.at(k), every, &mut Unobserved)?;
                sample(&self.state);
                k = k + one;
            }
            return self.advance(until, until - times.start, &mut Unobserved);
        }
        let samples = Samples { times, next: one, moment: self.state };
        self.advance(until, until - times.start, &mut Sampler { samples, sample: &mut sample })
    }

    /// Communication points of a run, after a check for changes by the caller.
    fn times(&mut self, until: M::S, every: M::S) -> Result<Times<M::S>, Fault> {
        let start = self.state.time();
        let length = until - start;
        if !(until >= start && until.is_finite()) {
            return Err(self.bad_interval(length));
        }
        let ulp = M::S::EPSILON * start.abs().max(until.abs());
        if !(every > M::S::ZERO && every > M::S::lit(4.0) * ulp) {
            return Err(self.bad_interval(every));
        }
        self.take_changes()?;
        // Rounding must not cost the last sample.
        let last = (length / every * (M::S::lit(1.0) + M::S::lit(16.0) * M::S::EPSILON)).floor();
        Ok(Times { start, every, until, last })
    }

    /// Projects the state onto its constraints.
    ///
    /// After a run that has ended with [`Cause::Drift`](crate::Cause::Drift) the state is that before the step, which was on its constraints: to
    /// project it changes nothing.
    ///
    /// # Errors
    /// When the projection does not converge, or a parameter has been changed to what cannot be.
    pub fn project(&mut self) -> Result<(), Fault> {
        self.take_changes()?;
        let (time, held, mut x) = (self.state.time(), self.state.held(), *self.state.x());
        self.state.mechanism().project(time, &held, &mut x)?;
        self.state.set(time, &held, &x);
        self.stats.projected += 1;
        self.forget();
        Ok(())
    }

    /// How far the state is from its constraints, with the parameters as they are.
    pub fn drift(&self) -> Drift<M::S> {
        self.state.mechanism().opening(self.state.time(), &self.state.held(), self.state.x())
    }

    /// The mechanism at the current moment.
    pub fn state(&self) -> &M::State {
        &self.state
    }

    /// The method and its options.
    pub fn method(&self) -> &I {
        &self.method
    }

    /// The method, to change its options.
    pub fn method_mut(&mut self) -> &mut I {
        &mut self.method
    }

    /// Counters of the run so far, with the longest step.
    pub fn stats(&self) -> Stats {
        Stats { longest_step: self.longest_step.to_f64(), ..self.stats }
    }

    /// Ends the run, before the step, where a loop passes a pose in which it could go on in several ways; if not, the run
    /// goes on as the motion does, and the pose is counted.
    pub fn stop_at_change_points(&mut self, stop: bool) {
        self.limits.change_points = stop;
    }

    /// Ends a step in which kinetic and potential energy less the work of the forces change by more than this fraction of
    /// the larger of the kinetic energy and the work in the step. It guards against formulas, parts and step lengths that
    /// are wrong; 0.1 is a good value. It costs two evaluations of all outputs a step, and is off at first. Prescribed motions do
    /// work that is not counted, so that nothing is checked if there are some.
    pub fn watch_energy(&mut self, fraction: Option<M::S>) {
        self.limits.energy_jump = fraction;
    }

    /// Everything that decides how the run goes on.
    pub fn save(&self) -> Snapshot<M, I> {
        Snapshot(self.clone())
    }

    /// Goes on from a saved moment.
    pub fn resume(&mut self, snapshot: &Snapshot<M, I>) {
        self.clone_from(&snapshot.0);
    }

    /// Advances to `end`, which is to be `length` from here; `observer` sees every accepted step.
    fn advance<O: Observer<M>>(&mut self, end: M::S, length: M::S, observer: &mut O) -> Result<(), Fault> {
        // False for NaN; no step by itself leads to an infinite time.
        let begins = end >= self.state.time() && !self.changed;
        if !begins {
            self.begin(end, length)?;
        }
        if self.method.is_fast() && !O::SEES && self.fast_step(end) {
            return Ok(());
        }
        self.many(end, length, observer)
    }

    /// The general path: every step is checked. It is kept out of line so that the fast path does not pay for its stack frame.
    #[inline(never)]
    fn many<O: Observer<M>>(&mut self, end: M::S, length: M::S, observer: &mut O) -> Result<(), Fault> {
        if !end.is_finite() {
            return Err(self.bad_interval(length));
        }
        let time = self.state.time();
        let Self { state, method, stats, detector, limits, longest_step, history, .. } = self;
        let (system, held, x) = (state.mechanism(), state.held(), *state.x());
        let mut context = Context::new((system, held), (time, x), end, (stats, longest_step));
        let guarded = Guarded { detector, history, limits: *limits };
        let mut advance = Advance { method, context: &mut context, guarded, observer, cut: None };
        let outcome = advance.run_to(end);
        let (time, held, x) = (context.time, context.held, context.x);
        state.set(time, &held, &x);
        outcome
    }

    /// Something may have been changed from outside.
    fn forget(&mut self) {
        self.method.restart();
        self.detector.forget();
        self.history.beginning = None;
    }
}
