//! Lengths whose sums are known exactly: whole numbers of a unit.

use crate::random::Random;
use crate::reference::dd::Dd;

/// Unit of lengths: each is a whole multiple of it.
#[derive(Clone, Copy, Debug)]
pub enum Ruler {
    /// 1/256 m, those that are drawn of 1/64 m: numbers of `f64` and their sums are exact.
    Dyadic,
    /// Decimals of so many digits, as people write them: `f64` has them but for rounding.
    Decimal(i32),
}

impl Ruler {
    /// One to four digits.
    pub fn decimal(random: &mut Random) -> Self {
        Self::Decimal(1 + random.below(4) as i32)
    }

    fn per_metre(self) -> f64 {
        match self {
            Self::Dyadic => 256.0,
            Self::Decimal(digits) => 10_f64.powi(digits),
        }
    }

    /// So many metres, in units.
    pub fn units(self, metres: f64) -> f64 {
        metres * self.per_metre()
    }

    /// A length, in units.
    pub fn draw(self, random: &mut Random, low: f64, high: f64) -> f64 {
        let metres = random.between(low, high);
        match self {
            Self::Dyadic => (metres * 64.0).round() * 4.0,
            Self::Decimal(_) => (metres * self.per_metre()).round(),
        }
    }

    /// A part of a length, in units.
    pub fn part(random: &mut Random, units: f64, low: f64, high: f64) -> f64 {
        (units * random.between(low, high)).round()
    }

    /// So many units, m: rounded, and what is left of it.
    pub fn metres(self, units: f64) -> [f64; 2] {
        let rounded = units / self.per_metre();
        let rest = Dd::from(units) / Dd::from(self.per_metre()) - Dd::from(rounded);
        [rounded, rest.hi]
    }
}
