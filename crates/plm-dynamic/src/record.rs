//! Samples of a run: at equal intervals, before and after what switches, and where it fails.

use core::cell::RefCell;
use core::ops::ControlFlow;

use plm_runtime::described::{Place, by_number};
use plm_runtime::sim::Seen;
use plm_runtime::{BodyState, Described, Fault, Method, Moment, Sim};

/// Numbers of a run at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The time, s.
    pub time: f64,
    /// Poses and velocities of the centres of gravity, in the order of [`Run::bodies`](crate::Run::bodies).
    pub bodies: Vec<BodyState<f64>>,
    /// x, y (m) and angle (rad) of each port of the ground.
    pub ground: Vec<[f64; 3]>,
    /// The numbers of [`Run::all_columns`](crate::Run::all_columns), in their units.
    pub values: Vec<f64>,
}

/// Why a sample is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Its time is a multiple of the interval, or that of the start.
    Interval,
    /// Something switches at its time: it stands before or after that.
    Event,
    /// The run ends there.
    End,
}

/// Observer of a run in progress.
pub trait Watch {
    /// A sample.
    fn sample(&mut self, sample: &Sample, reason: Reason);

    /// Something switches at a time, s: the name of the condition, the part or the row.
    fn event(&mut self, time: f64, what: &str) {
        let _ = (time, what);
    }

    /// Does the run go on after an internal step to this time, s?
    fn goes_on(&mut self, time: f64) -> bool {
        let _ = time;
        true
    }
}

/// Samples for a function, which says whether the run goes on.
pub(crate) struct Seeing<F>(pub(crate) F, pub(crate) ControlFlow<()>);

impl<F: FnMut(&Sample) -> ControlFlow<()>> Watch for Seeing<F> {
    fn sample(&mut self, sample: &Sample, _: Reason) {
        if self.1.is_continue() {
            self.1 = (self.0)(sample);
        }
    }

    fn goes_on(&mut self, _: f64) -> bool {
        self.1.is_continue()
    }
}

/// A time that is nearer to the end than this part of the interval is the end.
const AT_END: f64 = 1e-9;

impl Sample {
    fn of<M: Described<S = f64>>(state: &M::State) -> Self {
        let (mechanism, time) = (state.mechanism(), state.time());
        let ports = 0..mechanism.tables().ground.len();
        let ground = ports.map(|port| Place::components(mechanism.ground(time, port))).collect();
        let mut sample = Sample { time, bodies: Vec::new(), ground, values: Vec::new() };
        by_number::all_shown::<M>(state, &mut |value| sample.values.push(value));
        M::poses(state, &mut |pose| sample.bodies.push(pose));
        sample
    }

    /// Is it the same moment to the bit?
    fn is(&self, other: &Sample) -> bool {
        fn bits(sample: &Sample) -> impl Iterator<Item = u64> {
            let poses = sample.bodies.iter().flat_map(|body| body.components());
            let ground = sample.ground.iter().flatten().copied();
            [sample.time]
                .into_iter()
                .chain(poses)
                .chain(ground)
                .chain(sample.values.iter().copied())
                .map(f64::to_bits)
        }
        bits(self).eq(bits(other))
    }
}

/// Samples that were handed out, as the recorder of compiled programs chooses them.
struct Samples<'a, 'b> {
    watch: &'a RefCell<&'b mut (dyn Watch + 'b)>,
    last: Option<Sample>,
    /// Time of what has switched, until a sample shows it.
    switched: Option<f64>,
}

impl Samples<'_, '_> {
    /// Hands a moment out. A moment with several reasons is one sample.
    fn take<M: Described<S = f64>>(&mut self, state: &M::State, reason: Reason) {
        let sample = Sample::of::<M>(state);
        if self.last.as_ref().is_some_and(|last| last.is(&sample)) {
            return;
        }
        self.switched = None;
        self.watch.borrow_mut().sample(&sample, reason);
        self.last = Some(sample);
    }

    fn seen<M: Described<S = f64>>(&mut self, seen: Seen<'_, M::State>) {
        match seen {
            Seen::Sample(state) => self.take::<M>(state, Reason::Interval),
            Seen::Switched(state) => self.take::<M>(state, Reason::Event),
            Seen::Condition(index, before) => {
                self.switches::<M>(before, before.mechanism().guard_name(index));
            }
            Seen::Instant(before) => {
                self.switches::<M>(before, before.mechanism().instant_name(before.time(), &before.held()));
            }
            _ => {}
        }
    }

    /// Something switches. Of what does so at one time there is one sample before it.
    fn switches<M: Described<S = f64>>(&mut self, before: &M::State, what: &str) {
        if self.switched.is_none_or(|time| time.to_bits() != before.time().to_bits()) {
            self.take::<M>(before, Reason::Event);
        }
        self.switched = Some(before.time());
        self.watch.borrow_mut().event(before.time(), what);
    }
}

/// Runs until a time with a sample every so often, s; a run that fails has one where it ended, and one that `shows_end` too.
pub(crate) fn record<M: Described<S = f64>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    (until, every): (f64, f64),
    shows_end: bool,
    watch: &mut dyn Watch,
) -> Result<(), Fault> {
    recorded(sim, every, shows_end, watch, |sim, seen, goes_on| {
        Sim::watch_events_while(sim, until, every, seen, goes_on)
    })
}

/// As [`record`], with inputs that `drive` changes when it is called and returns the time of its next call, s; and with a sample at the
/// end.
pub(crate) fn record_driven<M: Described<S = f64>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    (until, every): (f64, f64),
    drive: impl FnMut(&mut Sim<M, I>) -> f64,
    watch: &mut dyn Watch,
) -> Result<(), Fault> {
    recorded(sim, every, true, watch, |sim, seen, goes_on| {
        Sim::watch_driven(sim, until, every, drive, seen, goes_on)
    })
}

/// Hands out what a run shows, and what it ends with.
fn recorded<M: Described<S = f64>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    every: f64,
    shows_end: bool,
    watch: &mut dyn Watch,
    run: impl FnOnce(
        &mut Sim<M, I>,
        &mut dyn FnMut(Seen<'_, M::State>),
        &mut dyn FnMut(f64) -> bool,
    ) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let watch = RefCell::new(watch);
    let mut samples = Samples { watch: &watch, last: None, switched: None };
    let outcome = run(sim, &mut |seen| samples.seen::<M>(seen), &mut |time| watch.borrow_mut().goes_on(time));
    let shown = samples.last.as_ref().map_or(f64::NEG_INFINITY, |last| last.time);
    let is_missing = sim.state().time() - shown > AT_END * every;
    if outcome.is_err() || (shows_end && is_missing) {
        samples.take::<M>(sim.state(), Reason::End);
    }
    outcome
}
