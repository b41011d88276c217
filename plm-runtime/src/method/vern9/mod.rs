//! Verner 9(8), the most efficient of his pairs of these orders.

#[cfg(test)]
mod conditions;
mod tableau;

use core::fmt::Debug;
use core::ops::Range;

use self::tableau::{
    A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A13, A14, A15, A16, A18, A19, A20, A21, B, C2, C3, C4, C5,
    C6, C7, C8, C9, C10, C11, C12, C13, C14, C18, C19, C20, C21, D4, D5, D6, D7, D8, E,
};
use super::embedded::{Embedded, Limits, Pair, Rows, stages};
use super::rates::Rates;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Verner 9(8): steps of order 9 in sixteen evaluations, dense output of order 8 in four more where it is asked for.
pub type Vern9<M> = Embedded<M, Verner98>;

/// The formulas of [`Vern9`] (J. H. Verner, Numerically optimal Runge-Kutta pairs with interpolants, Numer. Algorithms 53,
/// 2010).
#[derive(Clone, Copy, Debug)]
pub struct Verner98;

/// The rates that are used more than once; the first stage, the rate at the beginning, and stages 8 to 16.
#[derive(Clone, Copy, Debug)]
pub struct Stages<X> {
    k1: X,
    k8: X,
    k9: X,
    k10: X,
    k11: X,
    k12: X,
    k13: X,
    k14: X,
    k15: X,
    k16: X,
}

impl Rows<16> for Verner98 {
    const NODES: [f64; 16] = [0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, 1.0, 1.0];

    #[allow(clippy::inline_always, reason = "as the stages")]
    #[inline(always)]
    fn row<S: Scalar, X: Vector<S>>(
        stage: usize,
        part: Range<usize>,
        (x, h): (&X, S),
        k: &[X; 16],
        at: &mut X,
    ) {
        let [k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, _] = k;
        match stage {
            1 => at.shift(part, (x, h), A2, [k1]),
            2 => at.shift(part, (x, h), A3, [k1, k2]),
            3 => at.shift(part, (x, h), A4, [k1, k3]),
            4 => at.shift(part, (x, h), A5, [k1, k3, k4]),
            5 => at.shift(part, (x, h), A6, [k1, k4, k5]),
            6 => at.shift(part, (x, h), A7, [k1, k4, k5, k6]),
            7 => at.shift(part, (x, h), A8, [k1, k6, k7]),
            8 => at.shift(part, (x, h), A9, [k1, k6, k7, k8]),
            9 => at.shift(part, (x, h), A10, [k1, k6, k7, k8, k9]),
            10 => at.shift(part, (x, h), A11, [k1, k6, k7, k8, k9, k10]),
            11 => at.shift(part, (x, h), A12, [k1, k6, k7, k8, k9, k10, k11]),
            12 => at.shift(part, (x, h), A13, [k1, k6, k7, k8, k9, k10, k11, k12]),
            13 => at.shift(part, (x, h), A14, [k1, k6, k7, k8, k9, k10, k11, k12, k13]),
            14 => at.shift(part, (x, h), A15, [k1, k6, k7, k8, k9, k10, k11, k12, k13, k14]),
            15 => at.shift(part, (x, h), A16, [k1, k6, k7, k8, k9, k10, k11, k12, k13]),
            _ => at.shift(part, (x, h), B, [k1, k8, k9, k10, k11, k12, k13, k14, k15]),
        }
    }
}

impl Pair for Verner98 {
    const NAME: &'static str = "Vern9";
    const ORDER: u32 = 9;
    const EVALUATIONS: u64 = 15;
    /// That of [`Dop853`](super::Dop853): four fifths of its evaluations there, and a fifth of its error.
    const RTOL: f64 = 1e-9;
    const LIMITS: Limits =
        Limits { safety: 0.7, exponent: 1.0 / 9.0, memory: 0.0, shrink: 0.333, growth: 6.0 };

    type Stages<X: Copy + Debug> = Stages<X>;
    type Bends<X: Copy + Debug> = [X; 5];

    fn blank<X: Copy + Debug>(x: X) -> Stages<X> {
        Stages { k1: x, k8: x, k9: x, k10: x, k11: x, k12: x, k13: x, k14: x, k15: x, k16: x }
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
        let mut all = [*first; 16];
        let end = stages::<M, Self, 16>((t, h), x, &mut all, &mut rates);
        let [k1, _, _, _, _, _, _, k8, k9, k10, k11, k12, k13, k14, k15, k16] = &all;
        *k = Stages {
            k1: *k1,
            k8: *k8,
            k9: *k9,
            k10: *k10,
            k11: *k11,
            k12: *k12,
            k13: *k13,
            k14: *k14,
            k15: *k15,
            k16: *k16,
        };
        end
    }

    #[inline]
    fn rate_at_end<X: Copy + Debug>(_k: &Stages<X>) -> Option<&X> {
        None
    }

    #[inline]
    fn error<S: Real, X: Vector<S>>(h: S, k: &Stages<X>, weight: &X) -> S {
        let Stages { k1, k8, k9, k10, k11, k12, k13, k14, k15, k16 } = k;
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k16];
        let error = X::weighted(E, all).map2(weight, |error, weight| error * weight);
        let sum = error.fold(S::lit(0.0), |sum, e| e.mul_add(e, sum));
        h.abs() * (sum / S::lit(X::LEN.max(1) as f64)).sqrt()
    }

    fn bend<M: System>(
        t: M::S,
        h: M::S,
        x: &M::X,
        k: &Stages<M::X>,
        k17: &M::X,
        mut rate: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> [M::X; 5] {
        let at = |c: f64| M::S::lit(c).mul_add(h, t);
        let Stages { k1, k8, k9, k10, k11, k12, k13, k14, k15, .. } = k;
        let [mut k18, mut k19, mut k20, mut k21] = [*k17; 4];
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17];
        rate(at(C18), &x.moved(h, A18, all), &mut k18);
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, &k18];
        rate(at(C19), &x.moved(h, A19, all), &mut k19);
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, &k18, &k19];
        rate(at(C20), &x.moved(h, A20, all), &mut k20);
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, &k18, &k19, &k20];
        rate(at(C21), &x.moved(h, A21, all), &mut k21);
        let all = [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, &k18, &k19, &k20, &k21];
        [D4, D5, D6, D7, D8].map(|weights| M::X::weighted(weights, all).map(|s| h * s))
    }
}
