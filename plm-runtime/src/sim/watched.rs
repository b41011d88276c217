//! A run that shows what happens on its way.

use super::Sim;
use super::samples::{Samples, Seen, Watcher};
use crate::fault::Fault;
use crate::mechanism::Mechanism;
use crate::method::Method;
use crate::scalar::Scalar;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Runs as [`run`](Self::run), and shows more: communication points, the end of every internal step, and what switches.
    /// It has the same bits. To be called as `Sim::watch(&mut sim, …)`, so that it hides no output of this name.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn watch(
        this: &mut Self,
        until: M::S,
        every: M::S,
        mut see: impl FnMut(Seen<'_, M::State>),
    ) -> Result<(), Fault> {
        let times = this.times(until, every)?;
        see(Seen::Sample(&this.state));
        let one = M::S::lit(1.0);
        let samples = Samples { times, next: one, moment: this.state };
        let mut watcher = Watcher { samples, see };
        if !I::DENSE {
            let mut k = one;
            while k <= times.last {
                this.advance(times.at(k), every, &mut watcher)?;
                k = k + one;
            }
        }
        this.advance(until, until - times.start, &mut watcher)
    }
}
