//! Counters of the states that limit the steps.

use super::Sim;
use crate::mechanism::{Mechanism, Moment};
use crate::method::Method;
use crate::scalar::Scalar;
use crate::vector::Vector;

impl<M: Mechanism, I: Method<M>> Sim<M, I> {
    /// Starts counting, for each state, the steps that it limits (`true`; restarts the counts), or ends counting (`false`).
    ///
    /// Counting reads every component of the error estimate after each step; it is off at first.
    pub fn count_states(&mut self, count: bool) {
        self.history.counts = count.then(|| M::X::fill(M::S::ZERO));
    }

    /// All states with their names (`arm.angle`, `arm.omega`, `valve.flow`) and the number of steps that each has limited
    /// since [`count_states`](Self::count_states): the steps in which its component of the error estimate was the largest.
    /// Loops that change charts have the names of all candidates, `crank.angle or rocker.angle`.
    ///
    /// Steps count for no state if their length had another reason (end of an interval, switch, longest step) or if the method
    /// has steps of fixed length.
    pub fn state_count(&self) -> impl Iterator<Item = (&'static str, u64)> {
        let (mechanism, counts) = (self.state.mechanism(), self.history.counts);
        (0..M::X::LEN).map(move |i| {
            let count = counts.map_or(0.0, |counts| counts.at(i).to_f64());
            (mechanism.name_of_state(i), count as u64)
        })
    }
}
