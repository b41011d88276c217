//! Random arguments for tests: always the same ones.

#[path = "../../../../tests/support/random.rs"]
mod stream;

pub(crate) use stream::Random;

impl Random {
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
