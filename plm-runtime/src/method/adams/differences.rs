//! Modified divided differences of the rates (Shampine and Gordon, chapter 5, eq. (8), and the program STEP).
//!
//! Coordinates have none: their rates are the velocities, and both follow from the same accelerations.

use super::MOST;
use super::coefficients::Coefficients;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// phi_1 to phi_(k+2) for steps of order k. The difference that an accepted step adds to all of them is added with the
/// next prediction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Differences<M: System> {
    pub(super) rows: [M::X; MOST + 2],
    /// Last difference, which is still to be added.
    pub(super) last: M::X,
    /// Number of rows to which it is still to be added.
    pub(super) due: usize,
}

impl<M: System<S: Real>> Differences<M> {
    /// Differences of the present rate alone.
    pub(super) fn new(rate: M::X) -> Self {
        let mut rows = [M::X::fill(M::S::ZERO); MOST + 2];
        rows[0] = rate;
        Self { rows, last: M::X::fill(M::S::ZERO), due: 0 }
    }

    /// phi_i, i from 1, of the last step.
    pub(super) fn at(&self, i: usize) -> M::X {
        let row = self.row(i);
        if i <= self.due { row.map2(&self.last, |s, last| s + last) } else { row }
    }

    fn row(&self, i: usize) -> M::X {
        self.rows.get(i - 1).copied().unwrap_or(self.last)
    }

    /// State at the end of a step of `h` from `x`, by the polynomial through the last rates.
    pub(super) fn predict(
        &mut self,
        (x, h): (&M::X, M::S),
        order: usize,
        coefficients: &Coefficients<M::S>,
    ) -> M::X {
        let before = self.at(order + 1);
        if let Some(row) = self.rows.get_mut(order + 1) {
            *row = before;
        }
        let (one, last) = (M::S::lit(1.0), self.last);
        let [mut once, mut twice, mut above] = [M::X::fill(M::S::ZERO); 3];
        let Coefficients { beta, once: by_once, twice: by_twice, equal, .. } = coefficients;
        for (below, row) in self.rows.iter_mut().enumerate().take(order).rev() {
            let i = below + 1;
            let (beta, g, g_twice) =
                (if i > *equal { beta.at(i) } else { one }, by_once.at(i), by_twice.at(i));
            let due = if i <= self.due { one } else { M::S::ZERO };
            for l in M::NQ..M::X::LEN {
                let s = beta * due.mul_add(last.at(l), row.at(l));
                once.set(l, g.mul_add(s, once.at(l)));
                twice.set(l, g_twice.mul_add(s, twice.at(l)));
                above.set(l, s + above.at(l));
                row.set(l, above.at(l));
            }
        }
        self.due = 0;
        M::X::from_fn(|l| {
            if l < M::NQ {
                h.mul_add(h.mul_add(twice.at(M::NQ + l), x.at(M::NQ + l)), x.at(l))
            } else {
                h.mul_add(once.at(l), x.at(l))
            }
        })
    }

    /// Difference of the rate at the predicted state from the predicted rate.
    pub(super) fn surprise(&self, rate: &M::X) -> M::X {
        rate.map2(&self.rows[0], |rate, predicted| rate - predicted)
    }

    /// Sums of squares over components: of `surprise` plus row k - 1, of `surprise` plus row k, and of `surprise`; each
    /// by its weight.
    pub(super) fn sizes(&self, surprise: &M::X, weight: &M::X, order: usize) -> [M::S; 3] {
        let zero = M::X::fill(M::S::ZERO);
        let row = |i: usize| order.checked_sub(i).and_then(|i| self.rows.get(i)).unwrap_or(&zero);
        let (below, top) = (row(2), row(1));
        let mut sums = [M::S::ZERO; 3];
        for l in M::NQ..M::X::LEN {
            let (s, weight) = (surprise.at(l), weight.at(l));
            for (sum, size) in sums.iter_mut().zip([below.at(l) + s, top.at(l) + s, s]) {
                let size = size * weight;
                *sum = size.mul_add(size, *sum);
            }
        }
        sums
    }

    /// Accepts the step; `rate` is that at its end.
    pub(super) fn accept(&mut self, rate: &M::X, order: usize) {
        self.last = self.surprise(rate);
        let mut rows = self.rows.iter_mut().skip(order);
        if let (Some(row), Some(next)) = (rows.next(), rows.next()) {
            *next = self.last.map2(next, |last, before| last - before);
            *row = self.last;
        }
        self.due = order;
    }

    /// Sum of squares of the difference of order k + 1, each component by its weight.
    pub(super) fn next_size(&self, weight: &M::X, order: usize) -> M::S {
        let row = self.row(order + 2);
        (M::NQ..M::X::LEN).fold(M::S::ZERO, |sum, l| {
            let size = row.at(l) * weight.at(l);
            size.mul_add(size, sum)
        })
    }

    /// Takes back the last prediction: the differences become those at the beginning of its step.
    pub(super) fn take_back(&mut self, order: usize, coefficients: &Coefficients<M::S>) {
        let zero = M::X::fill(M::S::ZERO);
        for i in 0..order.min(MOST) {
            let above = if i + 1 < order { self.row(i + 2) } else { zero };
            let beta = if i + 1 > coefficients.equal { coefficients.beta.at(i + 1) } else { M::S::lit(1.0) };
            if let Some(row) = self.rows.get_mut(i) {
                *row = row.map2(&above, |s, above| (s - above) / beta);
            }
        }
        self.due = 0;
    }
}
