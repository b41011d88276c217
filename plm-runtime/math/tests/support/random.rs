//! Random arguments for tests: always the same ones.

/// splitmix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number of any size and sign, often of moderate size, sometimes infinite or NaN.
    pub(crate) fn number(&mut self) -> f64 {
        let bits = self.bits();
        if bits & 1 == 0 {
            return f64::from_bits(self.bits());
        }
        let exponent = 1023 - 20 + (bits >> 1) % 40;
        f64::from_bits((self.bits() & !(0x7ff << 52)) | exponent << 52)
    }
}
