//! Parameters that only some values make sense for: what the compiler says of a literal, said of a number at the start.

use crate::fault::{Cause, Fault};
use crate::scalar::Real;

/// Limit of a value of the declaration that depends on parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// The body or joint that it belongs to.
    pub part: &'static str,
    /// Quantity: `mass`, `compliance`.
    pub what: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The least that it may be.
    pub least: Least,
}

/// The least that a value may be; of some the most, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Least {
    /// More than zero: something divides by it.
    Positive,
    /// Zero, if other masses carry it: [`absolute::check_carried`](crate::absolute::check_carried) checks that.
    Carried,
    /// Zero.
    Zero,
    /// There is none, and zero is the most.
    Negative,
    /// Zero, and one is the most.
    Share,
    /// Zero, and infinity is allowed: the margin of a requirement of parameters.
    Required,
}

impl Least {
    fn wanted(self) -> &'static str {
        match self {
            Self::Positive | Self::Carried => "positive and finite",
            Self::Zero => "finite and not negative",
            Self::Negative => "finite and not positive",
            Self::Share => "0 to 1",
            Self::Required => "kept",
        }
    }

    fn allows<S: Real>(self, value: S) -> bool {
        let zero = S::lit(0.0);
        let is_allowed = value.is_finite() || matches!(self, Self::Required);
        is_allowed
            && match self {
                Self::Positive => zero < value,
                Self::Carried | Self::Zero | Self::Required => zero <= value,
                Self::Negative => value <= zero,
                Self::Share => zero <= value && value <= S::lit(1.0),
            }
    }
}

/// Checks the values that parameters give to limited quantities.
///
/// # Errors
/// [`Cause::NotAllowed`] for the first one that is outside of them, [`Cause::NotMet`] of a requirement.
pub fn check<S: Real>(t: S, values: &[S], limits: &[Limit]) -> Result<(), Fault> {
    match values.iter().zip(limits).find(|(value, limit)| !limit.least.allows(**value)) {
        None => Ok(()),
        Some((value, Limit { part, least: Least::Required, .. })) => {
            Err(Fault::of_part(t.to_f64(), part, Cause::NotMet { by: -value.to_f64() }))
        }
        Some((value, limit)) => Err(refused(t, limit, limit.least.wanted(), *value)),
    }
}

/// Looks for parameters, by name, unit and value, that are not numbers.
///
/// # Errors
/// [`Cause::NotAllowed`] for the first one.
pub fn check_numbers<S: Real>(
    t: S,
    parameters: impl IntoIterator<Item = (&'static str, &'static str, S)>,
) -> Result<(), Fault> {
    // NaN does not equal itself; infinity is a number that a limit of a force may well have.
    match parameters.into_iter().find(|(.., value)| value.partial_cmp(value).is_none()) {
        None => Ok(()),
        Some((part, unit, value)) => {
            let limit = Limit { part, what: "parameter", unit, least: Least::Zero };
            Err(refused(t, &limit, "a number", value))
        }
    }
}

/// The fault of a value that is outside of its limit.
pub(crate) fn refused<S: Real>(t: S, limit: &Limit, wanted: &'static str, value: S) -> Fault {
    let Limit { part, what, unit, .. } = *limit;
    Fault::of_part(t.to_f64(), part, Cause::NotAllowed { what, wanted, found: value.to_f64(), unit })
}

/// A number made of parameters that changes whenever one of them does: every step of it can be undone, so that no two
/// values of one parameter give the same (the mixing step is that of FNV-1a, with the multiplier of D. E. Knuth's MMIX).
pub fn fingerprint<S: Real, const N: usize>(parameters: [S; N]) -> u64 {
    const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
    parameters.into_iter().fold(N as u64, |mixed, value| {
        (mixed ^ value.to_f64().to_bits()).wrapping_mul(MULTIPLIER).rotate_left(23)
    })
}
