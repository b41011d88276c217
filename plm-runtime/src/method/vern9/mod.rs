//! Verner 9(8), the most efficient of his pairs of these orders.

#[cfg(test)]
mod conditions;
mod tableau;

#[allow(clippy::wildcard_imports, reason = "the tableau takes every coefficient")]
use self::tableau::*;
use super::embedded::{Embedded, Limits, pair};

/// Verner 9(8): steps of order 9 in sixteen evaluations, dense output of order 8 in four more if it is requested.
pub type Vern9<M> = Embedded<M, Verner98>;

pair! {
    /// The formulas of [`Vern9`] (J. H. Verner, Numerically optimal Runge-Kutta pairs with interpolants, Numer. Algorithms 53,
    /// 2010).
    Verner98 {
        name: "Vern9", order: 9, rates: 15,
        /// As [`Dop853`](super::Dop853): four fifths of its evaluations at this tolerance, and a fifth of its error.
        rtol: 1e-9,
        limits: Limits { safety: 0.7, exponent: 1.0 / 9.0, memory: 0.0, shrink: 0.333, growth: 6.0 }
    }
    stages: 16 [k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16]
        at [0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, 1.0, 1.0];
    1: A2 [k1];
    2: A3 [k1, k2];
    3: A4 [k1, k3];
    4: A5 [k1, k3, k4];
    5: A6 [k1, k4, k5];
    6: A7 [k1, k4, k5, k6];
    7: A8 [k1, k6, k7];
    8: A9 [k1, k6, k7, k8];
    9: A10 [k1, k6, k7, k8, k9];
    10: A11 [k1, k6, k7, k8, k9, k10];
    11: A12 [k1, k6, k7, k8, k9, k10, k11];
    12: A13 [k1, k6, k7, k8, k9, k10, k11, k12];
    13: A14 [k1, k6, k7, k8, k9, k10, k11, k12, k13];
    14: A15 [k1, k6, k7, k8, k9, k10, k11, k12, k13, k14];
    15: A16 [k1, k6, k7, k8, k9, k10, k11, k12, k13];
    end: B [k1, k8, k9, k10, k11, k12, k13, k14, k15];
    kept: 10 [k1, k8, k9, k10, k11, k12, k13, k14, k15, k16];
    error: E;
    rate_at_end: k17;
    dense {
        stage k18 at C18: A18 [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17];
        stage k19 at C19: A19 [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, k18];
        stage k20 at C20: A20 [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, k18, k19];
        stage k21 at C21: A21 [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, k18, k19, k20];
        bends: 5 [D4, D5, D6, D7, D8] of [k1, k8, k9, k10, k11, k12, k13, k14, k15, k17, k18, k19, k20, k21];
    }
}
