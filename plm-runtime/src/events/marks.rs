//! Sets of guards, as bits.

use core::ops::{BitAnd, BitOr, Not};

/// Words of 64 bits. With std there is room for 64 conditions, as many as a decision diagram asks, and for guards of 64 rows of contact; each
/// run has such sets, for which a microcontroller has less room.
const WORDS: usize = if cfg!(feature = "std") { 4 } else { 1 };
/// Most guards of a mechanism.
pub(crate) const MOST_GUARDS: usize = 64 * WORDS;

/// A set of guards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Marks([u64; WORDS]);

impl Marks {
    /// No guard.
    pub(crate) const NONE: Self = Self([0; WORDS]);
    /// All guards.
    pub(crate) const ALL: Self = Self([u64::MAX; WORDS]);

    /// The set of one guard.
    #[inline]
    pub(crate) fn of(index: usize) -> Self {
        let mut marks = Self::NONE;
        marks.put(index);
        marks
    }

    /// The set of these guards.
    #[inline]
    pub(crate) fn of_all(guards: impl Iterator<Item = usize>) -> Self {
        let mut marks = Self::NONE;
        guards.for_each(|index| marks.put(index));
        marks
    }

    /// Puts a guard into the set.
    #[inline]
    pub(crate) fn put(&mut self, index: usize) {
        if let Some(word) = self.0.get_mut(index / 64) {
            *word |= 1 << (index % 64);
        }
    }

    /// Is this guard in the set?
    #[inline]
    pub(crate) fn has(self, index: usize) -> bool {
        self.0.get(index / 64).is_some_and(|word| word & 1 << (index % 64) != 0)
    }

    /// Is no guard in the set?
    #[inline]
    pub(crate) fn is_empty(self) -> bool {
        // Not by comparison of arrays, which is a loop over bytes on a microcontroller.
        self.0.iter().fold(0, |all, word| all | word) == 0
    }

    /// Number of guards in the set.
    #[inline]
    pub(crate) fn count(self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    /// The first 64 guards, one bit each: those that decision diagrams ask are among them.
    #[inline]
    pub(crate) fn first(self) -> u64 {
        self.0[0]
    }

    /// The set of these among the first 64 guards, one bit each.
    pub(crate) fn of_first(bits: u64) -> Self {
        let mut marks = Self::NONE;
        marks.0[0] = bits;
        marks
    }

    /// The words of so many guards.
    pub(crate) fn words_of(&mut self, guards: usize) -> &mut [u64] {
        self.0.get_mut(..guards.div_ceil(64)).unwrap_or_default()
    }
}

impl BitAnd for Marks {
    type Output = Self;
    #[inline]
    fn bitand(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] & other.0[k]))
    }
}

impl BitOr for Marks {
    type Output = Self;
    #[inline]
    fn bitor(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] | other.0[k]))
    }
}

impl Not for Marks {
    type Output = Self;
    #[inline]
    fn not(self) -> Self {
        Self(self.0.map(|word| !word))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_of_guards_are_sets() {
        // There is room for some of them alone without std.
        let all = [0, 1, 63, 64, 127, 128, 192, 255];
        let marks = Marks::of_all(all.into_iter());
        assert_eq!(marks.count() as usize, all.iter().filter(|guard| **guard < MOST_GUARDS).count());
        for index in 0..MOST_GUARDS {
            assert_eq!(marks.has(index), all.contains(&index), "{index}");
            assert_eq!((marks & Marks::of(index)).is_empty(), !all.contains(&index), "{index}");
            assert!((marks | Marks::of(index)).has(index) && !(!Marks::of(index)).has(index));
        }
        assert_eq!(marks.first(), 1 | 2 | 1 << 63);
        assert!(!marks.has(MOST_GUARDS) && Marks::of(MOST_GUARDS).is_empty());
    }
}
