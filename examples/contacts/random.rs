//! Numbers by chance, the same for the same seed.

#[path = "../../tests/support/random.rs"]
mod stream;

pub use stream::Random;

impl Random {
    /// A stream of its own for each case.
    pub fn new(seed: u64, case: u64) -> Self {
        let mut mixed = Self(seed.wrapping_add(case.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
        Self(mixed.bits() ^ case)
    }

    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}
