//! Numbers by chance, the same for the same seed.

/// splitmix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014).
pub struct Random(u64);

impl Random {
    /// A stream of its own for each case.
    pub fn new(seed: u64, case: u64) -> Self {
        let mut mixed = Self(seed.wrapping_add(case.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
        Self(mixed.bits() ^ case)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// The same, as a number that f32 has too.
    pub fn single(&mut self, low: f64, high: f64) -> f64 {
        round(self.between(low, high))
    }

    /// A multiple of 1/64: sums and differences of lengths are exact.
    pub fn grid(&mut self, low: f64, high: f64) -> f64 {
        (self.between(low, high) * 64.0).round() / 64.0
    }

    /// Spread evenly in the logarithm, of either sign.
    pub fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(self.between(low.log10(), high.log10()));
        if self.chance(0.5) { size } else { -size }
    }

    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    pub fn one_of<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// To what f32 can hold.
pub fn round(value: f64) -> f64 {
    f64::from(value as f32)
}
