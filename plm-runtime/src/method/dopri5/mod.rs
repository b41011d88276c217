//! Dormand-Prince 5(4), the program DOPRI5 of E. Hairer and G. Wanner.

mod tableau;

use core::fmt::Debug;
use core::ops::Range;

use self::tableau::{A2, A3, A4, A5, A6, A7, C2, C3, C4, C5, D, E};
use super::embedded::{Embedded, Limits, Pair, Rows, stages};
use super::rates::Rates;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Dormand-Prince 5(4): steps of order 5 in six evaluations, dense output of order 4 in none more.
pub type Dopri5<M> = Embedded<M, DormandPrince5>;

/// The formulas of [`Dopri5`].
#[derive(Clone, Copy, Debug)]
pub struct DormandPrince5;

/// Stages 1 and 3 to 7.
#[derive(Clone, Copy, Debug)]
pub struct Stages<X> {
    k1: X,
    k3: X,
    k4: X,
    k5: X,
    k6: X,
    k7: X,
}

impl<X> Stages<X> {
    #[inline]
    fn all(&self) -> [&X; 6] {
        [&self.k1, &self.k3, &self.k4, &self.k5, &self.k6, &self.k7]
    }
}

impl Rows<6> for DormandPrince5 {
    const NODES: [f64; 6] = [0.0, C2, C3, C4, C5, 1.0];

    #[allow(clippy::inline_always, reason = "as the stages")]
    #[inline(always)]
    fn row<S: Scalar, X: Vector<S>>(
        stage: usize,
        part: Range<usize>,
        (x, h): (&X, S),
        k: &[X; 6],
        at: &mut X,
    ) {
        let [k1, k2, k3, k4, k5, k6] = k;
        match stage {
            1 => at.shift(part, (x, h), A2, [k1]),
            2 => at.shift(part, (x, h), A3, [k1, k2]),
            3 => at.shift(part, (x, h), A4, [k1, k2, k3]),
            4 => at.shift(part, (x, h), A5, [k1, k2, k3, k4]),
            5 => at.shift(part, (x, h), A6, [k1, k2, k3, k4, k5]),
            _ => at.shift(part, (x, h), A7, [k1, k3, k4, k5, k6]),
        }
    }
}

impl Pair for DormandPrince5 {
    const NAME: &'static str = "Dopri5";
    const ORDER: u32 = 5;
    const EVALUATIONS: u64 = 6;
    const RTOL: f64 = 1e-8;
    const LIMITS: Limits =
        Limits { safety: 0.9, exponent: 0.2 - 0.75 * 0.04, memory: 0.04, shrink: 0.2, growth: 10.0 };

    type Stages<X: Copy + Debug> = Stages<X>;
    type Bends<X: Copy + Debug> = [X; 1];

    fn blank<X: Copy + Debug>(x: X) -> Stages<X> {
        Stages { k1: x, k3: x, k4: x, k5: x, k6: x, k7: x }
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
        let mut all = [*first; 6];
        let end = stages::<M, Self, 6>((t, h), x, &mut all, &mut rates);
        let [k1, _, k3, k4, k5, k6] = &all;
        *k = Stages { k1: *k1, k3: *k3, k4: *k4, k5: *k5, k6: *k6, k7: *k6 };
        rates.at(t + h, &end, &mut k.k7);
        end
    }

    #[inline]
    fn rate_at_end<X: Copy + Debug>(k: &Stages<X>) -> Option<&X> {
        Some(&k.k7)
    }

    #[inline]
    fn error<S: Real, X: Vector<S>>(h: S, k: &Stages<X>, weight: &X) -> S {
        let error = X::weighted(E, k.all()).map2(weight, |error, weight| error * weight);
        let sum = error.fold(S::lit(0.0), |sum, e| e.mul_add(e, sum));
        h.abs() * (sum / S::lit(X::LEN.max(1) as f64)).sqrt()
    }

    fn bend<M: System>(
        _t: M::S,
        h: M::S,
        _x: &M::X,
        k: &Stages<M::X>,
        _last: &M::X,
        _rate: impl FnMut(M::S, &M::X, &mut M::X),
    ) -> [M::X; 1] {
        [M::X::weighted(D, k.all()).map(|s| h * s)]
    }
}
