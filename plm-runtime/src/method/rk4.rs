//! The classical Runge-Kutta method of order 4.

use super::fixed::{FixedStep, Formula};
use super::rates::{Rates, each_stage};
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
    const NAME: &'static str = "Rk4";
    const STAGES: u64 = 4;

    // The rate's captures (health, system, inputs) stay in registers only if the formula is part of its caller; and the
    // rate, unless it is short, becomes part of the formula only if it is called in one place, hence the loop.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn step<M: System>(t: M::S, h: M::S, x: &mut M::X, mut rates: impl Rates<M>) {
        if M::PAIRED {
            let [[k1, k2], [k3, k4]] = pairs::<M>(t, h, x, rates);
            return end::<M>(h, x, &[k1, k2, k3, k4]);
        }
        let lit = M::S::lit;
        let (zero, half) = (lit(0.0), lit(0.5) * h);
        let stages = [(zero, half), (half, half), (half, h), (h, zero)];
        let (mut ahead, mut k) = (*x, [M::X::fill(zero); 4]);
        each_stage!(M::SHORT, i in [0, 1, 2, 3] {
            let (node, next) = stages[i];
            // Coordinates before the rate: the pose that follows waits for no acceleration.
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
    }
}

/// The rates of the stages, two by two: the positions of a stage follow from the velocities of the one before it. Components
/// are written one by one: a copy of several waits for all of them.
#[allow(clippy::inline_always, reason = "as the step")]
#[inline(always)]
fn pairs<M: System>(t: M::S, h: M::S, x: &M::X, mut rates: impl Rates<M>) -> [[M::X; 2]; 2] {
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

/// The weighted sum of the rates. Those of positions are the velocities of the stages, v and v + h/2 k1 and so on, and sum
/// up to 6 v + h (k1 + k2 + k3): the next pose waits for no more.
#[allow(clippy::inline_always, reason = "as the step")]
#[inline(always)]
fn end<M: System>(h: M::S, x: &mut M::X, [k1, k2, k3, k4]: &[M::X; 4]) {
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
