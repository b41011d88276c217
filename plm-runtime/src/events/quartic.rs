//! Course of a guard over a short piece of a step, from nine of its values.
//!
//! Enclosures treat numbers that move together as if they moved independently: a gap between two bodies that move side by side is a small
//! difference of large motions, and its range over an interval is as wide as those. Along the dense output a guard is nearly a polynomial.
//! The quartic through five values is compared with four more between them: with a constant fifth derivative its largest error is at most
//! 1.11 times the error there. Its coefficients in S. Bernstein's form bound it, and their differences its slope (G. Farin, Curves and
//! Surfaces for CAGD, 5th edition, 5.1).

use crate::scalar::Real;

/// Number of equidistant values of a piece.
pub(super) const VALUES: usize = 9;
/// Bound of the error of the quartic, relative to its largest error at the four values.
const OFF: f64 = 4.0;
/// Error of a coefficient in roundings of the values: the sum of the sizes of its weights.
const ROUNDED: f64 = 16.0;
/// A guard falls if the error of the quartic is at most this part of its change.
const STEADY: f64 = 0.125;

/// Course of a guard over a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    /// The guard stays on its side.
    Stays,
    /// The guard leaves its side once, and does not return.
    Leaves,
    /// The values do not decide.
    Open,
}

/// Meaning of a distance from the edge that is below the rounding of the values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Near {
    /// Rounding alone: the curve is at its edge.
    Rounding,
    /// Unknown: the curve may be beyond its edge.
    Unknown,
}

/// Course of a guard with these values, which leaves its side at `edge`; `noise` is the rounding of the values.
pub(super) fn curve<S: Real>(values: &[S; VALUES], (edge, noise): (S, S), near: Near) -> Curve {
    let violated = edge - noise;
    let even = [values[0], values[2], values[4], values[6], values[8]];
    let weigh = |weights: [f64; 5], over: f64| {
        let terms = weights.iter().zip(&even);
        terms.fold(S::ZERO, |sum, (weight, value)| S::lit(*weight / over).mul_add(*value, sum))
    };
    // The quartic at the odd values.
    let odd = [
        weigh([35.0, 140.0, -70.0, 28.0, -5.0], 128.0),
        weigh([-5.0, 60.0, 90.0, -20.0, 3.0], 128.0),
        weigh([3.0, -20.0, 90.0, 60.0, -5.0], 128.0),
        weigh([-5.0, 28.0, -70.0, 140.0, 35.0], 128.0),
    ];
    let given = [values[1], values[3], values[5], values[7]];
    let off = odd.iter().zip(&given).fold(S::ZERO, |off, (one, other)| off.max((*one - *other).abs()));
    let fits = off <= noise;
    let off = S::lit(OFF) * off;
    let control = [
        even[0],
        weigh([-13.0, 48.0, -36.0, 16.0, -3.0], 12.0),
        weigh([13.0, -64.0, 120.0, -64.0, 13.0], 18.0),
        weigh([-3.0, 16.0, -36.0, 48.0, -13.0], 12.0),
        even[4],
    ];
    // Coefficients have more rounding than values.
    let least = match near {
        Near::Unknown => edge + if fits { S::ZERO } else { off },
        Near::Rounding if fits => violated - S::lit(ROUNDED) * noise,
        Near::Rounding => violated + off,
    };
    // Comparisons with NaN are false.
    if control.iter().all(|control| *control >= least) && values.iter().all(|value| *value >= violated) {
        return Curve::Stays;
    }
    let falls = control.windows(2).all(|pair| pair[1] <= pair[0]);
    let is_steady = off <= S::lit(STEADY) * (values[0] - values[8]);
    let leaves = values[0] >= violated && values[8] < violated;
    if leaves && falls && is_steady { Curve::Leaves } else { Curve::Open }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(guard: impl Fn(f64) -> f64) -> Curve {
        curve(&core::array::from_fn(|k| guard(k as f64 / 8.0)), (1e-15, 1e-15), Near::Rounding)
    }

    /// A dip that is as deep as the rounding of the values stays open, until rounding is evaluated where it happens.
    #[test]
    fn dips_as_deep_as_rounding_stay_open() {
        let dip = |depth: f64| core::array::from_fn(|k| 2e-4 * (k as f64 / 8.0 - 0.4).powi(2) - depth);
        for depth in [0.0, 1e-6, 1e-5] {
            assert_eq!(curve(&dip(depth), (0.0, 1e-4), Near::Unknown), Curve::Open);
            assert_eq!(curve(&dip(depth), (0.0, 1e-4), Near::Rounding), Curve::Stays);
        }
        assert_eq!(curve(&dip(-1e-4), (0.0, 1e-4), Near::Unknown), Curve::Stays);
        assert_eq!(curve(&[0.0; VALUES], (0.0, 1e-4), Near::Unknown), Curve::Stays);
    }

    #[test]
    fn smooth_guards_stay_leave_or_stay_open() {
        for height in [1e-12, 1e-6, 1.0] {
            assert_eq!(of(|t| height * (1.0 + (0.7 * t).sin())), Curve::Stays, "{height}");
            assert_eq!(of(|t| height * (0.5 - t - 0.1 * t.powi(3))), Curve::Leaves, "{height}");
            // It dips below zero, or nearly so.
            assert_eq!(of(|t| height * ((t - 0.4).powi(2) - 1e-3)), Curve::Open, "{height}");
        }
        assert_eq!(of(|_| 0.0), Curve::Stays);
        assert_eq!(of(|_| -2e-16), Curve::Open);
        assert_eq!(of(|_| f64::NAN), Curve::Open);
    }

    #[test]
    fn corners_and_jumps_stay_open() {
        assert_eq!(of(|t| (t - 0.45).abs() - 1e-3), Curve::Open);
        assert_eq!(of(|t| if t < 0.3 { 1e-9 } else { -1.0 }), Curve::Open);
    }

    /// Verdicts on random polynomials of the degree of a dense output agree with 1000 of their values.
    #[test]
    fn what_is_told_of_polynomials_is_true() {
        let (mut told, mut state) = ([0; 3], 5_u64);
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        for _ in 0..20_000 {
            let c: [f64; 9] = core::array::from_fn(|k| number() * 0.5_f64.powi(k as i32));
            let guard = |t: f64| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
            let found = of(guard);
            told[found as usize] += 1;
            let all = (0..=1000).map(|k| guard(0.001 * f64::from(k)));
            match found {
                Curve::Stays => assert!(all.fold(1.0, f64::min) >= -2e-14, "{c:?}"),
                Curve::Leaves => {
                    let signs: [bool; 1001] = core::array::from_fn(|k| guard(0.001 * k as f64) < 0.0);
                    assert!(signs.windows(2).all(|pair| pair[0] <= pair[1]), "{c:?}");
                }
                Curve::Open => {}
            }
        }
        assert!(told[0] > 4000 && told[1] > 1000, "{told:?}");
    }
}
