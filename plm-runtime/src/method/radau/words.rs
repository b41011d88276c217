//! Radau IIA as words.

use super::RadauIia5;
use super::dense::Dense;
use crate::linalg::Derivatives as _;
use crate::linear::Linear;
use crate::scalar::Scalar;
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Options, and all data that decide the next step; without the decompositions, which follow from the
/// derivatives.
impl<M: Linear> InWords for RadauIia5<M> {
    fn each(&mut self, words: &mut impl Words) {
        let (zero, none) = (M::S::ZERO, M::X::fill(M::S::ZERO));
        words.numbers([&mut self.rtol, &mut self.longest_step]);
        words.word(&mut self.most_steps);
        words.perhaps(&mut self.proposal, zero, Words::number);
        words.perhaps(&mut self.control.last, (zero, zero), |words, (h, error)| words.numbers([h, error]));
        words.flag(&mut self.control.rejected);
        self.steady.each(words);
        words.numbers([&mut self.convergence.rest, &mut self.convergence.theta]);
        words.perhaps(&mut self.rate, none, Words::vector);
        self.by_x.in_words(words);
        words.flag(&mut self.by_x_known);
        words.flag(&mut self.by_x_here);
        words.number(&mut self.factors.h);
        words.flag(&mut self.factors.known);
        self.factors.again(&self.by_x);
        let dense = Dense { end: zero, h: zero, to: none, projected: none, differences: [none; 3] };
        words.perhaps(&mut self.dense, dense, |words, dense| {
            words.numbers([&mut dense.end, &mut dense.h]);
            let vectors = [&mut dense.to, &mut dense.projected].into_iter().chain(&mut dense.differences);
            for vector in vectors {
                words.vector(vector);
            }
        });
        words.number(&mut self.projection.residue);
        words.flag(&mut self.by_error);
    }
}
