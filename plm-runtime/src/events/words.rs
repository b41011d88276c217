//! What is known of guards as words.

use super::Watch;
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Not what came and went within the last step, which methods without dense output alone have.
impl<G: Vector<f64>> InWords for Watch<f64, G> {
    fn each(&mut self, words: &mut impl Words) {
        words.perhaps(&mut self.guards, G::fill(0.0), Words::vector);
        words.vector(&mut self.left_over);
        words.flag(&mut self.is_new);
        words.number(&mut self.since);
        let mut count = u64::from(self.count);
        words.word(&mut count);
        self.count = count as u32;
    }
}
