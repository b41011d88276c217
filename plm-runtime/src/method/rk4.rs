//! The classical Runge-Kutta method of order 4.

use super::estimate::{Estimate, Sizes};
use super::fixed::{FixedStep, Formula, Made};
use super::rates::{Rates, each_stage};
use crate::scalar::{Real, Scalar};
use crate::system::Rate;
use crate::vector::Vector;

/// The classical Runge-Kutta method of order 4 with steps of equal length.
pub type Rk4<S> = FixedStep<S, Rk4Formula>;

/// The formula (W. Kutta, Beitrag zur näherungsweisen Integration totaler Differentialgleichungen, Z. Math. Phys. 46,
/// 1901; E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, table II.1.2, left).
#[derive(Clone, Copy, Debug)]
pub struct Rk4Formula;

/// Difference of the rates, relative to a state, below which a step has no estimate: its error is less than 1e-4 of the state.
const SHORT: f64 = 1.0 / 64.0;
/// Error of the step of a linear oscillator: the first term of the exponential series that the formula lacks, h^5/5!.
const CONSTANT: f64 = 1.0 / 120.0;
/// Its order over that of the known terms, h^5 over h^3.
const POWER: f64 = 5.0 / 3.0;

impl Formula for Rk4Formula {
    const NAME: &'static str = "Rk4";
    const STAGES: u64 = 4;
    // The third term of Taylor's series is twelve times that: the step errs by less than 1e-4.
    const STRAIGHT: f64 = 1.0 / 192.0;
    const OF_PLACES: bool = false;
    type Stages<X: Copy> = [X; 4];

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller; and the
    // rate, unless it is short, becomes part of the formula only if it is called in one place, hence the loop.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: Rate, T>(
        (t, h): (M::S, M::S),
        x: &mut M::X,
        mut rates: impl Rates<M>,
        look: impl FnOnce(&M::X, &[M::X; 4]) -> T,
    ) -> T {
        if M::PAIRED {
            let [[k1, k2], [k3, k4]] = pairs::<M>(t, h, x, rates);
            let k = [k1, k2, k3, k4];
            end::<M>(h, x, &k);
            return look(x, &k);
        }
        let lit = M::S::lit;
        let (zero, half) = (lit(0.0), lit(0.5) * h);
        let stages = [(zero, half), (half, half), (half, h), (h, zero)];
        let (mut ahead, mut k) = (*x, [M::X::fill(zero); 4]);
        each_stage!(M::SHORT, i in [0, 1, 2, 3] {
            let (node, next) = stages[i];
            // Coordinates before the rate: the next pose waits for no acceleration.
            let stage = ahead;
            for j in 0..M::NQ {
                ahead.set(j, next.mul_add(stage.at(M::NQ + j), x.at(j)));
            }
            rates.at(t + node, &stage, &mut k[i]);
            for j in M::NQ..M::X::LEN {
                ahead.set(j, next.mul_add(k[i].at(j), x.at(j)));
            }
        });
        end::<M>(h, x, &k);
        look(x, &k)
    }

    // k1 - k2 - k3 + k4 is h^2/4 of the second derivative of the rate; the sums occur in `end` too.
    #[allow(clippy::inline_always, reason = "as the step")]
    #[inline(always)]
    fn apart<M: Rate>(
        h: M::S,
        [k1, k2, k3, k4]: &[M::X; 4],
        size: impl Fn(usize) -> M::S,
    ) -> impl Fn(usize) -> [M::S; 2] {
        let long = M::S::lit(1.0 / SHORT) * h;
        move |i| [long * ((k1.at(i) + k4.at(i)) - (k2.at(i) + k3.at(i))).abs(), size(i)]
    }

    // Of the two sums with weights of sum zero that are of the order h^3, one has the derivative of the rate twice (k3 - k2),
    // the other the whole second derivative: either may vanish while the other does not. Both are a quarter of the third term.
    #[allow(clippy::inline_always, reason = "as the step")]
    #[inline(always)]
    fn difference<M: Rate<S: Real>>([k1, k2, k3, k4]: &[M::X; 4]) -> M::X {
        M::X::from_fn(|i| {
            if i < M::NQ {
                return M::S::lit(0.0);
            }
            let bend = (k1.at(i) + k4.at(i)) - (k2.at(i) + k3.at(i));
            let turn = k3.at(i) - k2.at(i);
            bend.abs().max(turn.abs())
        })
    }

    fn estimate<M: Rate<S: Real>>(made: &Made<'_, M>, difference: &M::X) -> Estimate<M::S> {
        let sizes = Sizes { typical: made.system.typical(), from: made.from.1, to: made.to };
        let third = |i: usize| {
            if i < M::NQ {
                return M::S::lit(12.0) * sizes.bend((i, M::NQ, made.h));
            }
            M::S::lit(4.0) * made.h * difference.at(i) / sizes.of(i)
        };
        Estimate::largest(M::X::LEN, third).of_term(CONSTANT, POWER)
    }
}

/// Rates of the stages, two by two: the positions of a stage follow from the velocities of the one before it. Components are
/// written one by one, since a copy of several waits for all of them.
#[allow(clippy::inline_always, reason = "as the step")]
#[inline(always)]
fn pairs<M: Rate>(t: M::S, h: M::S, x: &M::X, mut rates: impl Rates<M>) -> [[M::X; 2]; 2] {
    let (zero, half) = (M::S::lit(0.0), M::S::lit(0.5) * h);
    let stages = [(zero, half), (half, h)];
    let along = |step: M::S, k: &M::X| M::X::from_fn(|i| step.mul_add(k.at(i), x.at(i)));
    let mut k = [[M::X::fill(zero); 2]; 2];
    each_stage!(M::SHORT, i in [0, 1] {
        let (node, next) = stages[i];
        let stage = if i == 0 { *x } else { along(half, &k[0][1]) };
        let ahead = M::X::from_fn(|i| {
            if i < M::NQ { next.mul_add(stage.at(M::NQ + i), x.at(i)) } else { zero }
        });
        rates.pair([t + node, t + next], [&stage, &ahead], &mut k[i], |k| along(next, k));
    });
    k
}

/// Weighted sum of the rates. Those of positions are the velocities of the stages, v and v + h/2 k1 and so on, and sum up to
/// 6 v + h (k1 + k2 + k3): the next pose waits for nothing else.
#[allow(clippy::inline_always, reason = "as the step")]
#[inline(always)]
fn end<M: Rate>(h: M::S, x: &mut M::X, [k1, k2, k3, k4]: &[M::X; 4]) {
    let (two, sixth) = (M::S::lit(2.0), M::S::lit(1.0 / 6.0) * h);
    for i in 0..M::NQ {
        let v = M::NQ + i;
        let sum = k1.at(v) + (k2.at(v) + k3.at(v));
        let mean = sixth.mul_add(sum, x.at(v));
        x.set(i, h.mul_add(mean, x.at(i)));
    }
    for i in M::NQ..M::X::LEN {
        let sum = two.mul_add(k2.at(i) + k3.at(i), k1.at(i) + k4.at(i));
        x.set(i, sixth.mul_add(sum, x.at(i)));
    }
}
