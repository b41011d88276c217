//! Numbers as people write them.

use crate::random::Random;

/// Draws the numbers of a case: special ones half of the time, else decimals of few digits.
pub(crate) struct Draw {
    random: Random,
    seed: u64,
    case: u64,
}

impl Draw {
    pub(crate) fn new(seed: u64, case: u64) -> Self {
        Self { random: Random::new(seed, case), seed, case }
    }

    /// The place of this case in a list that cases go through in an order of the seed; none after its last one.
    pub(crate) fn place_in(&self, count: usize) -> Option<usize> {
        let mut random = Random::new(self.seed, 0);
        let mut places: Vec<u32> = (0..count as u32).collect();
        (1..count).rev().for_each(|k| places.swap(k, random.below(k + 1)));
        places.get(self.case as usize).map(|place| *place as usize)
    }

    /// One of the special values half of the time, else between two bounds, with three digits.
    pub(crate) fn number(&mut self, low: f64, high: f64, special: &[f64]) -> f64 {
        if !special.is_empty() && self.random.chance(0.5) {
            return *self.random.one_of(special);
        }
        self.rounded(low, high)
    }

    /// Between two bounds, rounded to a thousandth of their distance.
    pub(crate) fn rounded(&mut self, low: f64, high: f64) -> f64 {
        let digit = 10_f64.powf((high - low).abs().max(f64::MIN_POSITIVE).log10().floor() - 2.0);
        let raw = self.random.between(low, high);
        // A decimal is the quotient by a power of ten, not a product with its rounded inverse.
        if digit < 1.0 {
            (raw / digit).round() / (1.0 / digit).round()
        } else {
            (raw / digit).round() * digit
        }
    }

    /// One of some, which are not none.
    pub(crate) fn one_of<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        self.random.one_of(of)
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.random.below(bound)
    }

    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.random.chance(probability)
    }
}
