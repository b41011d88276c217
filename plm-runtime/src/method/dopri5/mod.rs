//! Dormand-Prince 5(4), the program DOPRI5 of E. Hairer and G. Wanner.

mod tableau;

#[allow(clippy::wildcard_imports, reason = "the tableau takes every coefficient")]
use self::tableau::*;
use super::embedded::{Embedded, Limits, pair};

/// Dormand-Prince 5(4): steps of order 5 in six evaluations, dense output of order 4 in none more.
pub type Dopri5<M> = Embedded<M, DormandPrince5>;

pair! {
    /// The formulas of [`Dopri5`].
    DormandPrince5 {
        name: "Dopri5", order: 5, rates: 6, rtol: 1e-8,
        limits: Limits { safety: 0.9, exponent: 0.2 - 0.75 * 0.04, memory: 0.04, shrink: 0.2, growth: 10.0 }
    }
    stages: 6 [k1, k2, k3, k4, k5, k6] at [0.0, C2, C3, C4, C5, 1.0];
    1: A2 [k1];
    2: A3 [k1, k2];
    3: A4 [k1, k2, k3];
    4: A5 [k1, k2, k3, k4];
    5: A6 [k1, k2, k3, k4, k5];
    end: A7 [k1, k3, k4, k5, k6];
    last: k7;
    kept: 6 [k1, k3, k4, k5, k6, k7];
    error: E;
    dense {
        bends: 1 [D] of [k1, k3, k4, k5, k6, k7];
    }
}
