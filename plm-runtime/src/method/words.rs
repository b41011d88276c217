//! Methods with steps of fixed length as words; [`Embedded`](super::Embedded) pairs are beside their code.
//!
//! Options, and the data that one step leaves for the next; without the partition of an interval, which is made
//! for each interval.

use super::{FixedStep, Formula, Ros34Pw2};
use crate::scalar::Real;
use crate::words::{InWords, Words};

impl<S: Real, F: Formula> InWords for FixedStep<S, F> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.longest_step, &mut self.tolerance]);
        words.count(&mut self.check_every);
        words.flag(&mut self.was_unhealthy);
        words.count(&mut self.until_check);
    }
}

impl<S: Real> InWords for Ros34Pw2<S> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.longest_step, &mut self.tolerance, &mut self.worst_error]);
    }
}
