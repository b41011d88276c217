//! Parts of hydraulics, 1-D mechanics and signals: their laws at random states, and runs of them.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod laws;
mod mechanics;
mod runs;
mod signals;

/// splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Evenly between two numbers.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Equal to so much of the larger of a scale and the values.
pub(crate) fn assert_near(found: f64, expected: f64, scale: f64, what: &str) {
    let size = scale.max(expected.abs());
    assert!((found - expected).abs() <= 1e-9 * size, "{what}: {found} instead of {expected}");
}
