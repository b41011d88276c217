//! A run as 64-bit words, for files and for other processes.
//!
//! One function visits every word, in one order, for writing, reading and counting: so a run is read in the order in which it was written,
//! and its number of words is always the same. A number is the word of its bits.

use crate::scalar::Real;
use crate::vector::Vector;

/// Writes words, or reads them.
pub trait Words {
    /// Takes this word, or gives it its value.
    fn word(&mut self, word: &mut u64);

    /// A number, `f64` or one that rounds to that and back as it is.
    fn number<S: Real>(&mut self, number: &mut S) {
        let mut bits = number.to_f64().to_bits();
        self.word(&mut bits);
        *number = S::lit(f64::from_bits(bits));
    }

    /// Several numbers.
    fn numbers<'a, S: Real + 'a>(&mut self, numbers: impl IntoIterator<Item = &'a mut S>) {
        numbers.into_iter().for_each(|number| self.number(number));
    }

    /// Yes or no.
    fn flag(&mut self, flag: &mut bool) {
        let mut word = u64::from(*flag);
        self.word(&mut word);
        *flag = word != 0;
    }

    /// A count.
    fn count(&mut self, count: &mut u32) {
        let mut word = u64::from(*count);
        self.word(&mut word);
        *count = word as u32;
    }

    /// A number of things.
    fn index(&mut self, index: &mut usize) {
        let mut word = *index as u64;
        self.word(&mut word);
        *index = word as usize;
    }

    /// The components of a vector.
    fn vector<S: Real, X: Vector<S>>(&mut self, vector: &mut X) {
        for index in 0..X::LEN {
            let mut number = vector.at(index);
            self.number(&mut number);
            vector.set(index, number);
        }
    }

    /// A value that may be absent; `blank` takes its place in the order then.
    fn perhaps<T: Copy>(&mut self, value: &mut Option<T>, blank: T, each: impl FnOnce(&mut Self, &mut T)) {
        let (mut is_there, mut inner) = (value.is_some(), value.unwrap_or(blank));
        self.flag(&mut is_there);
        each(self, &mut inner);
        *value = is_there.then_some(inner);
    }
}

/// Types that can be shown as words, always as many.
pub trait InWords {
    /// Shows every word, in order.
    fn each(&mut self, words: &mut impl Words);
}

impl InWords for () {
    fn each(&mut self, _words: &mut impl Words) {}
}
