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

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller; and the
    // rate becomes part of the formula only if it is called in one place, hence the loop. Through memory, a step of the
    // double pendulum takes half as long again: what is written number by number has to wait before vectors read it.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: System>(t: M::S, h: M::S, x: &mut M::X, mut rate: impl FnMut(M::S, &M::X, &mut M::X)) {
        let lit = M::S::lit;
        let (half, third, sixth) = (lit(0.5) * h, lit(1.0 / 3.0) * h, lit(1.0 / 6.0) * h);
        let zero = lit(0.0);
        let (start, mut stage, mut k) = (*x, *x, M::X::fill(zero));
        let stages = [(zero, sixth, half), (half, third, half), (half, third, h), (h, sixth, zero)];
        for (node, weight, next) in stages {
            rate(t + node, &stage, &mut k);
            x.add([(weight, &k)]);
            stage.combine(&start, [(next, &k)]);
        }
    }
}
