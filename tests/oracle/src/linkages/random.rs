//! Numbers by chance, the same for the same seed.

pub use plm_oracle::Random;

/// Numbers of cases.
pub trait Numbers {
    /// Evenly between two numbers, as a number that f32 has too.
    fn single(&mut self, low: f64, high: f64) -> f64;
    /// Spread evenly in the logarithm, of either sign.
    fn logarithmic(&mut self, low: f64, high: f64) -> f64;
}

impl Numbers for Random {
    fn single(&mut self, low: f64, high: f64) -> f64 {
        round(self.between(low, high))
    }

    fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(self.between(low.log10(), high.log10()));
        if self.chance(0.5) { size } else { -size }
    }
}

/// To what f32 can hold.
pub fn round(value: f64) -> f64 {
    f64::from(value as f32)
}
