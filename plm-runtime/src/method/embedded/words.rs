//! An embedded pair as words.

use super::{Embedded, Pair};
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Options, and the data that decide the next step; without the last step, whose stages serve states within
/// it.
impl<M: System<S: Real>, P: Pair> InWords for Embedded<M, P> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.rtol, &mut self.longest_step]);
        words.word(&mut self.most_steps);
        self.pace.each(words);
        words.perhaps(&mut self.rate, M::X::fill(M::S::ZERO), Words::vector);
        words.flag(&mut self.was_unhealthy);
        words.number(&mut self.projection.residue);
        words.flag(&mut self.by_error);
    }
}
