//! The semi-implicit (symplectic) Euler method.

use super::Rates;
use super::estimate::{Estimate, Sizes};
use super::fixed::{FixedStep, Formula, Made};
use crate::scalar::{Real, Scalar};
use crate::system::Rate;
use crate::vector::Vector;

/// Semi-implicit Euler method with steps of equal length: order 1, one rate a step, bounded energy error.
pub type SemiImplicitEuler<S> = FixedStep<S, SemiImplicitEulerFormula>;

/// The formula: v by its rate, q by the new v, first-order states by their rate (E. Hairer, C. Lubich, G. Wanner,
/// Geometric Numerical Integration, I.1.2, eq. (1.9)).
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEulerFormula;

/// Change of a velocity or of a first-order state in a step, relative to its size, ...
const SLOW: f64 = 1.0 / 16.0;
/// ... and motion of a position by it, relative to its size, below which a step has no estimate.
const SHORT: f64 = 1e-4;

impl Formula for SemiImplicitEulerFormula {
    const NAME: &'static str = "SemiImplicitEuler";
    const STAGES: u64 = 1;
    const STRAIGHT: f64 = SHORT;
    const OF_PLACES: bool = true;
    type Stages<X: Copy> = X;

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: Rate, T>(
        (t, h): (M::S, M::S),
        x: &mut M::X,
        mut rates: impl Rates<M>,
        look: impl FnOnce(&M::X, &M::X) -> T,
    ) -> T {
        let (q, mut k) = (*x, M::X::fill(M::S::lit(0.0)));
        rates.at(t, x, &mut k);
        x.add([(h, &k)]);
        for i in 0..M::NQ {
            x.set(i, h.mul_add(x.at(M::NQ + i), q.at(i)));
        }
        look(x, &k)
    }

    #[inline]
    fn apart<M: Rate>(h: M::S, k: &M::X, size: impl Fn(usize) -> M::S) -> impl Fn(usize) -> [M::S; 2] {
        let (slow, short) = (M::S::lit(SLOW) / h, M::S::lit(2.0 * SHORT) / (h * h));
        move |i| {
            if i < M::NQ { [k.at(M::NQ + i).abs(), short * size(i)] } else { [k.at(i).abs(), slow * size(i)] }
        }
    }

    #[inline]
    fn difference<M: Rate<S: Real>>(k: &M::X) -> M::X {
        *k
    }

    // A position differs from that by the trapezoidal rule by the first term that it lacks, h^2/2 of the acceleration. A
    // velocity has no second rate; one at the end of the step, from which the next step will begin, makes that rule for
    // it too.
    fn estimate<M: Rate<S: Real>>(made: &Made<'_, M>, k: &M::X) -> Estimate<M::S> {
        let sizes = Sizes { typical: made.system.typical(), from: made.from.1, to: made.to };
        let mut end = *k;
        made.system.rate(made.from.0 + made.h, made.held, made.to, &mut end);
        Estimate::largest(M::X::LEN, |i| {
            if i < M::NQ {
                return sizes.bend((i, M::NQ, made.h));
            }
            M::S::lit(0.5) * made.h * (end.at(i) - k.at(i)).abs() / sizes.of(i)
        })
    }
}
