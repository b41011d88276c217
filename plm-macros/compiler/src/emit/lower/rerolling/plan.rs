//! Plan of the loops, and where their operands are found.

use crate::collect::{CollectVec, PushAll};
use crate::formulate::Place;
use crate::sorted::{SortedMap, SortedSet};

use super::items::{Items, Source};
use super::regions::{LEAST, Region, regions, step};

/// Repetitions from which on a value may be carried.
const DEEPEST: usize = 4;

/// An operand of a pattern, in all repetitions.
#[derive(Clone)]
pub(super) enum Role {
    /// One leaf, or one value from before the loop, in all repetitions.
    Same(Source),
    /// A constant for each repetition.
    Constants(Vec<f64>),
    /// A symbol by itself or a value from before for each repetition.
    Gathered(Vec<Source>),
    /// An element of an array that exists anyway.
    Element { array: usize, index: usize, step: isize },
    /// The value of an item of the pattern, in this repetition.
    Inner(usize),
    /// An item of the loop, so many repetitions ago.
    Carried(usize, usize),
    /// The value of an item of the pattern of a loop before.
    Kept { of: Slot, first: isize, step: isize },
}

/// An item of the pattern of a loop.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Slot {
    pub(super) region: usize,
    pub(super) offset: usize,
}

/// A loop: the roles of the operands of its pattern, in order.
pub(super) struct Loop {
    pub(super) region: Region,
    pub(super) roles: Vec<Role>,
}

/// The loops of a function.
#[derive(Default)]
pub(super) struct Plan {
    pub(super) loops: Vec<Loop>,
    /// Values that go from a loop to what is not in it: the repetitions of which they are kept, first and last. Those
    /// outside its count are of items like those of the pattern, before it and after it.
    pub(super) kept: SortedMap<Slot, (isize, isize)>,
    /// Items outside the loops that are read in one.
    pub(super) read: SortedSet<usize>,
    /// For each item the loop that it is in.
    inside: Vec<Option<usize>>,
}

impl Plan {
    pub(super) fn of(items: &Items) -> Plan {
        let mut plan = Plan { inside: vec![None; items.all.len()], ..Plan::default() };
        for region in regions(items) {
            plan.add(items, region);
        }
        plan.keep_all(items);
        plan
    }

    /// Makes a loop of a region, without its first repetitions where these differ after all.
    fn add(&mut self, items: &Items, mut region: Region) {
        while region.count >= LEAST {
            let first = items.all[region.start].sources.start;
            let last = items.all[region.start + region.period - 1].sources.end;
            let width = last - first;
            let mut roles = Vec::with_capacity(width);
            for slot in first..last {
                let column = (0..region.count).map(|k| items.sources[slot + k * width]).collect_vec();
                roles.push_all(self.role(items, &region, &column));
            }
            if roles.len() == width {
                self.inside[region.start..region.end()].fill(Some(self.loops.len()));
                self.loops.push(Loop { region, roles });
                return;
            }
            region = Region { start: region.start + region.period, count: region.count - 1, ..region };
        }
    }

    /// Role of an operand in all repetitions, if it follows a rule.
    fn role(&self, items: &Items, region: &Region, column: &[Source]) -> Option<Role> {
        let by = step(column[0], column[1])?;
        if column.windows(2).any(|two| step(two[0], two[1]) != Some(by)) {
            return None;
        }
        Some(match column[0] {
            Source::Number(first) => {
                let numbers = column.iter().filter_map(|source| match source {
                    Source::Number(value) => Some(*value),
                    _ => None,
                });
                let numbers = numbers.collect_vec();
                let is_same = numbers.iter().all(|number| number.to_bits() == first.to_bits());
                if is_same { Role::Same(column[0]) } else { Role::Constants(numbers) }
            }
            Source::Symbol(first) => {
                let is_same = |source: &Source| matches!(source, Source::Symbol(other) if *other == first);
                if column.iter().all(is_same) {
                    Role::Same(column[0])
                } else {
                    Role::Gathered(column.to_vec())
                }
            }
            Source::Element { .. } if by == 0 => Role::Same(column[0]),
            Source::Element { array, index } => Role::Element { array, index, step: by },
            Source::Item(first) if by.cast_unsigned() == region.period => {
                in_step(region, first).or_else(|| self.along(items, region, (first, by), column))?
            }
            Source::Item(first) if by == 0 => (first < region.start).then_some(Role::Same(column[0]))?,
            Source::Item(first) => self.along(items, region, (first, by), column)?,
        })
    }

    /// Values from before the loop, a step apart: from an array, or gathered in one.
    fn along(
        &self,
        items: &Items,
        region: &Region,
        (first, by): (usize, isize),
        column: &[Source],
    ) -> Option<Role> {
        let last = first.checked_add_signed(by * (region.count - 1).cast_signed())?;
        if first.max(last) >= region.start {
            return None;
        }
        let kept = || {
            let from = self.inside[usize::midpoint(first, last)]?;
            let Region { start, period, count } = self.loops[from].region;
            let offset = (first.wrapping_sub(start)).cast_signed().rem_euclid(period.cast_signed());
            let repetition =
                |at: usize| (at.cast_signed() - start.cast_signed() - offset) / period.cast_signed();
            let is_outside = |at: usize| {
                (repetition(at) < 0 || repetition(at) >= count.cast_signed()) && self.inside[at].is_none()
            };
            let fits = column.iter().all(|source| match *source {
                Source::Item(at) => self.inside[at] == Some(from) || is_outside(at),
                _ => false,
            });
            let of = Slot { region: from, offset: offset.cast_unsigned() };
            let whole = by % period.cast_signed() == 0 && items.all[start + of.offset].stores.is_none();
            (whole && fits).then(|| Role::Kept {
                of,
                first: repetition(first),
                step: by / period.cast_signed(),
            })
        };
        Some(kept().unwrap_or_else(|| Role::Gathered(column.to_vec())))
    }

    /// Keeps all values that are read elsewhere than in their own loops.
    fn keep_all(&mut self, items: &Items) {
        let loops = std::mem::take(&mut self.loops);
        for Loop { region, roles } in &loops {
            for role in roles {
                match role {
                    Role::Same(source) => self.keep(&loops, *source),
                    Role::Gathered(all) => all.iter().for_each(|source| self.keep(&loops, *source)),
                    Role::Carried(offset, depth) => {
                        for back in 1..=*depth {
                            self.keep(&loops, Source::Item(region.start + offset - back * region.period));
                        }
                    }
                    Role::Kept { of, first, step } => {
                        let last = first + step * (region.count - 1).cast_signed();
                        self.keep_range(&loops, *of, (*first.min(&last), *first.max(&last)));
                    }
                    Role::Constants(_) | Role::Element { .. } | Role::Inner(_) => {}
                }
            }
        }
        for (at, item) in items.all.iter().enumerate() {
            if self.inside[at].is_none() {
                items.sources[item.sources.clone()]
                    .iter()
                    .for_each(|source| self.keep_inside(&loops, *source));
            }
        }
        for (&result, (place, _)) in items.results.iter().zip(&items.function.results) {
            if let (Some(item), Place::Value) = (items.item_of[result], place) {
                self.keep_inside(&loops, Source::Item(item));
            }
        }
        // Of what is read in the last repetition alone one value is kept, of all else all.
        for (of, range) in self.kept.iter_mut() {
            let last = loops[of.region].region.count.cast_signed() - 1;
            if range.0 != last {
                *range = (range.0.min(0), range.1.max(last));
            }
        }
        self.loops = loops;
    }

    fn keep(&mut self, loops: &[Loop], source: Source) {
        self.keep_inside(loops, source);
        if let Source::Item(at) = source
            && self.inside[at].is_none()
        {
            self.read.insert(at);
        }
    }

    fn keep_inside(&mut self, loops: &[Loop], source: Source) {
        if let Source::Item(at) = source
            && let Some(region) = self.inside[at]
        {
            let Region { start, period, .. } = loops[region].region;
            let repetition = ((at - start) / period).cast_signed();
            self.keep_range(loops, Slot { region, offset: (at - start) % period }, (repetition, repetition));
        }
    }

    fn keep_range(&mut self, loops: &[Loop], of: Slot, (low, high): (isize, isize)) {
        let Region { start, period, count } = loops[of.region].region;
        let range = self.kept.or_insert(of, (low, high));
        *range = (range.0.min(low), range.1.max(high));
        let outside = (low..0).chain(count.cast_signed().max(low)..=high);
        for repetition in outside {
            self.read.insert((start + of.offset).wrapping_add_signed(repetition * period.cast_signed()));
        }
    }

    /// The loop that an item is in.
    pub(super) fn inside(&self, item: usize) -> Option<usize> {
        self.inside[item]
    }

    /// Place of an item's value: the slot and the index in its array.
    pub(super) fn place(&self, item: usize) -> Option<(Slot, usize)> {
        let region = self.inside[item]?;
        let Region { start, period, .. } = self.loops[region].region;
        let of = Slot { region, offset: (item - start) % period };
        let low = self.kept.get(&of)?.0;
        let place = ((item - start) / period).cast_signed() - low;
        Some((of, usize::try_from(place).ok()?))
    }

    /// Items outside loops that stand in arrays of values like theirs, with their places in these.
    pub(super) fn entered(&self, items: &Items) -> Vec<(usize, Slot, usize)> {
        let mut all = Vec::new();
        for (&of, &(low, high)) in &self.kept {
            let Region { start, period, count } = self.loops[of.region].region;
            for repetition in (low..0).chain(count.cast_signed().max(low)..=high) {
                let item = (start + of.offset).wrapping_add_signed(repetition * period.cast_signed());
                if self.inside[item].is_none() && items.all[item].stores.is_none() {
                    all.push((item, of, (repetition - low).cast_unsigned()));
                }
            }
        }
        all
    }
}

/// An item that moves on with the pattern: in this repetition or in one before.
fn in_step(region: &Region, first: usize) -> Option<Role> {
    if first >= region.start {
        return Some(Role::Inner(first - region.start));
    }
    let depth = (region.start - first).div_ceil(region.period);
    (depth <= DEEPEST).then(|| Role::Carried(first + depth * region.period - region.start, depth))
}
