//! Collocation at the nodes of Gauss: the polynomial whose rate is right at all of them.
//!
//! The rate is developed in Legendre polynomials: `f(t) = sum c_k P_k(x)`, `x = 2 t - 1`, with
//! `c_k = (2 k + 1) sum w_j P_k(x_j) f_j`, exact for polynomials by the rule of Gauss; and
//! `int_0^t P_k = (P_{k+1} - P_{k-1}) / (2 (2 k + 1))` (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration,
//! 2nd ed., II.1.3; M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, table 25.4).

use crate::scalar::Scalar;
use crate::vector::Vector;

/// Number of nodes; the order is twice that.
pub(super) const NODES: usize = 8;

/// Positive nodes on [-1, 1] and their weights.
const HALF: [[f64; 2]; NODES / 2] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
];

/// A node on [-1, 1] and its weight on [0, 1].
fn node(j: usize) -> [f64; 2] {
    let ([x, w], sign) = if j < NODES / 2 {
        (HALF[NODES / 2 - 1 - j.min(NODES / 2 - 1)], -1.0)
    } else {
        (HALF[(j - NODES / 2).min(NODES / 2 - 1)], 1.0)
    };
    [sign * x, 0.5 * w]
}

/// The place of a node on [0, 1].
pub(super) fn place(j: usize) -> f64 {
    0.5 + 0.5 * node(j)[0]
}

/// `P_0` to `P_8` at `x`.
fn legendre<S: Scalar>(x: S) -> [S; NODES + 1] {
    let (mut p, mut before, mut now) = ([S::lit(1.0); NODES + 1], S::lit(1.0), x);
    for (k, p) in p.iter_mut().enumerate().skip(1) {
        *p = now;
        let k = k as f64;
        let next = (S::lit(2.0 * k + 1.0) * x * now - S::lit(k) * before) / S::lit(k + 1.0);
        (before, now) = (now, next);
    }
    p
}

/// `int_0^t P_0` to `int_0^t P_7`, `x = 2 t - 1`.
fn integrals<S: Scalar>(t: S) -> [S; NODES] {
    let p = legendre(t + t - S::lit(1.0));
    let mut integrals = [t; NODES];
    for (k, (integral, p)) in integrals.iter_mut().skip(1).zip(p.windows(3)).enumerate() {
        if let [before, _, after] = p {
            *integral = (*after - *before) / S::lit((4 * k + 6) as f64);
        }
    }
    integrals
}

/// The solution over a step: its start, length, and the coefficients of its rate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polynomial<S, const N: usize> {
    pub(super) from: [S; N],
    pub(super) h: S,
    coefficients: [[S; N]; NODES],
}

impl<S: Scalar, const N: usize> Polynomial<S, N> {
    /// From the rates at the nodes.
    pub(super) fn of(from: [S; N], h: S, rates: &[[S; N]; NODES]) -> Self {
        let mut coefficients = [[S::lit(0.0); N]; NODES];
        for (j, rate) in rates.iter().enumerate() {
            let [x, w] = node(j);
            let p = legendre(S::lit(x));
            for (k, (row, p)) in coefficients.iter_mut().zip(p).enumerate() {
                let factor = S::lit((2 * k + 1) as f64 * w) * p;
                for (c, f) in row.iter_mut().zip(rate) {
                    *c = factor.mul_add(*f, *c);
                }
            }
        }
        Self { from, h, coefficients }
    }

    /// The state at the part `t` of the step.
    pub(super) fn at(&self, t: S) -> [S; N] {
        let mut x = [S::lit(0.0); N];
        // From the small ones to the large one.
        for (row, integral) in self.coefficients.iter().rev().zip(integrals(t).into_iter().rev()) {
            for (sum, c) in x.iter_mut().zip(row) {
                *sum = integral.mul_add(*c, *sum);
            }
        }
        Vector::from_fn(|i| self.h.mul_add(x[i], self.from[i]))
    }

    /// The rate at the part `t` of the step.
    pub(super) fn rate(&self, t: S) -> [S; N] {
        let p = legendre(t + t - S::lit(1.0));
        let mut f = [S::lit(0.0); N];
        for (row, p) in self.coefficients.iter().rev().zip(p.into_iter().rev().skip(1)) {
            for (sum, c) in f.iter_mut().zip(row) {
                *sum = p.mul_add(*c, *sum);
            }
        }
        f
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_the_fifteenth_degree_are_integrated() {
        for degree in 0..16 {
            let rates = core::array::from_fn(|j| [place(j).powi(degree)]);
            let end = Polynomial::of([1.0], 1.0, &rates).at(1.0)[0];
            assert!((end - 1.0 - 1.0 / (f64::from(degree) + 1.0)).abs() < 4e-16, "{degree}: {end}");
        }
    }

    #[test]
    fn up_to_the_seventh_they_are_met_everywhere() {
        for degree in 0..8 {
            let rates = core::array::from_fn(|j| [2.0 * (2.0 * place(j)).powi(degree)]);
            let polynomial = Polynomial::of([0.5], 2.0, &rates);
            for t in [0.0, 0.1, 0.5, 0.77, 1.0f64] {
                let known = 0.5 + 2.0 * (2.0 * t).powi(degree + 1) / f64::from(degree + 1);
                assert!((polynomial.at(t)[0] - known).abs() < 1e-14 * known, "{degree} at {t}");
                let known = 2.0 * (2.0 * t).powi(degree);
                assert!((polynomial.rate(t)[0] - known).abs() < 1e-12, "{degree} at {t}");
            }
        }
    }
}
