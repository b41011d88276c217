//! Records any mechanism.

use core::marker::PhantomData;

use crate::described::{mechanism, numbers};
use crate::recording::{self, Column, Recording, Row};
use plm_runtime::described::{Quantity, by_number};
use plm_runtime::sim::Seen;
use plm_runtime::{AsMoment, Described, Fault, Method, Moment, Scalar, Sim, System};

/// Takes poses and quantities of a mechanism while it runs: at communication points, before and after what switches, and at
/// every internal step if asked.
///
/// The recording belongs to the recorder, not to the run: after a fault it has everything up to the fault, and the fault.
///
/// ```
/// # plm::mechanism! {
/// #     pub Pendulum {
/// #         gravity: 9.81 m/s^2;
/// #         ground { port o: (0, 0) m; }
/// #         body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
/// #         revolute hinge(ground.o, bob.pivot);
/// #         output bob.angle in deg, hinge.force;
/// #     }
/// # }
/// use plm::view::{Recorder, Results};
///
/// fn main() -> Result<(), Box<dyn std::error::Error>> {
///     let mut sim = Pendulum::new().start()?;
///     let mut recorder = Recorder::new(&sim);
///     recorder.run(&mut sim, 4.0, 0.01)?;
///     let path = std::env::temp_dir().join("plm-recorder-doc/pendulum.npz");
///     recorder.recording().write(&path)?;
///
///     let run = &Results::read(&path)?.runs[0];
///     assert_eq!((run.len(), run.about.mechanism.bodies[0].mass), (401, 1.0));
///     assert_eq!(run.poses(400)[0][2], sim.bob().angle);
///     # std::fs::remove_dir_all(path.parent().unwrap())?;
///     Ok(())
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Recorder<M> {
    recording: Recording,
    quantities: Vec<Taken>,
    steps: bool,
    mechanism: PhantomData<M>,
}

/// A row that is nearer to the end of a run than this part of the interval is there.
const AT_END: f64 = 1e-9;

/// Source of a column.
#[derive(Clone, Copy, Debug)]
enum Taken {
    /// The declared output with this number, in its unit.
    Output(usize),
    /// The observed quantity with this number, SI.
    Observed(usize),
}

impl<M: Described> Recorder<M> {
    /// Records the poses and the declared outputs, in their units, of a mechanism with the parameters that it has now; of a
    /// `Sim` or of a state.
    pub fn new(of: &impl AsMoment<State: Moment<M = M>>) -> Self {
        let outputs = of.as_moment().mechanism().tables().outputs;
        Self::of(
            of.as_moment().mechanism(),
            outputs.iter().map(column),
            (0..outputs.len()).map(Taken::Output).collect(),
        )
    }

    /// Records the poses and these quantities of [`Described::observables`], SI.
    ///
    /// # Errors
    /// The first name that is not there.
    pub fn observing<'n>(
        of: &impl AsMoment<State: Moment<M = M>>,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Result<Self, &'n str> {
        let known = of.as_moment().mechanism().observables();
        let find = |name| known.iter().position(|(own, _)| *own == name).ok_or(name);
        let found: Vec<usize> = names.into_iter().map(find).collect::<Result<_, &str>>()?;
        let columns: Vec<(&str, &str)> = found.iter().map(|k| known[*k]).collect();
        Ok(Self::of(of.as_moment().mechanism(), columns, found.into_iter().map(Taken::Observed).collect()))
    }

    /// Records the poses, the declared outputs in their units, and all other observed quantities in SI.
    pub fn observing_all(of: &impl AsMoment<State: Moment<M = M>>) -> Self {
        Self::describing(of.as_moment().mechanism())
    }

    /// Describes a mechanism that may have no start: its names, its shapes and its columns, before any row.
    pub fn describing(mechanism: &M) -> Self {
        let all = by_number::shown(mechanism).zip(mechanism.observables()).enumerate();
        let (columns, quantities): (Vec<Column>, Vec<Taken>) = all
            .map(|(k, (output, observed))| match output {
                Some((number, row)) => (column(row), Taken::Output(number)),
                None => (Column::from(*observed), Taken::Observed(k)),
            })
            .unzip();
        Self::of(mechanism, columns, quantities)
    }

    fn of<C: Into<Column>>(of: &M, columns: impl IntoIterator<Item = C>, quantities: Vec<Taken>) -> Self {
        let recording = Recording::of(mechanism(of), columns);
        Self { recording, quantities, steps: false, mechanism: PhantomData }
    }

    /// Sets the name, which distinguishes the run from other runs in a file.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.recording.about.name = name.into();
        self
    }

    /// Records every internal step of the method as well.
    #[must_use]
    pub fn with_steps(mut self) -> Self {
        self.steps = true;
        self
    }

    /// Runs until the time `until` and records every `every`, in s; the run has the bits of [`Sim::run`]. It may be called
    /// again, to go on.
    ///
    /// # Errors
    /// As [`Sim::run`]; the recording has what came before, and the fault.
    pub fn run<I: Method<M>>(&mut self, sim: &mut Sim<M, I>, until: M::S, every: M::S) -> Result<(), Fault> {
        self.run_seen(sim, until, every, &mut |_| {})
    }

    /// Runs as [`run`](Self::run) does, and gives `told` the time of every step.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_seen<I: Method<M>>(
        &mut self,
        sim: &mut Sim<M, I>,
        until: M::S,
        every: M::S,
        told: &mut impl FnMut(M::S),
    ) -> Result<(), Fault> {
        self.run_while(sim, until, every, &mut |time| {
            told(time);
            true
        })
    }

    /// Runs as [`run`](Self::run) does, as long as `goes_on` says so, which is asked with the time of every step. The last row is
    /// where the run ends.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_while<I: Method<M>>(
        &mut self,
        sim: &mut Sim<M, I>,
        until: M::S,
        every: M::S,
        goes_on: &mut impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        self.begin(sim);
        let outcome = Sim::watch_while(sim, until, every, |seen| self.see(seen), goes_on);
        self.end(sim, every, outcome)
    }

    /// Runs as [`run_while`](Self::run_while) with inputs that `drive` changes on the way, as in [`Sim::watch_driven`]; without internal
    /// steps.
    ///
    /// # Errors
    /// As [`Sim::watch_driven`].
    pub fn run_driven<I: Method<M>>(
        &mut self,
        sim: &mut Sim<M, I>,
        until: M::S,
        every: M::S,
        drive: &mut impl FnMut(&mut Sim<M, I>) -> M::S,
        goes_on: &mut impl FnMut(M::S) -> bool,
    ) -> Result<(), Fault> {
        self.begin(sim);
        let outcome = Sim::watch_driven(sim, until, every, drive, |seen| self.see(seen), goes_on);
        self.end(sim, every, outcome)
    }

    /// Describes the run that is about to begin: its method, and no fault. Runs of the recorder do so by themselves.
    pub fn begin<I: Method<M>>(&mut self, sim: &Sim<M, I>) {
        self.recording.about.method = method(sim.method());
        self.recording.about.fault = None;
    }

    /// Records where a run has ended, and how.
    fn end<I: Method<M>>(
        &mut self,
        sim: &Sim<M, I>,
        every: M::S,
        outcome: Result<(), Fault>,
    ) -> Result<(), Fault> {
        let shown = self.recording.times().last().copied().unwrap_or(f64::NEG_INFINITY);
        let is_missing = sim.state().time().to_f64() - shown > AT_END * every.to_f64();
        if outcome.is_err() || is_missing {
            // As far as it came.
            self.take(sim.state());
        }
        if let Err(fault) = &outcome {
            let (part, text) = (fault.part.to_owned(), fault.cause.to_string());
            self.recording.about.fault = Some(recording::Fault { time: fault.time, part, text });
        }
        self.recording.about.notices = Sim::notices(sim).map(|notice| notice.to_string()).collect();
        outcome
    }

    /// Adds a moment by hand.
    pub fn take(&mut self, state: &M::State) {
        let (time, mut poses, mut ground) = (state.time(), Vec::new(), Vec::new());
        M::poses(state, &mut |pose| {
            poses.extend(pose.components().map(Scalar::to_f64));
        });
        if self.recording.about.mechanism.ground_moves() {
            let ports = 0..state.mechanism().tables().ground.len();
            ground.extend(ports.flat_map(|k| numbers(state.mechanism().ground(time, k))));
        }
        let values = self.values(state);
        let row = Row { time: time.to_f64(), poses: &poses, ground: &ground, values: &values };
        // A moment that is seen for several reasons is one row.
        if !self.recording.ends_with(&row) {
            self.recording.push_row(&row);
        }
    }

    /// The columns at a moment.
    fn values(&self, state: &M::State) -> Vec<f64> {
        let mut outputs = Vec::new();
        if self.quantities.iter().any(|taken| matches!(taken, Taken::Output(_))) {
            M::outputs(state, &mut |output| outputs.push(output.to_f64()));
        }
        let observed = self.quantities.iter().filter_map(|taken| match *taken {
            Taken::Observed(k) => Some(k),
            Taken::Output(_) => None,
        });
        let mut seen = Vec::new();
        M::observe(state, observed, &mut |value| seen.push(value.map_or(f64::NAN, Scalar::to_f64)));
        let mut seen = seen.into_iter();
        let value = |taken: &Taken| match *taken {
            Taken::Output(k) => outputs.get(k).copied().unwrap_or(f64::NAN),
            Taken::Observed(_) => seen.next().unwrap_or(f64::NAN),
        };
        self.quantities.iter().map(value).collect()
    }

    fn see(&mut self, seen: Seen<'_, M::State>) {
        match seen {
            Seen::Sample(state) | Seen::Switched(state) => self.take(state),
            Seen::Step(state) if self.steps => self.take(state),
            Seen::Condition(index, before) => {
                self.event(before, before.mechanism().guard_name(index));
            }
            Seen::Instant(before) => {
                let name = before.mechanism().instant_name(before.time(), &before.held());
                self.event(before, name);
            }
            _ => {}
        }
    }

    /// Something switches at the end of this moment.
    fn event(&mut self, before: &M::State, what: &str) {
        let time = before.time().to_f64();
        // Of several at once the first has its row.
        let is_new =
            self.recording.about.events.last().is_none_or(|last| last.row.is_some() || last.time != time);
        if is_new {
            self.take(before);
        }
        self.recording.push_event(time, what);
    }

    /// The recording so far.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// Becomes the recording.
    pub fn into_recording(self) -> Recording {
        self.recording
    }
}

/// The column of an output.
fn column(output: &Quantity) -> Column {
    let factor = (output.factor != 1.0).then_some(output.factor);
    Column { factor, ..Column::from((output.name, output.unit)) }
}

/// Text of a method: `Dop853, relative tolerance 1e-9`.
fn method<M: System, I: Method<M>>(method: &I) -> String {
    match method.tolerance() {
        Some(tolerance) => format!("{}, relative tolerance {:e}", method.name(), tolerance.to_f64()),
        None => method.name().to_owned(),
    }
}
