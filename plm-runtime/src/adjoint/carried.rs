//! Adjoints of numbers that an earlier segment has made, by their places.

use crate::scalar::Real;

/// The adjoints of a number, one for each result.
#[derive(Clone, Copy, Debug)]
pub struct Carried<S, const R: usize> {
    place: u64,
    adjoint: [S; R],
}

/// The place of an entry that is not used.
const NONE: u64 = u64::MAX;
/// 2^64 over the golden ratio (D. E. Knuth, The Art of Computer Programming 3, 6.4: multiplicative hashing).
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

impl<S: Real, const R: usize> Carried<S, R> {
    /// An entry that is not used yet.
    pub const EMPTY: Self = Self { place: NONE, adjoint: [S::ZERO; R] };
}

/// A hash table with linear probing in each half of a slice. One is in use; it is emptied into the other one.
pub(super) struct Table<'m, S, const R: usize> {
    halves: [&'m mut [Carried<S, R>]; 2],
}

impl<'m, S: Real, const R: usize> Table<'m, S, R> {
    pub(super) fn new(memory: &'m mut [Carried<S, R>]) -> Self {
        memory.fill(Carried::EMPTY);
        let (one, other) = memory.split_at_mut(memory.len() / 2);
        Self { halves: [one, other] }
    }

    /// The adjoints of the number at a place, zero at first; none where the table is full.
    #[inline]
    pub(super) fn entry(&mut self, place: u64) -> Option<&mut [S; R]> {
        entry(self.halves[0], place)
    }

    /// Entries of both halves.
    pub(super) fn room(&self) -> usize {
        self.halves.iter().map(|half| half.len()).sum()
    }

    /// Gives `each` the numbers from a place on, and keeps the others.
    pub(super) fn take_from(&mut self, first: u64, mut each: impl FnMut(u64, [S; R])) {
        let [own, other] = &mut self.halves;
        for carried in own.iter_mut().filter(|carried| carried.place != NONE) {
            if carried.place >= first {
                each(carried.place, carried.adjoint);
            } else if let Some(kept) = entry(other, carried.place) {
                *kept = carried.adjoint;
            }
            *carried = Carried::EMPTY;
        }
        self.halves.reverse();
    }
}

fn entry<S: Real, const R: usize>(table: &mut [Carried<S, R>], place: u64) -> Option<&mut [S; R]> {
    let length = table.len();
    let hash = place.wrapping_mul(GOLDEN);
    let home = ((u128::from(hash) * length as u128) >> 64) as usize;
    let is_it =
        |slot: &usize| table.get(*slot).is_some_and(|entry| entry.place == place || entry.place == NONE);
    let slot = (home..length).chain(0..home).find(is_it)?;
    let carried = table.get_mut(slot)?;
    carried.place = place;
    Some(&mut carried.adjoint)
}
