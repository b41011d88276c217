//! The semi-implicit (symplectic) Euler method.

use super::Rates;
use super::fixed::{FixedStep, Formula};
use crate::scalar::Scalar;
use crate::system::System;
use crate::vector::Vector;

/// The semi-implicit Euler method with steps of equal length: order 1, one rate a step, bounded energy error.
pub type SemiImplicitEuler<S> = FixedStep<S, SemiImplicitEulerFormula>;

/// The formula: v by its rate, q by the new v, first-order states by their rate (E. Hairer, C. Lubich, G. Wanner,
/// Geometric Numerical Integration, I.1.2, eq. (1.9)).
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEulerFormula;

impl Formula for SemiImplicitEulerFormula {
    const NAME: &'static str = "SemiImplicitEuler";
    const STAGES: u64 = 1;

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: System>(t: M::S, h: M::S, x: &mut M::X, mut rates: impl Rates<M>) {
        let (q, mut k) = (*x, M::X::fill(M::S::lit(0.0)));
        rates.at(t, x, &mut k);
        x.add([(h, &k)]);
        for i in 0..M::NQ {
            x.set(i, h.mul_add(x.at(M::NQ + i), q.at(i)));
        }
    }
}
