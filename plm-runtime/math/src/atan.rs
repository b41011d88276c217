//! Arc tangent of a number and of a direction.
//!
//! Method: the ratio of the smaller to the larger coordinate is an angle in the first eighth of a turn; above a ratio
//! of 1/2 it is measured from the diagonal, tan(pi/4 - a) = (1 - tan a)/(1 + tan a). The quotient is carried with its
//! rounding error (Dekker), so that one polynomial and one addition to a multiple of pi/4 finish the result.
//! Coefficients: tools/minimax.py.

use crate::float::{Float, polynomial, scale_to_one};
use crate::pair::Pair;

/// Constants of the inverse functions.
pub(crate) trait Arc: Float {
    /// pi/4, pi/2, 3 pi/4 and pi.
    const EIGHTHS: [Pair<Self>; 4];
    /// atan u = u - u z p(z), z = u^2, |u| <= 1/2.
    const ATAN: &[Self];
}

impl Arc for f64 {
    const EIGHTHS: [Pair<f64>; 4] = [
        Pair { high: core::f64::consts::FRAC_PI_4, less: -3.061616997868383e-17 },
        Pair { high: core::f64::consts::FRAC_PI_2, less: -6.123233995736766e-17 },
        Pair { high: 2.356194490192345, less: -9.184850993605148e-17 },
        Pair { high: core::f64::consts::PI, less: -1.2246467991473532e-16 },
    ];
    const ATAN: &[f64] = &[
        0.3333333333333298,
        -0.19999999999903104,
        0.1428571427638483,
        -0.11111110659569598,
        0.09090896242600004,
        -0.07692073872881201,
        0.0666381015739236,
        -0.05858295486076139,
        0.05121989284217946,
        -0.0418645480689784,
        0.027434107804793734,
        -0.010116227900356756,
    ];
}

impl Arc for f32 {
    const EIGHTHS: [Pair<f32>; 4] = [
        Pair { high: core::f32::consts::FRAC_PI_4, less: 2.1855695e-08 },
        Pair { high: core::f32::consts::FRAC_PI_2, less: 4.371139e-08 },
        Pair { high: 2.3561945, less: 5.9624403e-09 },
        Pair { high: core::f32::consts::PI, less: 8.742278e-08 },
    ];
    const ATAN: &[f32] = &[0.33333328, -0.19999555, 0.14273107, -0.10948411, 0.080090836, -0.039042328];
}

#[inline]
pub(crate) fn atan<F: Arc>(x: F) -> F {
    atan2(x, F::ONE)
}

#[inline]
pub(crate) fn atan2<F: Arc>(y: F, x: F) -> F {
    if is_direct(y, x) { direction(y, x) } else { atan2_extreme(y, x) }
}

/// One path for all lanes; each operation is written for one lane, and compilers join them.
#[inline]
pub(crate) fn atan2_lanes<F: Arc, const N: usize>(y: [F; N], x: [F; N]) -> [F; N] {
    let direct = (0..N).fold(true, |all, lane| all & is_direct(y[lane], x[lane]));
    if !direct {
        return atan2_each(y, x);
    }
    let mut angles = [F::ZERO; N];
    for lane in 0..N {
        angles[lane] = direction(y[lane], x[lane]);
    }
    angles
}

/// Lanes of which one at least leaves the direct path.
#[cold]
#[inline(never)]
fn atan2_each<F: Arc, const N: usize>(y: [F; N], x: [F; N]) -> [F; N] {
    core::array::from_fn(|lane| atan2(y[lane], x[lane]))
}

/// Has the quotient of these coordinates normal error terms?
#[inline]
fn is_direct<F: Arc>(y: F, x: F) -> bool {
    let (larger, smaller) = if y.abs() > x.abs() { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    (smaller >= F::power_of_two(-F::SCALE)) & (larger <= F::power_of_two(F::SCALE))
}

/// atan2 for coordinates whose quotient has normal error terms.
#[inline]
fn direction<F: Arc>(y: F, x: F) -> F {
    let steep = y.abs() > x.abs();
    let (larger, smaller) = if steep { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    let diagonal = smaller + smaller > larger;
    let numerator = if diagonal { larger - smaller } else { smaller };
    let denominator =
        if diagonal { Pair::sum(larger, smaller) } else { Pair { high: larger, less: F::ZERO } };
    let u = Pair { high: numerator, less: F::ZERO }.over(denominator);
    let z = u.high * u.high;
    let less = u.high * z * polynomial(z, F::ATAN) + (u.less - u.less * z);

    let [eighth, quarter, three_eighths, half] = F::EIGHTHS;
    let backward = x < F::ZERO;
    let axis = match (diagonal, steep, backward) {
        (true, _, false) => eighth,
        (true, _, true) => three_eighths,
        (false, true, _) => quarter,
        (false, false, false) => Pair { high: F::ZERO, less: F::ZERO },
        (false, false, true) => half,
    };
    let side = if diagonal ^ steep ^ backward { -F::ONE } else { F::ONE };
    axis.plus(side, Pair { high: u.high, less }).copysign(y)
}

/// Coordinates that are zero, infinite, NaN, or very large or small.
#[cold]
#[inline(never)]
fn atan2_extreme<F: Arc>(y: F, x: F) -> F {
    if x.abs() < F::INFINITY && y.abs() < F::INFINITY {
        return atan2_finite(y, x);
    }
    let [eighth, quarter, three_eighths, half] = F::EIGHTHS;
    let angle = match (x.abs() == F::INFINITY, y.abs() == F::INFINITY) {
        (true, true) => {
            if x > F::ZERO {
                eighth.value()
            } else {
                three_eighths.value()
            }
        }
        (true, false) if y.abs() < F::INFINITY => {
            if x > F::ZERO {
                F::ZERO
            } else {
                half.value()
            }
        }
        (false, true) if x.abs() < F::INFINITY => quarter.value(),
        _ => return F::NAN,
    };
    angle.copysign(y)
}

fn atan2_finite<F: Arc>(y: F, x: F) -> F {
    let [_, quarter, _, half] = F::EIGHTHS;
    let negligible = F::power_of_two(-F::DIGITS - 8);
    let backward = F::ONE.copysign(x) < F::ZERO;
    if y.abs() <= x.abs() * negligible {
        // Both zero is the axis, too.
        if backward {
            half.value().copysign(y)
        } else if y == F::ZERO {
            y
        } else {
            (y / x).copysign(y)
        }
    } else if x.abs() <= y.abs() * negligible {
        quarter.value().copysign(y)
    } else {
        let scale = F::power_of_two(scale_to_one(if x.abs() > y.abs() { x } else { y }));
        direction(y * scale, x * scale)
    }
}
