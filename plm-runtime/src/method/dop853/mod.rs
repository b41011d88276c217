//! Dormand-Prince 8(5,3), the program DOP853 of E. Hairer and G. Wanner.

#[cfg(test)]
mod conditions;
mod tableau;

use core::fmt::Debug;
use core::ops::Range;

use self::tableau::{
    A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A14, A15, A16, B, C2, C3, C4, C5, C6, C7, C8, C9, C10,
    C11, C14, C15, C16, D4, D5, D6, D7, E3, E5,
};
use super::embedded::{Embedded, Limits, Pair, Rows, stages};
use super::rates::Rates;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Dormand-Prince 8(5,3): steps of order 8 in twelve evaluations, dense output of order 7 in three more where it is
/// asked for.
pub type Dop853<M> = Embedded<M, DormandPrince853>;

/// The formulas of [`Dop853`] (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
/// II.5, II.6, and their program DOP853).
#[derive(Clone, Copy, Debug)]
pub struct DormandPrince853;

/// The rates that are used more than once; the first stage, the rate at the beginning, and stages 6 to 12.
#[derive(Clone, Copy, Debug)]
pub struct Stages<X> {
    k1: X,
    k6: X,
    k7: X,
    k8: X,
    k9: X,
    k10: X,
    k11: X,
    k12: X,
}

impl<X> Stages<X> {
    /// Stages 1, 6 to 12.
    #[inline]
    fn all(&self) -> [&X; 8] {
        [&self.k1, &self.k6, &self.k7, &self.k8, &self.k9, &self.k10, &self.k11, &self.k12]
    }
}

impl Rows<12> for DormandPrince853 {
    const NODES: [f64; 12] = [0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, 1.0];

    #[allow(clippy::inline_always, reason = "as the stages")]
    #[inline(always)]
    fn row<S: Scalar, X: Vector<S>>(
        stage: usize,
        part: Range<usize>,
        (x, h): (&X, S),
        k: &[X; 12],
        at: &mut X,
    ) {
        let [k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12] = k;
        match stage {
            1 => at.shift(part, (x, h), A2, [k1]),
            2 => at.shift(part, (x, h), A3, [k1, k2]),
            3 => at.shift(part, (x, h), A4, [k1, k3]),
            4 => at.shift(part, (x, h), A5, [k1, k3, k4]),
            5 => at.shift(part, (x, h), A6, [k1, k4, k5]),
            6 => at.shift(part, (x, h), A7, [k1, k4, k5, k6]),
            7 => at.shift(part, (x, h), A8, [k1, k4, k5, k6, k7]),
            8 => at.shift(part, (x, h), A9, [k1, k4, k5, k6, k7, k8]),
            9 => at.shift(part, (x, h), A10, [k1, k4, k5, k6, k7, k8, k9]),
            10 => at.shift(part, (x, h), A11, [k1, k4, k5, k6, k7, k8, k9, k10]),
            11 => at.shift(part, (x, h), A12, [k1, k4, k5, k6, k7, k8, k9, k10, k11]),
            _ => at.shift(part, (x, h), B, [k1, k6, k7, k8, k9, k10, k11, k12]),
        }
    }
}

impl Pair for DormandPrince853 {
    const NAME: &'static str = "Dop853";
    const ORDER: u32 = 8;
    const EVALUATIONS: u64 = 11;
    /// As dear as Dormand-Prince 5(4) at 1e-8, and a hundred times as accurate.
    const RTOL: f64 = 1e-9;
    /// The authors' but for the safety, theirs is 0.9: with that up to a third of the steps is rejected, which costs the
    /// double pendulum, a four-bar and a slider-crank a third more evaluations to an error of 1e-10.
    const LIMITS: Limits = Limits { safety: 0.7, exponent: 0.125, memory: 0.0, shrink: 0.333, growth: 6.0 };

    type Stages<X: Copy + Debug> = Stages<X>;
    type Bends<X: Copy + Debug> = [X; 4];

    fn blank<X: Copy + Debug>(x: X) -> Stages<X> {
        Stages { k1: x, k6: x, k7: x, k8: x, k9: x, k10: x, k11: x, k12: x }
    }

    #[allow(clippy::inline_always, reason = "as the stages")]
    #[inline(always)]
    fn step<M: System>(
        t: M::S,
        h: M::S,
        x: &M::X,
        first: &M::X,
        k: &mut Stages<M::X>,
        mut rates: impl Rates<M>,
    ) -> M::X {
        let mut all = [*first; 12];
        let end = stages::<M, Self, 12>((t, h), x, &mut all, &mut rates);
        let [k1, _, _, _, _, k6, k7, k8, k9, k10, k11, k12] = &all;
        *k = Stages { k1: *k1, k6: *k6, k7: *k7, k8: *k8, k9: *k9, k10: *k10, k11: *k11, k12: *k12 };
        end
    }

    #[inline]
    fn rate_at_end<X: Copy + Debug>(_k: &Stages<X>) -> Option<&X> {
        None
    }

    /// err5^2 / sqrt(err5^2 + 0.01 err3^2): of order 7, and safe where err5 vanishes by chance.
    #[inline]
    fn error<S: Real, X: Vector<S>>(h: S, k: &Stages<X>, weight: &X) -> S {
        let size = |weights| {
            let error = X::weighted(weights, k.all()).map2(weight, |error, weight| error * weight);
            error.fold(S::lit(0.0), |sum, e| e.mul_add(e, sum))
        };
        let (fifth, third) = (size(E5), size(E3));
        let both = S::lit(0.01).mul_add(third, fifth);
        if both == S::lit(0.0) {
            return both;
        }
        h.abs() * fifth / (S::lit(X::LEN as f64) * both).sqrt()
    }

    fn bend<M: System>(
        t: M::S,
        h: M::S,
        x: &M::X,
        k: &Stages<M::X>,
        k13: &M::X,
        mut rate: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> [M::X; 4] {
        let at = |c: f64| M::S::lit(c).mul_add(h, t);
        let Stages { k1, k6, k7, k8, k9, k10, k11, k12 } = k;
        let [mut k14, mut k15, mut k16] = [*k13; 3];
        rate(at(C14), &x.moved(h, A14, [k1, k7, k8, k9, k10, k11, k12, k13]), &mut k14);
        rate(at(C15), &x.moved(h, A15, [k1, k6, k7, k8, k11, k12, k13, &k14]), &mut k15);
        rate(at(C16), &x.moved(h, A16, [k1, k6, k7, k8, k9, k13, &k14, &k15]), &mut k16);
        let all = [k1, k6, k7, k8, k9, k10, k11, k12, k13, &k14, &k15, &k16];
        [D4, D5, D6, D7].map(|weights| M::X::weighted(weights, all).map(|s| h * s))
    }
}
