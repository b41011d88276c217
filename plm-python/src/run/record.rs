//! A run that is recorded: columns of quantities, and what has switched.

use plm_foreign::Kind;
use plm_run::OnSim;
use plm_runtime::{Fault, Method, Moment, Seen, Sim};

use super::{Runnable, number};

/// What a run has come to.
pub struct Record {
    /// The times, s, then a column of each quantity that was asked for, SI.
    pub columns: Vec<Vec<f64>>,
    /// When something switched, s, and what.
    pub events: Vec<(f64, &'static str)>,
}

impl Record {
    pub(super) fn new(quantities: usize) -> Self {
        Self { columns: vec![Vec::new(); 1 + quantities], events: Vec::new() }
    }

    /// Adds a row.
    pub(super) fn take<M: Runnable>(&mut self, state: &M::State, quantities: &[(Kind, usize)]) {
        let value = |(kind, index): &(Kind, usize)| number::<M>(state, *kind, *index).unwrap_or(f64::NAN);
        let values = quantities.iter().map(value);
        for (column, value) in self.columns.iter_mut().zip(std::iter::once(state.time()).chain(values)) {
            column.push(value);
        }
    }

    /// The time of the last row, s.
    pub(super) fn last(&self) -> Option<f64> {
        self.columns.first()?.last().copied()
    }
}

/// Runs until a time and takes a row every so many seconds.
pub(super) struct Recorded<'a> {
    pub(super) times: (f64, f64),
    pub(super) quantities: &'a [(Kind, usize)],
    pub(super) record: &'a mut Record,
    pub(super) goes_on: &'a mut dyn FnMut(f64) -> bool,
}

impl<M: Runnable> OnSim<M> for Recorded<'_> {
    type Output = Result<(), Fault>;

    fn on<I: Method<M>>(self, sim: &mut Sim<M, I>) -> Self::Output {
        let Self { times: (until, every), quantities, record, goes_on } = self;
        let see = |seen: Seen<'_, M::State>| match seen {
            Seen::Sample(state) => record.take::<M>(state, quantities),
            Seen::Condition(index, before) => {
                record.events.push((before.time(), before.mechanism().guard_name(index)));
            }
            Seen::Instant(before) => {
                let name = before.mechanism().instant_name(before.time(), &before.held());
                record.events.push((before.time(), name));
            }
            _ => {}
        };
        Sim::watch_while(sim, until, every, see, goes_on)
    }
}
