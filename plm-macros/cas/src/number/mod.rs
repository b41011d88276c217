//! Exact numbers: a rational times an integer power of pi, in checked 128-bit integers.
//!
//! Numbers of a drawing (9.80665, 45 deg, 1/3) stay exact through sums, products and derivatives, so that terms
//! cancel when they should. A result that has no such form (1 + pi, sin 1, or more than 128 bits) is a `Float`.

mod decimal;
mod round;

use core::cmp::Ordering;
use core::hash::{Hash, Hasher};
use core::ops::{Add, Mul, Neg, Sub};

use crate::hash::Mixer;

/// A constant of the algebra.
///
/// Canonical by construction: `Exact` is reduced with a positive denominator, zero carries no power of pi, and
/// a float that is an integer below 2^53 is `Exact`. Make numbers by the constructors, not by the variants.
#[derive(Clone, Copy, Debug)]
pub enum Number {
    /// `num / den * pi^pi`.
    Exact {
        /// Numerator, carries the sign.
        num: i128,
        /// Denominator, positive and prime to the numerator.
        den: i128,
        /// Exponent of pi; 0 if the number is zero.
        pi: i8,
    },
    /// A rounded number; never zero. It may be infinite or NaN, which only arithmetic on such input produces.
    Float(f64),
}

impl Number {
    /// 0.
    pub const ZERO: Self = Self::Exact { num: 0, den: 1, pi: 0 };
    /// 1.
    pub const ONE: Self = Self::Exact { num: 1, den: 1, pi: 0 };
    /// -1.
    pub const MINUS_ONE: Self = Self::Exact { num: -1, den: 1, pi: 0 };

    /// The integer `value`.
    pub const fn from_int(value: i64) -> Self {
        Self::Exact { num: value as i128, den: 1, pi: 0 }
    }

    /// The number nearest to what a rounded computation gave: exact if it is an integer below 2^53.
    ///
    /// The sign of a zero is dropped: the algebra knows one zero.
    pub fn from_f64(value: f64) -> Self {
        const EXACT_BELOW: f64 = 9_007_199_254_740_992.0; // 2^53
        if value.abs() < EXACT_BELOW && value == (value as i64) as f64 {
            Self::from_int(value as i64)
        } else if value.is_nan() {
            Self::Float(f64::NAN)
        } else {
            Self::Float(value)
        }
    }

    /// `num / den`, reduced. `None` if `den` is zero or the reduced parts leave 127 bits.
    pub fn rational(num: i128, den: i128) -> Option<Self> {
        reduced(num, den, 0)
    }

    /// The number pi itself, exact.
    pub const fn pi() -> Self {
        Self::Exact { num: 1, den: 1, pi: 1 }
    }

    /// Is it 0?
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Exact { num: 0, .. })
    }

    /// Is it exactly 1?
    pub const fn is_one(self) -> bool {
        matches!(self, Self::Exact { num: 1, den: 1, pi: 0 })
    }

    /// Is it exactly -1?
    pub const fn is_minus_one(self) -> bool {
        matches!(self, Self::Exact { num: -1, den: 1, pi: 0 })
    }

    /// Is it below 0?
    pub fn is_negative(self) -> bool {
        match self {
            Self::Exact { num, .. } => num < 0,
            Self::Float(value) => value < 0.0,
        }
    }

    /// Is it neither infinite nor NaN?
    pub const fn is_finite(self) -> bool {
        match self {
            Self::Exact { .. } => true,
            Self::Float(value) => value.is_finite(),
        }
    }

    /// The integer that it is, if it is one that fits.
    pub fn as_int(self) -> Option<i64> {
        match self {
            Self::Exact { num, den: 1, pi: 0 } => i64::try_from(num).ok(),
            _ => None,
        }
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    /// `self / other`, or `None` if `other` is zero.
    #[allow(clippy::should_implement_trait)] // the operator could not say that there is no value
    pub fn div(self, other: Self) -> Option<Self> {
        if other.is_one() {
            return Some(self);
        }
        let inverse = other.recip()?;
        // The smallest numbers have no reciprocal.
        let has_digits = matches!(inverse, Self::Exact { .. }) || inverse.to_f64().is_normal();
        Some(if has_digits { self * inverse } else { Self::from_f64(self.to_f64() / other.to_f64()) })
    }

    /// `1 / self`, or `None` for zero.
    pub fn recip(self) -> Option<Self> {
        match self {
            Self::Exact { num: 0, .. } => None,
            Self::Exact { num, den, pi } => {
                // Negation cannot overflow: no part is ever i128::MIN.
                let sign = num.signum();
                Some(match pi.checked_neg() {
                    Some(pi) => Self::Exact { num: den * sign, den: num * sign, pi },
                    None => Self::from_f64(1.0 / self.to_f64()),
                })
            }
            Self::Float(value) => Some(Self::from_f64(1.0 / value)),
        }
    }

    /// `self^exponent` by repeated squaring; `None` for a negative power of zero.
    pub fn powi(self, exponent: i32) -> Option<Self> {
        let mut base = if exponent < 0 { self.recip()? } else { self };
        let mut left = exponent.unsigned_abs();
        let mut power = Self::ONE;
        while left > 0 {
            if left & 1 == 1 {
                power = power * base;
            }
            left >>= 1;
            if left > 0 {
                base = base * base;
            }
        }
        Some(power)
    }

    /// The exact square root, if the number is the square of a rational times a power of pi.
    pub fn exact_sqrt(self) -> Option<Self> {
        match self {
            Self::Exact { num, den, pi } if num >= 0 && pi % 2 == 0 => {
                Some(Self::Exact { num: integer_sqrt(num)?, den: integer_sqrt(den)?, pi: pi / 2 })
            }
            _ => None,
        }
    }

    /// Feeds the bits to a hash.
    pub(crate) fn mix(self, mixer: &mut Mixer) {
        match self {
            Self::Exact { num, den, pi } => {
                mixer.word(num as u64);
                let high = (num >> 64) as u64;
                if high != 0 && high != u64::MAX {
                    mixer.word(high);
                }
                mixer.word((den as u64) ^ ((pi as u64) << 56));
            }
            Self::Float(value) => mixer.word(!value.to_bits()),
        }
    }
}

/// `num / den * pi^pi` in lowest terms.
fn reduced(num: i128, den: i128, pi: i8) -> Option<Number> {
    if den == 1 && num != i128::MIN {
        return Some(Number::Exact { num, den, pi: if num == 0 { 0 } else { pi } });
    }
    if den == 0 || num == i128::MIN || den == i128::MIN {
        return None;
    }
    if num == 0 {
        return Some(Number::ZERO);
    }
    let divisor = gcd(num, den) * den.signum();
    Some(Number::Exact { num: num / divisor, den: den / divisor, pi })
}

/// Greatest common divisor, positive; not both zero. Small operands take the short division.
pub(crate) fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b > u128::from(u64::MAX) || a > u128::from(u64::MAX) {
        if b == 0 {
            return a as i128;
        }
        (a, b) = (b, a % b);
    }
    let (mut a, mut b) = (a as u64, b as u64);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    i128::from(a)
}

/// The root of a perfect square.
fn integer_sqrt(square: i128) -> Option<i128> {
    let root = square.isqrt();
    (root * root == square).then_some(root)
}

fn exact_add(a: (i128, i128), b: (i128, i128), pi: i8) -> Option<Number> {
    if a.1 == b.1 {
        return reduced(a.0.checked_add(b.0)?, a.1, pi);
    }
    let common = gcd(a.1, b.1);
    let left = a.0.checked_mul(b.1 / common)?;
    let right = b.0.checked_mul(a.1 / common)?;
    reduced(left.checked_add(right)?, a.1.checked_mul(b.1 / common)?, pi)
}

/// Crosswise reduction first, so that nothing overflows unless the result does.
fn exact_mul(a: (i128, i128), b: (i128, i128), pi: i8) -> Option<Number> {
    if a.1 == 1 && b.1 == 1 {
        return reduced(a.0.checked_mul(b.0)?, 1, pi);
    }
    let (left, right) = (gcd(a.0, b.1), gcd(b.0, a.1));
    let num = (a.0 / left).checked_mul(b.0 / right)?;
    let den = (a.1 / right).checked_mul(b.1 / left)?;
    (num != i128::MIN).then_some(Number::Exact { num, den, pi })
}

impl Add for Number {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        if let (Self::Exact { num: a, den: b, pi }, Self::Exact { num: c, den: d, pi: other_pi }) =
            (self, other)
            && pi == other_pi
            && let Some(sum) = exact_add((a, b), (c, d), pi)
        {
            return sum;
        }
        Self::from_f64(self.to_f64() + other.to_f64())
    }
}

impl Sub for Number {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Number {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.is_one() {
            return other;
        }
        if other.is_one() {
            return self;
        }
        if let (Self::Exact { num: a, den: b, pi: p }, Self::Exact { num: c, den: d, pi: q }) = (self, other)
        {
            if a == 0 || c == 0 {
                return Self::ZERO;
            }
            if let Some(product) = p.checked_add(q).and_then(|pi| exact_mul((a, b), (c, d), pi)) {
                return product;
            }
        }
        Self::from_f64(self.to_f64() * other.to_f64())
    }
}

impl Neg for Number {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            Self::Exact { num, den, pi } => Self::Exact { num: -num, den, pi },
            Self::Float(value) => Self::from_f64(-value),
        }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        match (*self, *other) {
            (Self::Exact { num: a, den: b, pi: p }, Self::Exact { num: c, den: d, pi: q }) => {
                a == c && b == d && p == q
            }
            (Self::Float(a), Self::Float(b)) => a.to_bits() == b.to_bits(),
            _ => false,
        }
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        let mut mixer = Mixer::new(0);
        self.mix(&mut mixer);
        state.write_u32(mixer.finish());
    }
}

/// By value (as rounded to f64), then exactly, then by form: total, and equal only for equal bits.
impl Ord for Number {
    fn cmp(&self, other: &Self) -> Ordering {
        self.to_f64().total_cmp(&other.to_f64()).then_with(|| match (*self, *other) {
            (Self::Exact { num: a, den: b, pi: p }, Self::Exact { num: c, den: d, pi: q }) => {
                p.cmp(&q).then_with(|| compare_fractions((a, b), (c, d)))
            }
            (Self::Exact { .. }, Self::Float(_)) => Ordering::Less,
            (Self::Float(_), Self::Exact { .. }) => Ordering::Greater,
            (Self::Float(_), Self::Float(_)) => Ordering::Equal,
        })
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Compares two fractions with positive denominators by their continued fractions, which cannot overflow.
fn compare_fractions(mut a: (i128, i128), mut b: (i128, i128)) -> Ordering {
    loop {
        let (p, q) = (a.0.div_euclid(a.1), b.0.div_euclid(b.1));
        if p != q {
            return p.cmp(&q);
        }
        match (a.0.rem_euclid(a.1), b.0.rem_euclid(b.1)) {
            (0, 0) => return Ordering::Equal,
            (0, _) => return Ordering::Less,
            (_, 0) => return Ordering::Greater,
            // a = p + r/d and b = p + s/e: r/d < s/e exactly if e/s < d/r.
            (r, s) => (a, b) = ((b.1, s), (a.1, r)),
        }
    }
}
