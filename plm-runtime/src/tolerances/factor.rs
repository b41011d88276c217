//! Factor of a tolerance, for sweeps that show its effect on results.

extern crate std;

use core::sync::atomic::{AtomicU64, Ordering};

/// Factor of a tolerance.
#[derive(Debug)]
pub(crate) struct Factor {
    pub(super) name: &'static str,
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
        self.set(factor);
        factor
    }

    pub(super) fn set(&self, factor: f64) {
        self.bits.store(factor.to_bits(), Ordering::Relaxed);
    }
}

/// The factor of a tolerance according to `PLM_VARY=NAME=FACTOR`.
fn from_environment(name: &str) -> Option<f64> {
    let given = std::env::var("PLM_VARY").ok()?;
    let (named, factor) = given.split_once('=')?;
    factor.parse().ok().filter(|_| named == name)
}
