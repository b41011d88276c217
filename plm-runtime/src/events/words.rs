//! Data of the detector as words.

use super::chattering::Chattering;
use super::marks::Marks;
use super::{Detector, Modes};
use crate::scalar::Real;
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Guards whose marks have room in the word of a count.
const BESIDE: usize = 56;

/// Words of the detector. Conditions missed in the last step, which only methods without dense output have, are left out; so
/// is the guard-free region, which is found again and changes no number.
impl<S: Real, G: Vector<S>> InWords for Detector<S, G> {
    fn each(&mut self, words: &mut impl Words) {
        words.vector(&mut self.residual);
        let mut modes = match self.modes {
            Modes::New => 0,
            Modes::Decided => 1,
            Modes::Unknown => 2,
            Modes::Known => 3,
        } + if self.has_passed { 4 } else { 0 };
        words.word(&mut modes);
        self.has_passed = modes >= 4;
        self.modes = match modes % 4 {
            0 => Modes::New,
            1 => Modes::Decided,
            2 => Modes::Unknown,
            _ => Modes::Known,
        };
        let Chattering { since, count, conditions, has_thrown } = &mut self.chattering;
        words.number(since);
        // The count is at most 101 or a little more; few guards stand beside it.
        let mut all = u64::from(*count).min(0x7F) | u64::from(*has_thrown) << 7 | conditions.first() << 8;
        words.word(&mut all);
        (*count, *has_thrown) = ((all & 0x7F) as u32, all & 0x80 != 0);
        if G::LEN <= BESIDE {
            *conditions = Marks::of_first(all >> 8);
        } else {
            conditions.words_of(G::LEN).iter_mut().for_each(|word| words.word(word));
        }
        self.guard_free.forget();
    }
}
