//! Random numbers by their place: Philox4x32-10 of J. K. Salmon, M. A. Moraes, R. O. Dror and D. E. Shaw, Parallel random numbers: as
//! easy as 1, 2, 3, SC'11. A number follows from the seed, the point and the parameter, without those before it.

use core::f64::consts::TAU;

use plm_runtime::Scalar;

/// Four 32-bit words from a counter of four and a key of two.
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    for _ in 0..10 {
        let [a, b, c, d] = counter;
        let (first, second) = (u64::from(a) * 0xD251_1F53, u64::from(c) * 0xCD9E_8D57);
        let high = |product: u64| (product >> 32) as u32;
        counter = [high(second) ^ b ^ key[0], second as u32, high(first) ^ d ^ key[1], first as u32];
        key = [key[0].wrapping_add(0x9E37_79B9), key[1].wrapping_add(0xBB67_AE85)];
    }
    counter
}

/// Two numbers in [0, 1), for a parameter of a point.
fn pair(seed: u64, point: u64, parameter: u32) -> [f64; 2] {
    let halves = |word: u64| [word as u32, (word >> 32) as u32];
    let [low, high] = halves(point);
    let [a, b, c, d] = philox([low, high, parameter, 0], halves(seed));
    let unit = |low: u32, high: u32| {
        let word = u64::from(high) << 32 | u64::from(low);
        // The 53 bits that a double holds.
        (word >> 11) as f64 / (1_u64 << 53) as f64
    };
    [unit(a, b), unit(c, d)]
}

/// A number in [0, 1).
pub(super) fn uniform(seed: u64, point: u64, parameter: u32) -> f64 {
    pair(seed, point, parameter)[0]
}

/// A number of the normal distribution with mean 0 and standard deviation 1 (G. E. P. Box and M. E. Muller, 1958). By functions
/// of plm, which have the same bits on every machine.
pub(super) fn normal(seed: u64, point: u64, parameter: u32) -> f64 {
    let [radius, turn] = pair(seed, point, parameter);
    Scalar::sqrt(-2.0 * Scalar::ln(1.0 - radius)) * Scalar::cos(TAU * turn)
}

#[cfg(test)]
mod tests {
    use super::philox;

    /// Random123, tests/kat_vectors.
    #[test]
    fn philox_gives_the_published_words() {
        assert_eq!(philox([0; 4], [0; 2]), [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]);
        let all = u32::MAX;
        assert_eq!(philox([all; 4], [all; 2]), [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]);
        let pi = [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344];
        let found = philox(pi, [0xa409_3822, 0x299f_31d0]);
        assert_eq!(found, [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1]);
    }
}
