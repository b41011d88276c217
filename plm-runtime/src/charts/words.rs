//! Discrete state of the loops as words.

use super::{Angle, Continuation, ContinuationData, Iterated, OfLoops, Reach};
use crate::scalar::Real;
use crate::words::{InWords, Words};

/// The chart and its continuation data, or pose and velocity; the absent ones are zero.
impl<S: Real, C: ContinuationData<S> + InWords, const NQ: usize> InWords for OfLoops<C, [S; NQ]> {
    fn each(&mut self, words: &mut impl Words) {
        let (mut place, mut continuation, mut pose) = (0, C::nothing(), ([S::ZERO; NQ], [S::ZERO; NQ]));
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
