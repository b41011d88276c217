//! Mechanisms and simulations as words.

use super::Described;
use crate::mechanism::Moment;
use crate::method::Method;
use crate::scalar::Scalar;
use crate::sim::Sim;
use crate::start::StartValues as _;
use crate::statics::Statics;
use crate::system::System;
use crate::words::{InWords, Words};

/// Visits everything that decides how a run goes on, in this order: parameters and start values; inputs; the discrete state; time and
/// state; the method; conditions; limits; the clock. Counters ([`stats`](Sim::stats)) and the last step, for states within it, are not
/// included.
impl<M, I> InWords for Sim<M, I>
where
    M: Described + Statics + System<U: InWords>,
    I: Method<M> + InWords,
{
    fn each(&mut self, words: &mut impl Words) {
        self.state = {
            let (state, mut held) = (&self.state, self.state.held());
            let (mut own, mut time, mut x) = (*state.mechanism(), state.time(), *state.x());
            mechanism_in_words(&mut own, words);
            for index in 0..own.input_names().len() {
                if let Some(input) = M::input(M::inputs(&mut held), index) {
                    words.number(input);
                }
            }
            held.each(words);
            words.number(&mut time);
            words.vector(&mut x);
            M::State::new(own, held, time, x)
        };
        self.method.each(words);
        if self.state.mechanism().contact_count() > 0 {
            M::change_contact(self.state.in_place().held, self.method.change());
        }
        self.detector.each(words);
        words.perhaps(&mut self.limits.energy_jump, M::S::ZERO, Words::number);
        words.flag(&mut self.limits.change_points);
        words.numbers([&mut self.clock.time, &mut self.clock.rest, &mut self.longest_step]);
        words.number(&mut self.start_time);
        words.flag(&mut self.changed);
        words.word(&mut self.parameters);
    }
}

/// Shows the parameters of a mechanism and its start values with their locks.
pub fn mechanism_in_words<M: Described + Statics>(mechanism: &mut M, words: &mut impl Words) {
    for index in 0..mechanism.tables().parameters.len() {
        if let Some(parameter) = mechanism.parameter_mut(index) {
            words.number(parameter);
        }
    }
    mechanism.starts_mut().each(&mut |_, start| {
        words.number(&mut start.value);
        words.flag(&mut start.locked);
    });
}
