//! The classical Runge-Kutta method of order 4.

use super::fixed::{FixedStep, Formula};
use crate::scalar::Scalar;
use crate::system::System;
use crate::vector::Vector;

/// The classical Runge-Kutta method of order 4 with steps of equal length.
pub type Rk4<S> = FixedStep<S, Rk4Formula>;

/// The formula (W. Kutta, Beitrag zur näherungsweisen Integration totaler Differentialgleichungen, Z. Math. Phys. 46,
/// 1901; E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, table II.1.2, left).
#[derive(Clone, Copy, Debug)]
pub struct Rk4Formula;

impl Formula for Rk4Formula {
    const STAGES: u64 = 4;

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: System>(t: M::S, h: M::S, x: &mut M::X, mut rate: impl FnMut(M::S, &M::X, &mut M::X)) {
        let lit = M::S::lit;
        let (half, mut stage) = (lit(0.5) * h, *x);
        let [mut k1, mut k2, mut k3, mut k4] = [M::X::fill(lit(0.0)); 4];
        rate(t, x, &mut k1);
        stage.combine(x, [(half, &k1)]);
        rate(t + half, &stage, &mut k2);
        stage.combine(x, [(half, &k2)]);
        rate(t + half, &stage, &mut k3);
        stage.combine(x, [(h, &k3)]);
        rate(t + h, &stage, &mut k4);
        let (third, sixth) = (lit(1.0 / 3.0) * h, lit(1.0 / 6.0) * h);
        x.add([(sixth, &k1), (third, &k2), (third, &k3), (sixth, &k4)]);
    }
}
