//! Factors of tolerances, for sweeps that show their effect on results.

extern crate std;

use core::sync::atomic::{AtomicU64, Ordering};

use super::{charts, closing, singular};

/// Factor of a tolerance.
#[derive(Debug)]
pub(crate) struct Factor {
    name: &'static str,
    /// Bits of the factor; 0 before its first use.
    bits: AtomicU64,
}

impl Factor {
    pub(super) const fn new(name: &'static str) -> Self {
        Self { name, bits: AtomicU64::new(0) }
    }

    /// The factor; at first use that of the environment.
    pub(super) fn get(&self) -> f64 {
        let bits = self.bits.load(Ordering::Relaxed);
        if bits != 0 {
            return f64::from_bits(bits);
        }
        let factor = from_environment(self.name).unwrap_or(1.0);
        self.bits.store(factor.to_bits(), Ordering::Relaxed);
        factor
    }
}

/// The factor of a tolerance according to `PLM_VARY=NAME=FACTOR`.
fn from_environment(name: &str) -> Option<f64> {
    let given = std::env::var("PLM_VARY").ok()?;
    let (named, factor) = given.split_once('=')?;
    factor.parse().ok().filter(|_| named == name)
}

fn all() -> impl Iterator<Item = &'static Factor> {
    [charts::FACTORS, singular::FACTORS, closing::FACTORS].into_iter().flatten().map(|factor| factor())
}

/// The names of all tolerances.
pub fn names() -> impl Iterator<Item = &'static str> {
    all().map(|factor| factor.name)
}

/// Multiplies a tolerance by a factor, in all runs of the process. Returns false if no tolerance has that
/// name.
pub fn set_factor(name: &str, factor: f64) -> bool {
    let found = all().find(|of| of.name == name);
    if let Some(of) = found {
        of.bits.store(factor.to_bits(), Ordering::Relaxed);
    }
    found.is_some()
}
