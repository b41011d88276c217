//! From an exact number to the nearest f64.

use super::Number;

/// Unevaluated sum of two floats, the second at most half a unit in the last place of the first.
type Pair = (f64, f64);

/// pi to 107 bits.
const PI: Pair = (core::f64::consts::PI, 1.224_646_799_147_353_2e-16);
/// 1/pi to 107 bits.
const FRAC_1_PI: Pair = (core::f64::consts::FRAC_1_PI, -1.967_867_667_518_248_6e-17);

impl Number {
    /// The nearest f64.
    ///
    /// A rational is rounded once, ties to even. With a power of pi the relative error before the last rounding
    /// is below |exponent| * 2^-100, so that 45*pi/180 gives the same bits as pi/4.
    pub fn to_f64(self) -> f64 {
        match self {
            Self::Float(value) => value,
            Self::Exact { num, den, pi: 0 } => quotient(num, den),
            Self::Exact { num, den, pi } => quotient_times_pi(num, den, pi),
        }
    }
}

fn quotient(num: i128, den: i128) -> f64 {
    const EXACT: u128 = 1 << 53;
    if num.unsigned_abs() <= EXACT && den.unsigned_abs() <= EXACT {
        return num as f64 / den as f64; // both operands are exact, IEEE division rounds once
    }
    let (mantissa, exponent, inexact) = leading_bits(num.unsigned_abs(), den.unsigned_abs(), 64);
    // 64 bits with the rest folded into the last one round as the whole would.
    let magnitude = (mantissa as u64 | u64::from(inexact)) as f64 * power_of_two(exponent);
    if num < 0 { -magnitude } else { magnitude }
}

/// The first `count` significant bits of `num / den` as an integer, with the binary exponent that belongs to it,
/// and whether anything was cut off. `num` is not zero; both are below 2^127.
fn leading_bits(num: u128, den: u128, count: u32) -> (u128, i32, bool) {
    let (mut bits, mut rest) = (num / den, num % den);
    let mut exponent = 0;
    while bits >> (count - 1) == 0 {
        rest <<= 1;
        bits <<= 1;
        if rest >= den {
            rest -= den;
            bits |= 1;
        }
        exponent -= 1;
    }
    let surplus = (128 - bits.leading_zeros()).saturating_sub(count);
    let cut = bits & ((1 << surplus) - 1);
    (bits >> surplus, exponent + surplus as i32, cut != 0 || rest != 0)
}

/// 2^exponent for an exponent of a normal number.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

fn quotient_times_pi(num: i128, den: i128, pi: i8) -> f64 {
    let (mantissa, exponent, _) = leading_bits(num.unsigned_abs(), den.unsigned_abs(), 106);
    let scale = power_of_two(exponent);
    let high = (mantissa >> 53) as f64 * power_of_two(53) * scale;
    let low = (mantissa & ((1 << 53) - 1)) as f64 * scale;
    let mut product = normalised(high, low);
    let factor = if pi > 0 { PI } else { FRAC_1_PI };
    for _ in 0..pi.unsigned_abs() {
        product = multiply(product, factor);
    }
    let magnitude = product.0 + product.1;
    if num < 0 { -magnitude } else { magnitude }
}

/// T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971),
/// 224-242: fast two-sum for |high| >= |low|.
fn normalised(high: f64, low: f64) -> Pair {
    let sum = high + low;
    (sum, low - (sum - high))
}

/// Product of two pairs (Dekker, "mul2").
fn multiply(a: Pair, b: Pair) -> Pair {
    let (high, low) = exact_product(a.0, b.0);
    normalised(high, low + (a.0 * b.1 + a.1 * b.0))
}

/// The rounded product and its error, by splitting each factor in two halves of 26 bits (Dekker, "mul12").
fn exact_product(a: f64, b: f64) -> Pair {
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

fn halves(value: f64) -> Pair {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = SPLITTER * value;
    let high = scaled - (scaled - value);
    (high, value - high)
}
