//! Elementary functions that machine code calls: those of compiled code, with their bits.

use plm_runtime::Scalar;

/// An elementary function of one number or two, or of several angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Function {
    Asin,
    Acos,
    Atan2,
    Exp,
    Ln,
    Floor,
    /// Sines and cosines of so many angles: 1, 2, 4 or 8.
    Sines(usize),
}

extern "C" fn asin(x: f64) -> f64 {
    Scalar::asin(x)
}

extern "C" fn acos(x: f64) -> f64 {
    Scalar::acos(x)
}

extern "C" fn atan2(y: f64, x: f64) -> f64 {
    Scalar::atan2(y, x)
}

extern "C" fn exp(x: f64) -> f64 {
    Scalar::exp(x)
}

extern "C" fn ln(x: f64) -> f64 {
    Scalar::ln(x)
}

extern "C" fn floor(x: f64) -> f64 {
    Scalar::floor(x)
}

impl Function {
    /// Its address in memory.
    pub(crate) fn address(self) -> usize {
        let address = match self {
            Self::Asin => asin as *const (),
            Self::Acos => acos as *const (),
            Self::Atan2 => atan2 as *const (),
            Self::Exp => exp as *const (),
            Self::Ln => ln as *const (),
            Self::Floor => floor as *const (),
            Self::Sines(count) => crate::call::sines(count),
        };
        address.addr()
    }

    /// How many numbers it takes.
    pub(crate) fn arguments(self) -> usize {
        match self {
            Self::Atan2 => 2,
            Self::Sines(count) => count,
            _ => 1,
        }
    }
}

/// Have `mul_add` and with it the steps one rounding instead of two, as the feature `fma` has it?
pub(crate) fn is_fused() -> bool {
    // (1 + e)(1 - e) - 1 is -e^2 where it is rounded once; the product by itself is rounded to 1.
    let e = f64::EPSILON;
    Scalar::mul_add(1.0 + e, 1.0 - e, -1.0_f64) != 0.0
}
