//! Coefficients of the Gauss methods, in a form in which rounding preserves their symmetries.

use crate::scalar::Real;

/// Abscissae and weights of Gauss and Legendre, which define the methods.
#[derive(Clone, Copy, Debug)]
pub struct Legendre;

/// A Gauss method with `STAGES` stages.
pub trait Nodes<const STAGES: usize> {
    /// Abscissae c_i.
    const C: [f64; STAGES];
    /// Weights b_i.
    const B: [f64; STAGES];
    /// mu_ij = a_ij / b_j below the diagonal; on it 1/2, and above it 1 - mu_ji.
    ///
    /// So mu_ij + mu_ji = 1 holds for the machine's numbers too, the condition under which a method is symplectic
    /// (M. Antoñana, J. Makazaga, A. Murua, Reducing and monitoring round-off error propagation for symplectic implicit
    /// Runge-Kutta schemes, Numer. Algorithms 76 (2017), eqs. (3) and (12)).
    const MU: [[f64; STAGES]; STAGES];
    /// Error of the step of a linear oscillator, in z^(2s + 1): s!^2/((2s)! (2s + 1)!), that of the approximant of H.
    /// Padé (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.3, eq. (3.31)).
    const ERROR: f64;
}

const ROOT_3: f64 = 1.732_050_807_568_877_2;
const ROOT_15: f64 = 3.872_983_346_207_417;

/// Order 4 (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, table II.7.3).
impl Nodes<2> for Legendre {
    const C: [f64; 2] = [0.5 - ROOT_3 / 6.0, 0.5 + ROOT_3 / 6.0];
    const B: [f64; 2] = [0.5, 0.5];
    const MU: [[f64; 2]; 2] = [[0.5, 0.0], [0.5 + ROOT_3 / 3.0, 0.5]];
    const ERROR: f64 = 1.0 / 720.0;
}

/// Order 6 (the same, table II.7.4).
impl Nodes<3> for Legendre {
    const C: [f64; 3] = [0.5 - ROOT_15 / 10.0, 0.5, 0.5 + ROOT_15 / 10.0];
    const B: [f64; 3] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
    const MU: [[f64; 3]; 3] = [
        [0.5, 0.0, 0.0],
        [0.5 + 0.15 * ROOT_15, 0.5, 0.0],
        [0.5 + 0.12 * ROOT_15, 0.5 + 0.15 * ROOT_15, 0.5],
    ];
    const ERROR: f64 = 1.0 / 100_800.0;
}

/// The coefficients in the numbers of a system.
#[derive(Clone, Copy)]
pub(super) struct Tableau<S, const STAGES: usize> {
    pub(super) c: [S; STAGES],
    pub(super) mu: [[S; STAGES]; STAGES],
}

impl<S: Real, const STAGES: usize> Tableau<S, STAGES> {
    pub(super) fn new() -> Self
    where
        Legendre: Nodes<STAGES>,
    {
        let below = |i: usize, j: usize| S::lit(Legendre::MU[i][j]);
        let mu = |i: usize, j: usize| if j > i { S::lit(1.0) - below(j, i) } else { below(i, j) };
        Self { c: Legendre::C.map(S::lit), mu: core::array::from_fn(|i| core::array::from_fn(|j| mu(i, j))) }
    }

    /// h b_i, symmetric, and with the sum h up to one rounding (the same article, eq. (11)).
    pub(super) fn weights(h: S) -> [S; STAGES]
    where
        Legendre: Nodes<STAGES>,
    {
        let mut weights = Legendre::B.map(|b| S::lit(b) * h);
        let middle = STAGES / 2;
        if STAGES % 2 == 1 {
            let others = weights.iter().take(middle).fold(S::ZERO, |sum, weight| sum + *weight);
            weights[middle] = h - (others + others);
        }
        weights
    }

    /// l_j(theta), the polynomial that is one at c_j and zero at the other abscissae.
    pub(super) fn lagrange(&self, j: usize, theta: S) -> S {
        let others = self.c.iter().enumerate().filter(|(k, _)| *k != j);
        others.fold(S::lit(1.0), |product, (_, c)| product * ((theta - *c) / (self.c[j] - *c)))
    }
}
