//! States that are saved on the way, and those between them.

/// A state between two steps, and the place of its trace.
#[derive(Clone, Copy, Debug)]
pub struct Saved<P> {
    pub(super) state: P,
    pub(super) place: u64,
}

/// Beginnings of segments: of the first one of each block of `stride` segments, in order, then room for the others of one block.
pub(super) struct Slots<'m, P> {
    saved: &'m mut [Option<Saved<P>>],
    stride: usize,
    segments: usize,
}

impl<'m, P: Copy> Slots<'m, P> {
    pub(super) fn new(saved: &'m mut [Option<Saved<P>>]) -> Self {
        Self { saved, stride: 1, segments: 0 }
    }

    pub(super) fn segments(&self) -> usize {
        self.segments
    }

    pub(super) fn blocks(&self) -> usize {
        self.segments.div_ceil(self.stride)
    }

    pub(super) fn segments_of(&self, block: usize) -> usize {
        self.stride.min(self.segments - block * self.stride)
    }

    /// The beginning of the next segment. Where there is no room for it and a block, every second block is joined to the one before.
    pub(super) fn put(&mut self, beginning: Saved<P>) {
        let number = self.segments;
        while number.is_multiple_of(self.stride) && self.blocks() + self.stride > self.saved.len() {
            for block in 0..self.blocks().div_ceil(2) {
                if let Some(kept) = self.saved.get(2 * block).copied() {
                    self.set(block, kept);
                }
            }
            self.stride *= 2;
        }
        if number.is_multiple_of(self.stride) {
            self.set(number / self.stride, Some(beginning));
        }
        self.segments += 1;
    }

    fn set(&mut self, slot: usize, saved: Option<Saved<P>>) {
        if let Some(place) = self.saved.get_mut(slot) {
            *place = saved;
        }
    }

    /// The beginning of a segment of a block.
    pub(super) fn within(&self, block: usize, segment: usize) -> Option<Saved<P>> {
        let slot = if segment == 0 { block } else { self.blocks() + segment - 1 };
        self.saved.get(slot).copied().flatten()
    }

    pub(super) fn put_within(&mut self, segment: usize, beginning: Saved<P>) {
        self.set(self.blocks() + segment - 1, Some(beginning));
    }

    /// So many states have to be saved: the fewest for which a block fits beside the beginnings of all.
    pub(super) fn needed(&self) -> usize {
        let of = |stride: usize| self.segments.div_ceil(stride) + stride - 1;
        let strides = (0..usize::BITS).map(|k| 1_usize << k).take_while(|stride| *stride <= self.segments);
        strides.map(of).min().unwrap_or(1)
    }
}
