//! Pairs of items that several rows have, the most frequent first.
//!
//! Counts are upper bounds: rows that have changed since are struck from a pair when it comes up, and it goes back
//! into the queue if it is no longer the most frequent. So the work is near-linear in the number of pairs.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use super::rows::{Item, Kind, Numbers, Rows, literal};
use crate::hash::{Mixer, Table};

/// In longer rows only items at most this far apart are paired.
const REACH: usize = 12;

/// End of a list.
const END: u32 = u32::MAX;

#[derive(Copy, Clone, PartialEq, Eq)]
struct Pair {
    /// Ids of the two items, ascending.
    a: u32,
    b: u32,
    /// The coefficient of b divided by that of a: pairs count as equal up to scale.
    ratio: u32,
}

struct Entry {
    pair: Pair,
    /// Head of the list of rows in `links`.
    head: u32,
    count: u32,
}

struct Search<'r> {
    rows: &'r mut Rows,
    kind: Kind,
    memo: Table,
    entries: Vec<Entry>,
    /// Row and next link.
    links: Vec<(u32, u32)>,
    /// Count and entry; the largest count first, of equals the oldest.
    queue: BinaryHeap<(u32, Reverse<u32>)>,
}

/// Gives each pair that is found in two or more rows of this kind a row of its own.
pub(super) fn extract(rows: &mut Rows, kind: Kind) {
    let mut search = Search {
        rows,
        kind,
        memo: Table::new(),
        entries: Vec::new(),
        links: Vec::new(),
        queue: BinaryHeap::new(),
    };
    for row in 0..search.rows.len() {
        if search.rows.kind(row) == kind {
            for last in 1..search.rows.items(row).len() {
                search.pair_with_earlier(row, last);
            }
        }
    }
    while let Some((_, Reverse(entry))) = search.queue.pop() {
        search.consider(entry as usize);
    }
}

impl Search<'_> {
    /// Notes the pairs of an item with those before it.
    fn pair_with_earlier(&mut self, row: usize, last: usize) {
        for first in last.saturating_sub(REACH)..last {
            self.pair(row, first, last);
        }
    }

    fn pair(&mut self, row: usize, first: usize, last: usize) {
        let (a, b) = (self.rows.items(row)[first], self.rows.items(row)[last]);
        if let Some(ratio) = self.rows.numbers.ratio(b.coefficient, a.coefficient) {
            self.note(Pair { a: a.id, b: b.id, ratio }, row as u32);
        }
    }

    fn note(&mut self, pair: Pair, row: u32) {
        let mut mixer = Mixer::new(u64::from(pair.ratio));
        mixer.word(u64::from(pair.a) << 32 | u64::from(pair.b));
        let hash = mixer.finish();
        let Some(known) = self.memo.find(hash, |i| self.entries[i].pair == pair) else {
            self.memo.push(hash);
            self.links.push((row, END));
            self.entries.push(Entry { pair, head: self.links.len() as u32 - 1, count: 1 });
            return;
        };
        let entry = &mut self.entries[known];
        if entry.head != END && self.links[entry.head as usize].0 == row {
            return; // x*x*y has the pair (x, y) twice
        }
        self.links.push((row, entry.head));
        entry.head = self.links.len() as u32 - 1;
        entry.count += 1;
        if entry.count > 1 {
            self.queue.push((entry.count, Reverse(known as u32)));
        }
    }

    /// Strikes the rows that have lost the pair, then uses it if no other is more frequent.
    fn consider(&mut self, entry: usize) {
        let pair = self.entries[entry].pair;
        let mut having = Vec::new();
        let mut link = self.entries[entry].head;
        while link != END {
            let (row, next) = self.links[link as usize];
            if self.find(row as usize, pair).is_some() {
                having.push(row);
            }
            link = next;
        }
        having.sort_unstable();
        having.dedup();
        let count = having.len() as u32;
        self.relist(entry, &having);
        if count < 2 {
            return;
        }
        if self.queue.peek().is_some_and(|next| next.0 > count) {
            self.queue.push((count, Reverse(entry as u32)));
            return;
        }
        self.entries[entry].count = 0;
        self.entries[entry].head = END;
        self.replace(pair, &having);
    }

    fn relist(&mut self, entry: usize, having: &[u32]) {
        let mut link = END;
        let mut free = self.entries[entry].head;
        for &row in having {
            // The list has at least as many links as rows are left: reuse them.
            let next_free = self.links[free as usize].1;
            self.links[free as usize] = (row, link);
            link = free;
            free = next_free;
        }
        self.entries[entry].head = link;
        self.entries[entry].count = having.len() as u32;
    }

    /// The places of the two items in a row, if it has them in this ratio.
    fn find(&mut self, row: usize, pair: Pair) -> Option<(usize, usize)> {
        let items = self.rows.items(row);
        let first = items.iter().position(|item| item.id == pair.a)?;
        let second = first + 1 + items[first + 1..].iter().position(|item| item.id == pair.b)?;
        let (a, b) = (items[first], items[second]);
        (self.rows.numbers.ratio(b.coefficient, a.coefficient)? == pair.ratio).then_some((first, second))
    }

    /// Lets all rows read the pair from one row: the one that is nothing else, or a new one.
    fn replace(&mut self, pair: Pair, having: &[u32]) {
        let complete = having.iter().find(|&&row| self.rows.items(row as usize).len() == 2);
        let shared = match complete {
            Some(&row) => row as usize,
            None => self.new_row(pair, having),
        };
        let Some((at, _)) = self.find(shared, pair) else { return };
        let unit = self.rows.items(shared)[at].coefficient;
        let id = if self.kind == Kind::Product { literal(shared as u32, false) } else { shared as u32 };
        for &row in having {
            let row = row as usize;
            if row == shared {
                continue;
            }
            while let Some((first, second)) = self.find(row, pair) {
                let coefficient = self.rows.items(row)[first].coefficient;
                let coefficient = self.rows.numbers.quotient(coefficient, unit);
                self.rows.remove(row, second);
                self.rows.remove(row, first);
                self.rows.put_back(row, Item { id, coefficient });
            }
            self.pair_with_all(row, id);
        }
    }

    /// Notes the pairs of a new item, which stands at the end of its row.
    fn pair_with_all(&mut self, row: usize, id: u32) {
        self.rows.items_mut(row).sort_unstable();
        let Some(at) = self.rows.items(row).iter().position(|item| item.id == id) else { return };
        self.pair_with_earlier(row, at);
        let end = self.rows.items(row).len().min(at + 1 + REACH);
        for last in at + 1..end {
            self.pair(row, at, last);
        }
    }

    /// The pair with the coefficients that it has in one of the rows, the simplest ones, the first positive.
    fn new_row(&mut self, pair: Pair, having: &[u32]) -> usize {
        let mut simplest: Option<(usize, Item, Item)> = None;
        for &row in having {
            if let Some((first, second)) = self.find(row as usize, pair) {
                let items = self.rows.items(row as usize);
                let scaled = |at: usize| usize::from(!Numbers::is_unit(items[at].coefficient));
                let cost = scaled(first) + scaled(second);
                if simplest.is_none_or(|(least, ..)| cost < least) {
                    simplest = Some((cost, items[first], items[second]));
                }
            }
        }
        let Some((_, mut a, mut b)) = simplest else { return having[0] as usize };
        if self.rows.numbers.get(a.coefficient).is_negative() {
            a.coefficient = self.rows.numbers.product(Numbers::MINUS_ONE, a.coefficient);
            b.coefficient = self.rows.numbers.product(Numbers::MINUS_ONE, b.coefficient);
        }
        self.rows.push(self.kind, &[a, b])
    }
}
