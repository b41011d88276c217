//! A run as bytes, for files and for other processes: the format of [`plm_foreign::saved`], with the method before what it shows.

use plm_foreign::{Error, Foreign, Status, saved};
use plm_run::Integrator;
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Moment, Vector};

use super::{Run, Runnable};

/// Says that what follows is a run of Python, whose method may be any.
const MARK: u64 = u64::from_le_bytes(*b"python\0\0");

impl<M: Runnable + Foreign> Run<M> {
    /// Everything that decides how the run goes on.
    ///
    /// # Errors
    /// [`Status::Memory`]
    pub fn save(&self) -> Result<Vec<u8>, Error> {
        let own = Saved { mark: MARK, run: self.clone() };
        let mut bytes = vec![0; saved::size(own.clone())];
        saved::write::<M, _>(&own, &mut bytes)?;
        Ok(bytes)
    }

    /// A run as it was saved, of a declared mechanism: it goes on with the same bits, on every machine.
    ///
    /// # Errors
    /// [`Status::Damaged`], [`Status::OtherVersion`], [`Status::OtherMechanism`]
    pub fn saved(declared: M, bytes: &[u8]) -> Result<Self, Error> {
        let unstarted = M::State::new(declared, declared.unstarted(), 0.0, M::X::fill(0.0));
        Self(Box::new(Integrator::default().of(unstarted))).like(bytes)
    }

    /// A run as it was saved, of the same mechanism as this one, which stays as it is.
    ///
    /// # Errors
    /// As [`saved`](Self::saved).
    pub fn like(&self, bytes: &[u8]) -> Result<Self, Error> {
        let mut read = Saved { mark: MARK, run: self.clone() };
        saved::read::<M>(&mut read, bytes)?;
        if read.mark == MARK { Ok(read.run) } else { Err(Status::OtherMechanism.into()) }
    }
}

#[derive(Clone)]
struct Saved<M: Runnable + Foreign> {
    mark: u64,
    run: Run<M>,
}

impl<M: Runnable + Foreign> InWords for Saved<M> {
    fn each(&mut self, words: &mut impl Words) {
        words.word(&mut self.mark);
        self.run.0.each(words);
    }
}
