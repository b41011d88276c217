//! What is known of guards as words.

use super::Watch;
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
        words.number(&mut self.since);
        words.count(&mut self.count);
        self.calm.forget();
        self.is_calm = false;
    }
}
