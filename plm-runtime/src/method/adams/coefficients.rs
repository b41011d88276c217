//! Coefficients of steps of variable length (Shampine and Gordon, chapter 5, and the program STEP of chapter 10).

use super::MOST;
use crate::scalar::Real;
use crate::vector::Vector;

/// Length of the arrays; entries are numbered from 1, as in the book.
const ROOM: usize = MOST + 3;

/// gamma*_i, the coefficients of the Adams-Moulton formulas of equal steps, i from 0 (Hairer, Nørsett, Wanner I, III.1,
/// eq. (1.10)): gamma*_m + gamma*_(m-1) / 2 + ... + gamma*_0 / (m + 1) = 0 except for m = 0.
pub(super) const EQUAL_STEPS: [f64; ROOM] = {
    let mut gamma = [0.0; ROOM];
    gamma[0] = 1.0;
    let mut m = 1;
    while m < ROOM {
        let mut j = 0;
        while j < m {
            gamma[m] -= gamma[j] / (m - j + 1) as f64;
            j += 1;
        }
        m += 1;
    }
    gamma
};

/// Coefficients of the next step, from the lengths of the last ones.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficients<S> {
    /// psi_i, the length of the last i steps, s.
    pub(super) psi: [S; ROOM],
    /// alpha_i = h / psi_i.
    pub(super) alpha: [S; ROOM],
    /// Factors by which the differences of the last step become those of the next.
    pub(super) beta: [S; ROOM],
    /// sigma_i, by which error estimates differ from those of equal steps.
    pub(super) sigma: [S; ROOM],
    /// Coefficients of the integral over the step, g_(i,1).
    pub(super) once: [S; ROOM],
    /// Coefficients of the double integral over the step, g_(i,2): the effect of accelerations on coordinates.
    pub(super) twice: [S; ROOM],
    /// Row of integrals g_(i,q), over q, from which those of the next step begin.
    pub(super) kept: [S; ROOM],
    /// Length of the last step, s.
    pub(super) last: S,
    /// Order of the last step.
    pub(super) order: usize,
    /// Number of successive steps of one length.
    pub(super) equal: usize,
}

impl<S: Real> Coefficients<S> {
    pub(super) fn new() -> Self {
        let none = [S::ZERO; ROOM];
        let (mut once, mut twice, mut sigma) = (none, none, none);
        once[1] = S::lit(1.0);
        once[2] = S::lit(0.5);
        twice[1] = S::lit(0.5);
        twice[2] = S::lit(1.0 / 6.0);
        sigma[1] = S::lit(1.0);
        Self {
            psi: none,
            alpha: none,
            beta: none,
            sigma,
            once,
            twice,
            kept: none,
            last: S::ZERO,
            order: 0,
            equal: 0,
        }
    }

    /// Prepares a step of `h` and an order. Nothing is computed if more steps than the order have this length.
    pub(super) fn prepare(&mut self, h: S, order: usize) {
        if h != self.last {
            self.equal = 0;
        }
        if self.equal <= self.order {
            self.equal += 1;
        }
        if order >= self.equal {
            self.lengths(h, order);
            self.integrals(order);
        }
        (self.last, self.order) = (h, order);
    }

    /// psi, alpha, beta and sigma.
    fn lengths(&mut self, h: S, order: usize) {
        let number = |i: usize| S::lit(i as f64);
        let equal = self.equal;
        self.beta.set(equal, S::lit(1.0));
        self.alpha.set(equal, S::lit(1.0) / number(equal));
        self.sigma.set(equal + 1, S::lit(1.0));
        let mut length = h * number(equal);
        for i in equal + 1..=order {
            let before = self.psi.at(i - 1);
            self.psi.set(i - 1, length);
            self.beta.set(i, self.beta.at(i - 1) * length / before);
            length = before + h;
            self.alpha.set(i, h / length);
            self.sigma.set(i + 1, number(i) * self.alpha.at(i) * self.sigma.at(i));
        }
        self.psi.set(order, length);
    }

    /// The integrals, by a triangle of which one row is stored; it is one longer than in STEP, for the double
    /// integrals.
    fn integrals(&mut self, order: usize) {
        let of_equal = |q: usize| S::lit(1.0 / (q * (q + 1)) as f64);
        let (equal, longest) = (self.equal, order + 1);
        let v = &mut self.kept;
        if equal == 1 {
            for q in 1..=longest {
                v.set(q, of_equal(q));
            }
        } else {
            if order > self.order {
                v.set(longest, of_equal(longest));
                for j in 2..equal {
                    let q = (longest + 1).saturating_sub(j);
                    v.set(q, v.at(q) - self.alpha.at(j) * v.at(q + 1));
                }
            }
            for q in 1..=(longest + 1).saturating_sub(equal) {
                v.set(q, v.at(q) - self.alpha.at(equal) * v.at(q + 1));
            }
            self.once.set(equal + 1, v[1]);
            self.twice.set(equal + 1, v[2]);
        }
        let mut w = *v;
        for i in (equal + 2).max(3)..=order + 1 {
            for q in 1..=order + 3 - i {
                w.set(q, w.at(q) - self.alpha.at(i - 1) * w.at(q + 1));
            }
            self.once.set(i, w[1]);
            self.twice.set(i, w[2]);
        }
    }

    /// Takes back the last step, of `h`: the lengths become those before it.
    pub(super) fn take_back(&mut self, h: S) {
        for i in 2..=self.order {
            self.psi.set(i - 1, self.psi.at(i) - h);
        }
        self.last = S::ZERO;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simple and double integrals of `f` from 0 to 1, by the rule of T. Simpson.
    fn integrals(f: impl Fn(f64) -> f64) -> [f64; 2] {
        const PARTS: u32 = 2000;
        let mut sums = [0.0; 2];
        for part in 0..=PARTS {
            let s = f64::from(part) / f64::from(PARTS);
            let weight = if part == 0 || part == PARTS { 1.0 } else { [2.0, 4.0][part as usize % 2] };
            sums[0] += weight * f(s) / f64::from(3 * PARTS);
            sums[1] += weight * (1.0 - s) * f(s) / f64::from(3 * PARTS);
        }
        sums
    }

    /// Compares with their definition: integrals of c_i(s), the product of (s h + psi_(j-1)(n)) / psi_j(n+1) over j < i
    /// (Shampine and Gordon, chapter 5, eq. (7)).
    fn agrees(by: &Coefficients<f64>, order: usize, times: &[f64], h: f64) {
        let psi = |j: usize| times[times.len() - 1] - times[times.len() - 1 - j];
        for i in 1..=order + 1 {
            let c = |s: f64| (1..i).map(|j| (s * h + psi(j - 1)) / (psi(j - 1) + h)).product::<f64>();
            let [once, twice] = integrals(c);
            let found = (by.once[i], by.twice[i]);
            let off = (found.0 - once).abs() + (found.1 - twice).abs();
            assert!(off < 1e-11, "{i} of {order} at {}: {found:?}, {once} {twice}", times.len());
        }
    }

    /// The order grows by one a step to 12, falls, and grows again, while lengths are constant or change.
    #[test]
    fn integrals_are_those_of_their_definition() {
        let lengths = |step: usize| match step {
            0..=4 => 0.01 * f64::from(1 << step),
            5..=20 => 0.16,
            21 => 0.1,
            22..=24 => 0.11,
            _ => 0.2,
        };
        let orders = |step: usize| match step {
            0..=11 => step + 1,
            12..=24 => 12,
            25 | 26 => 9,
            _ => (step - 18).min(12),
        };
        let (mut by, mut times) = (Coefficients::new(), [0.0; 46]);
        for step in 0..45 {
            let (h, order) = (lengths(step), orders(step));
            by.prepare(h, order);
            agrees(&by, order, &times[..=step], h);
            times[step + 1] = times[step] + h;
        }
    }

    #[test]
    fn a_step_that_is_taken_back_leaves_no_trace() {
        let (mut by, mut times) = (Coefficients::new(), [0.0; 9]);
        for step in 0..8 {
            by.prepare(0.1, step + 1);
            times[step + 1] = 0.1 * (step + 1) as f64;
        }
        by.prepare(0.2, 8);
        by.take_back(0.2);
        by.prepare(0.05, 7);
        agrees(&by, 7, &times, 0.05);
    }

    /// Hairer, Nørsett, Wanner I, table III.1.2.
    #[test]
    fn those_of_equal_steps_are_known() {
        let known =
            [1.0, -1.0 / 2.0, -1.0 / 12.0, -1.0 / 24.0, -19.0 / 720.0, -3.0 / 160.0, -863.0 / 60480.0];
        for (found, known) in EQUAL_STEPS.iter().zip(known) {
            assert!((found - known).abs() < 1e-15, "{found} {known}");
        }
    }
}
