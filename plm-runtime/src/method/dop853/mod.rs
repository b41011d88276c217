//! Dormand-Prince 8(5,3), the program DOP853 of E. Hairer and G. Wanner.

#[cfg(test)]
mod conditions;
mod tableau;

#[allow(clippy::wildcard_imports, reason = "the tableau takes every coefficient")]
use self::tableau::*;
use super::embedded::{Embedded, Limits, pair};

/// Dormand-Prince 8(5,3): steps of order 8 in twelve evaluations, dense output of order 7 in three more if it is requested.
pub type Dop853<M> = Embedded<M, DormandPrince853>;

pair! {
    /// The formulas of [`Dop853`] (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
    /// II.5, II.6, and their program DOP853).
    DormandPrince853 {
        name: "Dop853", order: 8, rates: 11,
        /// Tolerance at which it costs as much as Dormand-Prince 5(4) at 1e-8, with a hundredth of its error.
        rtol: 1e-9,
        /// The authors' values except for the safety, theirs is 0.9: with that up to a third of the steps is rejected, which
        /// costs the double pendulum, a four-bar and a slider-crank a third more evaluations for an error of 1e-10.
        limits: Limits { safety: 0.7, exponent: 0.125, memory: 0.0, shrink: 0.333, growth: 6.0 }
    }
    stages: 12 [k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12]
        at [0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, 1.0];
    1: A2 [k1];
    2: A3 [k1, k2];
    3: A4 [k1, k3];
    4: A5 [k1, k3, k4];
    5: A6 [k1, k4, k5];
    6: A7 [k1, k4, k5, k6];
    7: A8 [k1, k4, k5, k6, k7];
    8: A9 [k1, k4, k5, k6, k7, k8];
    9: A10 [k1, k4, k5, k6, k7, k8, k9];
    10: A11 [k1, k4, k5, k6, k7, k8, k9, k10];
    11: A12 [k1, k4, k5, k6, k7, k8, k9, k10, k11];
    end: B [k1, k6, k7, k8, k9, k10, k11, k12];
    kept: 8 [k1, k6, k7, k8, k9, k10, k11, k12];
    error: E5, E3;
    rate_at_end: k13;
    dense {
        stage k14 at C14: A14 [k1, k7, k8, k9, k10, k11, k12, k13];
        stage k15 at C15: A15 [k1, k6, k7, k8, k11, k12, k13, k14];
        stage k16 at C16: A16 [k1, k6, k7, k8, k9, k13, k14, k15];
        bends: 4 [D4, D5, D6, D7] of [k1, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16];
    }
}
