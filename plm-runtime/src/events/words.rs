//! What is known of guards as words.

use super::Watch;
use super::burst::Burst;
use crate::scalar::Real;
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Not what came and went within the last step, which methods without dense output alone have; nor where guards need no look,
/// which is found again and changes no number.
impl<S: Real, G: Vector<S>> InWords for Watch<S, G> {
    fn each(&mut self, words: &mut impl Words) {
        words.flag(&mut self.known);
        words.vector(&mut self.left_over);
        words.flag(&mut self.is_new);
        let Burst { since, count, conditions } = &mut self.burst;
        words.number(since);
        // The count is 101 at most.
        let mut both = u64::from(*count).min(0xFF) | *conditions << 8;
        words.word(&mut both);
        (*count, *conditions) = ((both & 0xFF) as u32, both >> 8);
        self.calm.forget();
    }
}
