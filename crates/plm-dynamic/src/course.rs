//! Inputs that change while a mechanism runs, at times that are known.

use plm_runtime::described::by_number;
use plm_runtime::{Described, Fault, Method, Moment, Sim};

use crate::record::{Watch, record_driven};
use crate::run::{Error, Run};
use crate::running::OnRun;

/// An input that changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// When, s.
    pub time: f64,
    /// Its number among [`Mechanism::inputs`](crate::Mechanism::inputs).
    pub input: usize,
    /// Its value from then on, SI.
    pub value: f64,
}

/// Changes of inputs in the order of their times, and which of them were made.
#[derive(Clone, Debug, Default)]
pub struct Course {
    changes: Vec<Change>,
    made: usize,
}

impl Course {
    /// The course of these changes.
    pub fn new(mut changes: Vec<Change>) -> Self {
        changes.sort_by(|a, b| a.time.total_cmp(&b.time));
        Self { changes, made: 0 }
    }

    /// Changes nothing?
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Makes the changes that are due, and gives the time of the next one, s: what [`Sim::watch_driven`] asks.
    pub fn drive<M: Described<S = f64>, I: Method<M>>(&mut self, sim: &mut Sim<M, I>) -> f64 {
        let time = sim.state().time();
        while let Some(change) = self.changes.get(self.made) {
            if change.time > time {
                return change.time;
            }
            by_number::set_input(sim, change.input, change.value);
            self.made += 1;
        }
        f64::INFINITY
    }
}

/// Runs to a time, s, with samples so often, s, and with one at the end.
struct RecordDriven<'a> {
    times: (f64, f64),
    course: &'a mut Course,
    watch: &'a mut dyn Watch,
}

impl OnRun for RecordDriven<'_> {
    type Output = Result<(), Fault>;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let Self { times, course, watch } = self;
        record_driven(sim, times, |sim| course.drive(sim), watch)
    }
}

impl Run {
    /// Runs as [`watch`](Self::watch) with inputs that follow a course: an internal step ends at each change, and a sample at its time shows
    /// what holds from then on.
    ///
    /// # Errors
    /// [`Error::Fault`]; the last sample is where the run ended.
    pub fn watch_driven(
        &mut self,
        until: f64,
        every: f64,
        course: &mut Course,
        watch: &mut dyn Watch,
    ) -> Result<(), Error> {
        Ok(self.then(RecordDriven { times: (until, every), course, watch })?)
    }
}
