//! Numbers by chance, the same for the same seed.

#[path = "../../tests/support/random.rs"]
mod stream;

pub use stream::Random;

impl Random {
    /// Evenly between two numbers, as a number that f32 has too.
    pub fn single(&mut self, low: f64, high: f64) -> f64 {
        round(self.between(low, high))
    }

    /// Spread evenly in the logarithm, of either sign.
    pub fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(self.between(low.log10(), high.log10()));
        if self.chance(0.5) { size } else { -size }
    }
}

/// To what f32 can hold.
pub fn round(value: f64) -> f64 {
    f64::from(value as f32)
}
