//! Hash tables for look-up only: small, the same on every host, quick without optimisation.
//!
//! A table holds positions of entries that live elsewhere (in the arena, in a list of pairs), by open addressing
//! with linear probing. Nothing can iterate over it, so its order reaches no output.

/// Mixes words into a hash: rotate, xor, multiply, the scheme of rustc's own tables ("FxHash").
pub(crate) struct Mixer(u64);

impl Mixer {
    pub(crate) fn new(tag: u64) -> Self {
        Self(tag)
    }

    #[inline]
    pub(crate) fn word(&mut self, word: u64) {
        const FACTOR: u64 = 0x517c_c1b7_2722_0a95;
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(FACTOR);
    }

    /// The upper half, where a multiplication mixes best.
    pub(crate) fn finish(&self) -> u32 {
        (self.0 >> 32) as u32
    }
}

/// Positions of entries `0..len` of some list, found by hash.
pub(crate) struct Table {
    /// Position + 1, or 0 for a free slot; the length is a power of two.
    slots: Vec<u32>,
    /// The hash of each entry, by position.
    hashes: Vec<u32>,
}

impl Table {
    pub(crate) fn new() -> Self {
        Self { slots: vec![0; 64], hashes: Vec::new() }
    }

    /// The position of the entry with this hash for which `same` holds.
    pub(crate) fn find(&self, hash: u32, same: impl Fn(usize) -> bool) -> Option<usize> {
        let mask = self.slots.len() - 1;
        let mut slot = hash as usize & mask;
        loop {
            let position = match self.slots[slot] {
                0 => return None,
                next => next as usize - 1,
            };
            if self.hashes[position] == hash && same(position) {
                return Some(position);
            }
            slot = (slot + 1) & mask;
        }
    }

    /// Enters the next position; the caller appends the entry to its list.
    pub(crate) fn push(&mut self, hash: u32) {
        self.hashes.push(hash);
        if self.hashes.len() * 2 > self.slots.len() {
            self.grow();
        } else {
            self.enter(self.hashes.len() - 1);
        }
    }

    fn grow(&mut self) {
        self.slots = vec![0; self.slots.len() * 4];
        for position in 0..self.hashes.len() {
            self.enter(position);
        }
    }

    fn enter(&mut self, position: usize) {
        let mask = self.slots.len() - 1;
        let mut slot = self.hashes[position] as usize & mask;
        while self.slots[slot] != 0 {
            slot = (slot + 1) & mask;
        }
        self.slots[slot] = position as u32 + 1;
    }
}
