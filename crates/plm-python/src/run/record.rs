//! A run that is recorded: columns of quantities, and what has switched.

use std::fmt;

use plm_foreign::Kind;
use plm_runtime::{Fault, Method, Moment, Seen, Sim};

use super::{Runnable, number};

/// Request to record a run.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// When it ends, s.
    pub until: f64,
    /// Between two rows, s.
    pub every: f64,
    /// Quantities of those that [`Running::get`](super::Running::get) knows.
    pub quantities: &'a [(Kind, usize)],
    /// Are there the poses and velocities of all bodies after them: x, y, angle, vx, vy, omega of each?
    pub poses: bool,
}

/// More numbers than there is memory for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoRoom {
    rows: f64,
    columns: usize,
}

impl fmt::Display for NoRoom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, columns } = *self;
        let gigabytes = 8e-9 * rows * columns as f64;
        write!(
            f,
            "{rows:.3e} rows of {columns} numbers take {gigabytes:.3e} GB, more than there is: a longer `every`, fewer outputs, or \
             several runs one after the other"
        )
    }
}

/// Is there memory for so many rows, and for copies of them in other languages? Nothing of it is taken.
///
/// # Errors
/// [`NoRoom`]
pub fn room(rows: f64, columns: usize) -> Result<(), NoRoom> {
    let numbers = COPIES * rows * columns as f64;
    let is_there = numbers <= MOST && Vec::<f64>::new().try_reserve_exact(numbers.max(0.0) as usize).is_ok();
    if is_there { Ok(()) } else { Err(NoRoom { rows, columns }) }
}

/// The rows of a run between two times, s, with one every so often, s.
pub fn rows((from, until): (f64, f64), every: f64) -> f64 {
    ((until - from) / every).max(0.0).ceil() + 1.0
}

/// Numbers stand as columns, as bytes, and as what the other language has of these.
const COPIES: f64 = 3.0;
/// No machine has memory for so many: a terabyte. Some systems promise any amount.
const MOST: f64 = 1.3e11;

/// Recorded rows and events of a run.
pub struct Record {
    /// The times, s, then a column of each number that was asked for, SI.
    pub columns: Vec<Vec<f64>>,
    /// Times of events, s, and their names.
    pub events: Vec<(f64, &'static str)>,
}

impl Record {
    /// Adds a row.
    fn take<M: Runnable>(&mut self, state: &M::State, asked: &Asked<'_>) {
        let mut columns = self.columns.iter_mut();
        let mut push = |value| {
            if let Some(column) = columns.next() {
                column.push(value);
            }
        };
        push(state.time());
        let outputs = asked.quantities.iter().filter(|(kind, _)| *kind == Kind::Output);
        let mut values = Vec::new();
        M::observe(state, outputs.map(|(_, index)| *index), &mut |value| values.push(value));
        let mut values = values.into_iter();
        for (kind, index) in asked.quantities {
            let value = match kind {
                Kind::Output => values.next().flatten(),
                _ => number::<M>(state, *kind, *index),
            };
            push(value.unwrap_or(f64::NAN));
        }
        if asked.poses {
            M::poses(state, &mut |pose| pose.components().into_iter().for_each(&mut push));
        }
    }

    /// The time of the last row, s.
    fn last(&self) -> Option<f64> {
        self.columns.first()?.last().copied()
    }
}

/// Runs until a time and takes a row every so many seconds, as long as `goes_on` says so. Where it ended early the last row is where it
/// came to.
pub(super) fn record<M: Runnable, I: Method<M>>(
    sim: &mut Sim<M, I>,
    asked: Asked<'_>,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> (Record, Result<(), Fault>) {
    let bodies = if asked.poses { sim.state().mechanism().tables().bodies.len() } else { 0 };
    let columns = vec![Vec::new(); 1 + asked.quantities.len() + 6 * bodies];
    let mut record = Record { columns, events: Vec::new() };
    let see = |seen: Seen<'_, M::State>| match seen {
        Seen::Sample(state) => record.take::<M>(state, &asked),
        Seen::Condition(index, before) => {
            record.events.push((before.time(), before.mechanism().guard_name(index)));
        }
        Seen::Instant(before) => {
            let name = before.mechanism().instant_name(before.time(), &before.held());
            record.events.push((before.time(), name));
        }
        _ => {}
    };
    let outcome = Sim::watch_events_while(sim, asked.until, asked.every, see, goes_on);
    let time = sim.state().time();
    if record.last().is_some_and(|last| last < time) && time < asked.until {
        record.take::<M>(sim.state(), &asked);
    }
    (record, outcome)
}
