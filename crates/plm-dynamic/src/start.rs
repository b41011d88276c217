//! Properties of a mechanism from text before it runs, and the start of its runs.

use plm_runtime::described::Tables;
use plm_runtime::held::Discrete;
use plm_runtime::{Described, Linear, Statics};

use crate::run::{Error, Mechanism, place};
use crate::sizes::{Large, Models, Small, started};

/// Work on the start of a mechanism from text, whatever room the mechanism takes: what is asked once, as modes are. It has two sizes,
/// where [`OnRun`](crate::OnRun) has those that runs are fast in.
pub trait OnStart {
    /// Result of the work.
    type Output;

    /// Does it.
    fn on<M>(self, state: &M::State) -> Self::Output
    where
        M: Described<S = f64, U: Discrete> + Statics + Linear<Lifted<1>: Described + Statics>;
}

impl Mechanism {
    /// Bodies, parts and quantities with their documentation, and the report of the compiler.
    pub fn tables(&self) -> &'static Tables {
        self.models.smallest().description.tables
    }

    /// The declaration, as it was written.
    pub fn declaration(&self) -> &'static str {
        self.models.smallest().description.declaration
    }

    /// Name and SI unit of each number that can be read of a run: of declared outputs and of observed quantities.
    pub fn observables(&self) -> &'static [(&'static str, &'static str)] {
        self.models.smallest().description.observed
    }

    /// Names of the rows of contact.
    pub fn contacts(&self) -> &'static [&'static str] {
        self.models.smallest().labels.contacts
    }

    /// Names of the start values: x, y, angle, vx, vy, omega of the origin of each body, then first-order states.
    pub fn starts(&self) -> &'static [&'static str] {
        self.models.smallest().names_of_starts
    }

    /// The start values of the declaration with the parameters as they are, SI.
    pub fn declared_starts(&self) -> Vec<f64> {
        let own: Large = self.given.mechanism(self.models.smallest());
        let starts = own.declared_starts();
        starts.values.iter().take(self.starts().len()).map(|start| start.value).collect()
    }

    /// Assembles it, and does something with its start.
    ///
    /// # Errors
    /// As [`start_with`](Self::start_with).
    pub fn at_start<W: OnStart>(&self, work: W) -> Result<W::Output, Error> {
        self.all_given()?;
        Ok(match self.models {
            Models::Tiny([_, model], _) | Models::Small(model, _) => {
                work.on::<Small>(&started(model, &self.given)?)
            }
            Models::Large(model) => work.on::<Large>(&started(model, &self.given)?),
        })
    }

    /// Gives a start value, SI; assembly keeps it where the declaration locks it.
    ///
    /// # Errors
    /// [`Error::Unknown`].
    pub fn set_start(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let place = place("start value", name, self.starts().iter().copied())?;
        self.given.starts[place] = Some(value);
        Ok(())
    }

    /// Sets the time, s, at which runs begin; without it they begin at 0.
    pub fn set_time(&mut self, time: f64) {
        self.given.time = time;
    }

    /// Has every parameter a value?
    pub(crate) fn all_given(&self) -> Result<(), Error> {
        let mut all = self.lowered().parameters.iter().zip(&self.given.parameters);
        match all.find(|(param, given)| param.default.is_none() && given.is_none()) {
            Some((param, _)) => Err(Error::NotGiven(param.name.clone())),
            None => Ok(()),
        }
    }
}
