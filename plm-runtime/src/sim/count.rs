//! Which states limit the steps.

use super::Sim;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;
use crate::vector::Vector;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Counts from now on which state limits each step, or ends that; to begin the count anew, ask again.
    ///
    /// It takes a look at every component of the error estimate after each step, and is off at first.
    pub fn count_states(&mut self, count: bool) {
        self.history.counts = count.then(|| M::X::fill(M::S::ZERO));
    }

    /// Every state with its name (`arm.angle`, `arm.omega`, `valve.flow`) and the number of steps that it has limited since
    /// [`count_states`](Self::count_states): in which its part of the error estimate was the largest. Where loops change
    /// charts the names of all are told, `crank.angle or rocker.angle`.
    ///
    /// Steps whose length had another reason count for no state: the end of an interval, a switch, a longest step. So do those
    /// of methods with steps of equal length.
    pub fn state_count(&self) -> impl Iterator<Item = (&'static str, u64)> {
        let (mechanism, counts) = (self.state.mechanism(), self.history.counts);
        (0..M::X::LEN).map(move |i| {
            let count = counts.map_or(0.0, |counts| counts.at(i).to_f64());
            (mechanism.name_of_state(i), count as u64)
        })
    }
}
