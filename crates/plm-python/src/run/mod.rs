//! Runs of a mechanism for a Python package: numbers by index, a method by its name, and interruption during a run.
//!
//! `plm::view::wheel` writes such a package. The package `plm` of Python has runs of mechanisms from text.

mod method;
mod record;
mod running;
mod saved;
mod state;
mod words;

use plm_foreign::{Error, Kind, Status};
use plm_run::AnySim;
use plm_runtime::described::by_number;
use plm_runtime::held::Discrete;
use plm_runtime::{Described, Linear, Moment, StartValues, Statics};

pub use method::method;
pub use plm_run::{BadOption, Integrator};
pub use record::{Asked, NoRoom, Record, room, rows};
pub use running::{Running, Work};
pub use words::words;

/// Mechanisms that can run for Python: all in `f64`.
pub trait Runnable:
    Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>
{
}

impl<M> Runnable for M where
    M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>
{
}

/// A run of a compiled mechanism. A copy goes on as the original does, to the bit.
#[derive(Clone)]
pub struct Run<M: Runnable>(Box<AnySim<M>>);

/// Numbers by index, SI.
pub type Numbers = [(usize, f64)];

impl<M: Runnable> Run<M> {
    /// Sets parameters of a declared mechanism, makes the start values of them, sets those that are given, and assembles at a
    /// time, s.
    ///
    /// # Errors
    /// [`Status::NotFinite`], [`Status::NoSuch`]; as [`start_state`](plm_runtime::Mechanism::start_state).
    pub fn start(
        declared: M,
        method: Integrator,
        (parameters, starts): (&Numbers, &Numbers),
        time: f64,
    ) -> Result<Self, Error> {
        let mut mechanism = declared;
        finite(time)?;
        for (index, value) in parameters {
            found(mechanism.set_parameter(*index, finite(*value)?).then_some(()))?;
        }
        let mut values = mechanism.declared_starts();
        for (index, value) in starts {
            finite(*value)?;
            let (mut at, mut is_there) = (0, false);
            values.each(&mut |_, start| {
                if at == *index {
                    start.value = *value;
                    is_there = true;
                }
                at += 1;
            });
            found(is_there.then_some(()))?;
        }
        *mechanism.starts_mut() = values;
        Ok(Self(Box::new(method.start_at(mechanism, time)?)))
    }
}

impl<M: Runnable> Running for Run<M> {
    fn then<W: Work>(&mut self, work: W) -> W::Output {
        work.on(&mut *self.0)
    }
}

/// A number at a moment, SI.
fn number<M: Runnable>(state: &M::State, kind: Kind, index: usize) -> Option<f64> {
    match kind {
        Kind::Parameter => state.mechanism().parameter(index),
        Kind::Input => by_number::input::<M>(state, index),
        Kind::State => M::state(state, index),
        Kind::Output => M::observed(state, index),
        Kind::Contact => M::contacts(&state.held()).mode(index).map(|mode| mode.number() as f64),
        _ => None,
    }
}

fn found<T>(found: Option<T>) -> Result<T, Error> {
    found.ok_or(Status::NoSuch.into())
}

fn finite(value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Status::NotFinite.into()) }
}
