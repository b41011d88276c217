//! Adams' formulas as words.

use super::{Adams, MOST, Past};
use crate::scalar::Real;
use crate::system::System;
use crate::words::{InWords, Words};

/// Options, and all data that decide the next step; without the last step, which serves states within it.
impl<M: System<S: Real>> InWords for Adams<M> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.rtol, &mut self.longest_step]);
        words.word(&mut self.most_steps);
        self.past.each(words);
        words.flag(&mut self.forgotten);
        words.number(&mut self.projection.residue);
        words.flag(&mut self.by_error);
    }
}

impl<M: System<S: Real>> InWords for Past<M> {
    fn each(&mut self, words: &mut impl Words) {
        let Self { differences, coefficients: by, made, next, begins, rejected } = self;
        for vector in differences.rows.iter_mut().chain([&mut differences.last]) {
            words.vector(vector);
        }
        words.index(&mut differences.due);
        let rows = [&mut by.psi, &mut by.alpha, &mut by.beta, &mut by.sigma];
        for row in rows.into_iter().chain([&mut by.once, &mut by.twice, &mut by.kept]) {
            words.numbers(row);
        }
        words.number(&mut by.last);
        words.index(&mut by.order);
        words.index(&mut by.equal);
        words.index(made);
        words.index(&mut next.order);
        words.number(&mut next.h);
        words.flag(begins);
        words.count(rejected);
        // Whatever was read, no row is accessed beyond the last.
        differences.due = differences.due.min(MOST + 2);
        (by.order, by.equal) = (by.order.min(MOST), by.equal.min(MOST + 1));
        (*made, next.order) = ((*made).min(MOST), next.order.clamp(1, MOST));
    }
}
