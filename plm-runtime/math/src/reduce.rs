//! Reduction of large angles modulo a quarter turn, in integers.
//!
//! Method: M. Payne and R. Hanek, "Radian reduction for trigonometric functions", ACM SIGNUM Newsletter 18(1), 1983.
//! Of 2/pi only those bits are multiplied that can reach the last two bits of the quotient's integer part and its
//! fraction.

/// 2/pi: a word of zeros, so that windows can begin before the point, then 1216 bits after the point.
const TWO_OVER_PI: [u64; 20] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
];

/// pi/2 * 2^63, rounded.
const PI_OVER_2: u64 = 0xc90f_daa2_2168_c235;

/// The angle m 2^e less a whole number of quarter turns.
pub(crate) struct Reduced {
    /// Quarter turns taken away, modulo 4.
    pub(crate) quarters: usize,
    /// True if the rest is negative.
    pub(crate) negative: bool,
    /// The rest's magnitude is fraction * 2^(exponent - 64); one of the two highest bits of the fraction is set.
    pub(crate) fraction: u64,
    /// See `fraction`.
    pub(crate) exponent: i32,
}

/// Reduces m 2^e, m < 2^53 and -62 <= e <= 971, to at most an eighth of a turn, with an error below 2^-61 of the rest:
/// no double comes nearer to a multiple of pi/2 than 2^-61 (J.-M. Muller, Elementary Functions, 3rd ed., section 11.3),
/// and the window leaves 137 good bits after the point.
pub(crate) fn reduce(m: u64, e: i32) -> Reduced {
    // The window's first bit has weight 2 in the quotient; bits before it are whole turns.
    let position = (e + 62).max(0) as usize;
    let window = |k: usize| {
        let word = |i: usize| u128::from(TWO_OVER_PI.get(i).copied().unwrap_or(0));
        let pair = word(position / 64 + k) << 64 | word(position / 64 + k + 1);
        (pair >> (64 - position % 64)) as u64
    };
    let product = |k: usize| u128::from(m) * u128::from(window(k));
    // The highest 128 of 192 bits of m * window, modulo 4 turns.
    let quotient = (product(0) << 64).wrapping_add(product(1)).wrapping_add(product(2) >> 64);

    let rest = (quotient << 2) as i128;
    let magnitude = rest.unsigned_abs();
    let zeros = magnitude.leading_zeros();
    let normalised = (magnitude << (zeros & 127) >> 64) as u64;
    let fraction = (u128::from(normalised) * u128::from(PI_OVER_2)) >> 64;
    Reduced {
        quarters: (((quotient >> 125) + 1) >> 1) as usize & 3,
        negative: rest < 0,
        fraction: fraction as u64,
        exponent: 1 - zeros as i32,
    }
}
