//! Regions of a row of items: periodic repetitions, which become loops.
//!
//! Items repeat with a period if those a period apart have the same shape, and if each of their operands moves on by the same
//! step from one repetition to the next: by a period, by nothing, along an array. Which constant it is may change.

use crate::collect::{CollectVec, MapEach, PushAll};
use crate::sorted::SortedMap;

use super::items::{Items, Source};

/// Repetitions that make a loop.
pub(super) const LEAST: usize = 8;
/// Items of the longest pattern.
const LONGEST: usize = 1000;
/// How many items are looked at together to find where a pattern may begin again.
const WINDOW: usize = 4;
/// How many such places are tried.
const TRIES: usize = 12;

/// `count` repetitions of `period` items, from `start` on.
#[derive(Clone, Copy)]
pub(super) struct Region {
    pub(super) start: usize,
    pub(super) period: usize,
    pub(super) count: usize,
}

impl Region {
    pub(super) fn end(&self) -> usize {
        self.start + self.period * self.count
    }
}

/// Regions from the beginning on, each the longest that begins where it does.
pub(super) fn regions(items: &Items) -> Vec<Region> {
    let mut regions = Vec::new();
    let next = next_alike(items);
    let mut start = 0;
    while start < items.all.len() {
        let region = longest(items, &next, start);
        start = region.map_or(start + 1, |region| region.end());
        regions.push_all(region);
    }
    regions
}

/// For each item the next that, with those after it, has the same shapes.
fn next_alike(items: &Items) -> Vec<Option<usize>> {
    let shapes = items.all.iter().map(|item| item.shape).collect_vec();
    let mut windows: SortedMap<&[usize], usize> = SortedMap::new();
    let mut next = vec![None; shapes.len()];
    for (start, window) in shapes.windows(WINDOW).enumerate().rev() {
        next[start] = windows.insert(window, start);
    }
    next
}

fn longest(items: &Items, next: &[Option<usize>], start: usize) -> Option<Region> {
    let mut best: Option<Region> = None;
    let mut again = next[start];
    for _ in 0..TRIES {
        let Some(other) = again.filter(|other| other - start <= LONGEST) else { break };
        let period = other - start;
        let count = repeated(items, start, period) / period + 1;
        let is_longer = best.is_none_or(|best| count * period > best.count * best.period);
        if count >= LEAST && is_longer {
            best = Some(Region { start, period, count });
        }
        again = next[other];
    }
    best
}

/// How many items from `start` on repeat themselves a period later.
fn repeated(items: &Items, start: usize, period: usize) -> usize {
    let mut length = 0;
    while start + period + length < items.all.len() {
        let at = start + length;
        if !is_alike(items, at, period) || length >= period && !is_even(items, at - period, period) {
            break;
        }
        length += 1;
    }
    length
}

fn is_alike(items: &Items, at: usize, period: usize) -> bool {
    items.all[at].shape == items.all[at + period].shape
}

/// Do the operands of an item and of those one and two periods later move by equal steps?
fn is_even(items: &Items, at: usize, period: usize) -> bool {
    let [first, second, third] =
        [at, at + period, at + 2 * period].map_each(|at| &items.sources[items.all[at].sources.clone()]);
    first.iter().zip(second).zip(third).all(|((&first, &second), &third)| {
        matches!((step(first, second), step(second, third)), (Some(one), Some(other)) if one == other)
    })
}

/// How far an operand moves on.
pub(super) fn step(from: Source, to: Source) -> Option<isize> {
    match (from, to) {
        (Source::Number(_), Source::Number(_)) | (Source::Symbol(_), Source::Symbol(_)) => Some(0),
        (Source::Element { index: from, .. }, Source::Element { index: to, .. })
        | (Source::Item(from), Source::Item(to)) => Some(to.wrapping_sub(from).cast_signed()),
        _ => None,
    }
}
