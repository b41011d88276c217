//! Runs by whatever method, of one type: their code is that of `plm-dynamic`, which is optimised and there once.

use plm_run::{AnyMethod, AnySim};
use plm_runtime::{Dop853, Fault, Linear, Mechanism};

/// Begins such runs.
pub(crate) trait By: Mechanism + Linear {
    /// Assembles it, for runs by a method.
    ///
    /// # Errors
    /// As [`Mechanism::start`].
    fn by(self, method: impl Into<AnyMethod<Self>>) -> Result<AnySim<Self>, Fault> {
        self.start_with(method.into())
    }

    /// Assembles it, for runs by the default method.
    ///
    /// # Errors
    /// As [`Mechanism::start`].
    fn begin(self) -> Result<AnySim<Self>, Fault> {
        self.by(Dop853::default())
    }
}

impl<M: Mechanism + Linear> By for M {}
