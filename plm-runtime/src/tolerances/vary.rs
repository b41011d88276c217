//! A factor for each tolerance, for sweeps that ask what becomes of results.

extern crate std;

use core::sync::atomic::{AtomicU64, Ordering};

use super::{charts, closing, singular};

/// What a tolerance is multiplied by.
#[derive(Debug)]
pub(crate) struct Factor {
    name: &'static str,
    /// The bits of the factor; 0 before it was asked for.
    bits: AtomicU64,
}

impl Factor {
    pub(super) const fn new(name: &'static str) -> Self {
        Self { name, bits: AtomicU64::new(0) }
    }

    /// The factor; at first that of the environment.
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

/// The factor of a tolerance that `PLM_VARY=NAME=FACTOR` gives.
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

/// Multiplies a tolerance by a factor, in all runs of the process; whether there is one of that name.
pub fn set_factor(name: &str, factor: f64) -> bool {
    let found = all().find(|of| of.name == name);
    if let Some(of) = found {
        of.bits.store(factor.to_bits(), Ordering::Relaxed);
    }
    found.is_some()
}
