//! Samples of a run: at equal intervals, before and after what switches, and where it fails.

use core::cell::Cell;
use core::ops::ControlFlow;

use plm_runtime::described::by_number;
use plm_runtime::sim::Seen;
use plm_runtime::{BodyState, Described, Fault, Method, Moment, Sim};

/// Numbers of a run at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The time, s.
    pub time: f64,
    /// Poses and velocities of the centres of gravity, in the order of [`Run::bodies`](crate::Run::bodies).
    pub bodies: Vec<BodyState<f64>>,
    /// The numbers of [`Run::all_columns`](crate::Run::all_columns), in their units.
    pub values: Vec<f64>,
}

/// Takes a sample, and says whether the run goes on.
pub(crate) type See<'a> = &'a mut dyn FnMut(&Sample) -> ControlFlow<()>;

impl Sample {
    fn of<M: Described<S = f64>>(state: &M::State) -> Self {
        let outputs = by_number::shown(state.mechanism()).enumerate();
        let values = outputs.map(|(k, output)| {
            let value = M::observed(state, k).unwrap_or(f64::NAN);
            output.map_or(value, |(_, output)| value / output.factor)
        });
        let mut sample = Sample { time: state.time(), bodies: Vec::new(), values: values.collect() };
        M::poses(state, &mut |pose| sample.bodies.push(pose));
        sample
    }

    /// Is it the same moment to the bit?
    fn is(&self, other: &Sample) -> bool {
        fn bits(sample: &Sample) -> impl Iterator<Item = u64> {
            let poses = sample.bodies.iter().flat_map(|body| body.components());
            [sample.time].into_iter().chain(poses).chain(sample.values.iter().copied()).map(f64::to_bits)
        }
        bits(self).eq(bits(other))
    }
}

/// Samples that were handed out, as the recorder of compiled programs chooses them.
struct Samples<'a> {
    see: See<'a>,
    last: Option<Sample>,
    /// Time of what has switched, until a sample shows it.
    switched: Option<f64>,
    goes_on: &'a Cell<bool>,
}

impl Samples<'_> {
    /// Hands a moment out. What is seen for several reasons is one sample.
    fn take<M: Described<S = f64>>(&mut self, state: &M::State) {
        let sample = Sample::of::<M>(state);
        if self.last.as_ref().is_some_and(|last| last.is(&sample)) {
            return;
        }
        self.switched = None;
        if self.goes_on.get() && (self.see)(&sample).is_break() {
            self.goes_on.set(false);
        }
        self.last = Some(sample);
    }

    fn seen<M: Described<S = f64>>(&mut self, seen: Seen<'_, M::State>) {
        match seen {
            Seen::Sample(state) | Seen::Switched(state) => self.take::<M>(state),
            // Of what switches at one time there is one sample before it.
            Seen::Condition(_, before) | Seen::Instant(before) => {
                if self.switched.is_none_or(|time| time.to_bits() != before.time().to_bits()) {
                    self.take::<M>(before);
                }
                self.switched = Some(before.time());
            }
            _ => {}
        }
    }
}

/// Runs until a time with a sample every so often, s; a run that fails has one where it ended.
pub(crate) fn record<M: Described<S = f64>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    (until, every): (f64, f64),
    see: See,
) -> Result<(), Fault> {
    let goes_on = Cell::new(true);
    let mut samples = Samples { see, last: None, switched: None, goes_on: &goes_on };
    let outcome =
        Sim::watch_events_while(sim, until, every, |seen| samples.seen::<M>(seen), |_| goes_on.get());
    if outcome.is_err() {
        samples.take::<M>(sim.state());
    }
    outcome
}
