//! A run as words of 64 bits, for files and for other processes.
//!
//! One function shows every word, in one order, to whoever writes, reads or counts them: so what is read is what was
//! written, and always as many. A number is the word of its bits.

use crate::charts::{Angle, Continuation, ContinuationData, Iterated, OfLoops, Reach};
use crate::described::Described;
use crate::held::Held;
use crate::scalar::Real;
use crate::start::StartValues;
use crate::statics::Statics;
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
    fn numbers<'a, S: Real>(&mut self, numbers: impl IntoIterator<Item = &'a mut S>) {
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

    /// What may not be there; `blank` takes its place in the order then.
    fn perhaps<T: Copy>(&mut self, value: &mut Option<T>, blank: T, each: impl FnOnce(&mut Self, &mut T)) {
        let (mut is_there, mut inner) = (value.is_some(), value.unwrap_or(blank));
        self.flag(&mut is_there);
        each(self, &mut inner);
        *value = is_there.then_some(inner);
    }
}

/// What can be shown in words, always as many.
pub trait InWords {
    /// Shows every word, in order.
    fn each(&mut self, words: &mut impl Words);
}

impl InWords for () {
    fn each(&mut self, _words: &mut impl Words) {}
}

/// Shows the parameters of a mechanism and its start values with their locks.
pub fn mechanism<M: Described + Statics>(mechanism: &mut M, words: &mut impl Words) {
    for index in 0..M::TABLES.parameters.len() {
        if let Some(parameter) = mechanism.parameter_mut(index) {
            words.number(parameter);
        }
    }
    mechanism.starts_mut().each(&mut |_, start| {
        words.number(&mut start.value);
        words.flag(&mut start.locked);
    });
}

/// Switches, turns, loops. The inputs have a type of the mechanism's own: they are shown by [`Ports`](crate::Ports).
impl<S: Real, I, const W: usize, const T: usize, L: InWords> InWords for Held<I, [S; W], [i32; T], L> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers(&mut self.switches);
        for turns in &mut self.turns {
            let mut number = f64::from(*turns);
            words.number(&mut number);
            *turns = number as i32;
        }
        self.of_loops.each(words);
    }
}

/// The chart, and what is remembered in it; or pose and velocity. What is not held is zero.
impl<S: Real, const Y: usize, const T: usize, const A: usize, const F: usize, const NQ: usize> InWords
    for OfLoops<Continuation<S, Y, T, A, F>, [S; NQ]>
{
    fn each(&mut self, words: &mut impl Words) {
        let (mut place, mut continuation, mut pose) =
            (0, Continuation::nothing(), ([S::ZERO; NQ], [S::ZERO; NQ]));
        match *self {
            OfLoops::InChart { chart, continuation: held } => {
                (place, continuation) = (chart as u64 + 1, held);
            }
            OfLoops::Free { q, v } => pose = (q, v),
        }
        words.word(&mut place);
        continuation.each(words);
        words.numbers(&mut pose.0);
        words.numbers(&mut pose.1);
        *self = match place.checked_sub(1) {
            Some(chart) => OfLoops::InChart { chart: chart as usize, continuation },
            None => OfLoops::Free { q: pose.0, v: pose.1 },
        };
    }
}

impl<S: Real, const Y: usize, const T: usize, const A: usize, const F: usize> InWords
    for Continuation<S, Y, T, A, F>
{
    fn each(&mut self, words: &mut impl Words) {
        for Reach { last, reach } in self.coordinates.iter_mut().chain([&mut self.time]) {
            words.numbers([last, reach]);
        }
        for Angle { angle, cos, sin } in &mut self.angles {
            words.numbers([angle, cos, sin]);
        }
        words.numbers(&mut self.determinants);
        for Iterated { value, rate, bend } in &mut self.iterated {
            words.numbers([value, rate, bend]);
        }
    }
}
