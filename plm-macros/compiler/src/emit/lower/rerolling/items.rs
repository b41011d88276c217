//! A function as a row of items, so that one can be held against another.
//!
//! An item is an operation with what has to stay with it: the product that its sum fuses, the condition of a choice, which
//! is no number and could not wait in an array. Stores are items too. Constants, symbols, and sines and cosines of
//! coordinates are none: they are at hand anywhere.

use std::ops::Range;

use crate::collect::{CollectVec, PushAll};
use crate::formulate::{Function, Place};
use crate::sorted::SortedMap;
use plm_cas::{Op, Tape};

use super::super::sines::is_pair;
use super::super::{Bindings, MOST_TERMS};

/// Source of an operand.
#[derive(Clone, Copy)]
pub(super) enum Source {
    /// A constant.
    Number(f64),
    /// A place of an array, of [`Items::arrays`]; of a store also the place to which it goes.
    Element { array: usize, index: usize },
    /// A symbol that stands by itself, by its instruction.
    Symbol(usize),
    /// An item before.
    Item(usize),
}

/// An item that is compared with others.
pub(super) struct Item {
    /// Items of the same number have the same operations between sources of the same kinds.
    pub(super) shape: usize,
    /// Its instructions, by their places in [`Items::ops`]; the last is the value. A store has none.
    pub(super) ops: Range<usize>,
    /// Sources of its operands, in order, by their places in [`Items::sources`].
    pub(super) sources: Range<usize>,
    /// Which result a store stores.
    pub(super) stores: Option<usize>,
}

/// Text before and after the index of an array's element.
type Around = (String, String);

/// All of a function.
pub(super) struct Items<'a> {
    pub(super) tape: &'a Tape,
    pub(super) function: &'a Function,
    /// Instructions of the results, in their order.
    pub(super) results: Vec<usize>,
    pub(super) all: Vec<Item>,
    pub(super) ops: Vec<usize>,
    pub(super) sources: Vec<Source>,
    pub(super) arrays: Vec<Around>,
    /// Sines (by instruction) that stand, each with the cosine after it, in arrays from the beginning on; the array and
    /// index of the angle before.
    pub(super) sines: Vec<((usize, usize), usize)>,
    /// Titles of sections, and the items before which they stand.
    pub(super) titles: Vec<(usize, &'a str)>,
    /// Instructions that are no leaves: the item of each.
    pub(super) item_of: Vec<Option<usize>>,
    leaves: Vec<Option<Source>>,
    is_absorbed: Vec<bool>,
    shapes: SortedMap<Vec<usize>, usize>,
    known_arrays: SortedMap<Around, usize>,
}

/// In the key of a shape, sources have numbers from here on, operations lower ones: as many sources follow an operation as it
/// takes, and a store begins with a source.
const SOURCES: usize = 1000;

/// The arrays of sines and of cosines.
pub(super) const SINES: usize = 0;
pub(super) const COSINES: usize = 1;

impl<'a> Items<'a> {
    /// The items of a function; `uses` and `named` as unrolled code has them, `sines` are the names of two arrays.
    pub(super) fn of(
        (function, tape): (&'a Function, &'a Tape),
        bindings: &Bindings,
        (uses, named): (&[u32], &[bool]),
        sines: [&str; 2],
    ) -> Items<'a> {
        let (count, first) = (tape.ops.len(), tape.outputs.len() - function.results.len());
        let mut items = Items {
            tape,
            function,
            results: tape.outputs[first..].iter().map(|result| result.index()).collect_vec(),
            all: Vec::new(),
            ops: Vec::new(),
            sources: Vec::new(),
            arrays: Vec::new(),
            sines: Vec::new(),
            titles: Vec::new(),
            item_of: vec![None; count],
            leaves: vec![None; count],
            is_absorbed: vec![false; count],
            shapes: SortedMap::new(),
            known_arrays: SortedMap::new(),
        };
        for name in sines {
            items.array(format!("{name}["), "]".to_owned());
        }
        items.find_leaves(bindings, uses);
        items.absorb(uses, named);
        items.walk(uses);
        items
    }

    /// The value of an item.
    pub(super) fn value(&self, item: usize) -> Option<usize> {
        self.ops[self.all[item].ops.clone()].last().copied()
    }

    /// A leaf, by its instruction.
    pub(super) fn leaf(&self, instruction: usize) -> Option<Source> {
        self.leaves[instruction]
    }

    fn array(&mut self, before: String, after: String) -> usize {
        let next = self.arrays.len();
        let array = *self.known_arrays.or_insert((before.clone(), after.clone()), next);
        if array == next {
            self.arrays.push((before, after));
        }
        array
    }

    fn element(&mut self, text: &str) -> Option<Source> {
        let (before, index, after) = at_index(text)?;
        Some(Source::Element { array: self.array(before.to_owned(), after.to_owned()), index })
    }

    fn find_leaves(&mut self, bindings: &Bindings, uses: &[u32]) {
        let tape = self.tape;
        for (index, instruction) in tape.ops.iter().enumerate() {
            self.leaves[index] = match instruction.op {
                Op::Number(value) => Some(Source::Number(value)),
                Op::Symbol(symbol) => {
                    let element = bindings.get(&symbol).and_then(|text| self.element(text));
                    Some(element.unwrap_or(Source::Symbol(index)))
                }
                Op::Sin(angle) if is_pair(tape, uses, index) => {
                    if let Some(Source::Element { array, index: place }) = self.leaves[angle.index()] {
                        self.sines.push(((array, place), index));
                    }
                    None
                }
                _ => None,
            };
        }
        crate::sorted::sort_by_key(&mut self.sines, |sine| sine.0);
        for (index, &(_, sine)) in self.sines.iter().enumerate() {
            self.leaves[sine] = Some(Source::Element { array: SINES, index });
            self.leaves[sine + 1] = Some(Source::Element { array: COSINES, index });
        }
    }

    /// Products that sums fuse, as they are without loops, and conditions.
    fn absorb(&mut self, uses: &[u32], named: &[bool]) {
        for instruction in &self.tape.ops {
            if let Op::Add(a, b) | Op::Sub(a, b) = instruction.op {
                let is_fused = |at: &plm_cas::Ref| {
                    let at = at.index();
                    matches!(self.tape.ops[at].op, Op::Mul(..)) && uses[at] == 1 && !named[at]
                };
                if let Some(product) = [b, a].into_iter().find(is_fused) {
                    self.is_absorbed[product.index()] = true;
                }
            }
        }
        for (index, instruction) in self.tape.ops.iter().enumerate() {
            self.is_absorbed[index] |= matches!(instruction.op, Op::Less(..));
        }
    }

    /// All items, in the order in which they are emitted: what is stored follows its value.
    fn walk(&mut self, uses: &[u32]) {
        let function = self.function;
        let mut stores = vec![Vec::new(); self.tape.ops.len()];
        for (k, &result) in self.results.iter().enumerate() {
            if self.leaves[result].is_none() && !matches!(function.results[k].0, Place::Value) {
                stores[result].push(k);
            }
        }
        let (mut root, mut done) = (0, 0);
        let mut go_on = |items: &mut Self, end: usize| {
            for index in done..end {
                let is_item = uses[index] > 0 && items.leaves[index].is_none() && !items.is_absorbed[index];
                if is_item {
                    items.push(index);
                    stores[index].iter().for_each(|&result| items.push_store(result));
                }
            }
            done = done.max(end);
        };
        for section in &function.sections {
            let roots = &self.tape.outputs[root..root + section.roots.len()];
            root += section.roots.len();
            self.titles.push((self.all.len(), &section.title));
            go_on(self, roots.iter().map(|root| root.index() + 1).max().unwrap_or(0));
        }
        if !function.sections.is_empty() {
            self.titles.push((self.all.len(), "Results"));
        }
        for k in 0..self.results.len() {
            go_on(self, self.results[k] + 1);
            if self.leaves[self.results[k]].is_some() && !matches!(function.results[k].0, Place::Value) {
                self.push_store(k);
            }
        }
    }

    fn push(&mut self, index: usize) {
        let (mut ops, mut key) = (Vec::new(), Vec::new());
        let first = self.sources.len();
        for operand in self.tape.ops[index].op.operands() {
            let at = operand.index();
            if self.is_absorbed[at] && !ops.contains(&at) {
                self.push_operation(at, &ops, &mut key);
                ops.push(at);
            }
        }
        self.push_operation(index, &ops, &mut key);
        ops.push(index);
        self.item_of[index] = Some(self.all.len());
        self.finish(key, first, (&ops, None));
    }

    /// Notes where the operands of an operation come from, of which `ops` stand before it in its item.
    fn push_operation(&mut self, index: usize, ops: &[usize], key: &mut Vec<usize>) {
        let op = self.tape.ops[index].op;
        key.push(usize::from(op.kind()));
        for operand in op.operands() {
            match ops.iter().position(|&before| before == operand.index()) {
                Some(before) => key.push(before),
                None => self.push_source(self.source(operand.index()), key),
            }
        }
    }

    fn source(&self, index: usize) -> Source {
        match (self.leaves[index], self.item_of[index]) {
            (Some(leaf), _) => leaf,
            (None, Some(item)) => Source::Item(item),
            (None, None) => Source::Symbol(index),
        }
    }

    fn push_source(&mut self, source: Source, key: &mut Vec<usize>) {
        key.push(match source {
            Source::Number(_) => SOURCES,
            Source::Symbol(_) => SOURCES + 1,
            Source::Item(_) => SOURCES + 2,
            Source::Element { array, .. } => SOURCES + 3 + array,
        });
        self.sources.push(source);
    }

    fn push_store(&mut self, result: usize) {
        let place = match &self.function.results[result].0 {
            Place::Value => return,
            Place::Element(array, i) => format!("{array}[{i}]"),
            Place::Entry(matrix, i, j) => format!("{matrix}[{i}][{j}]"),
            Place::Path(path) => path.clone(),
            Place::Rows(place) => place.to_string(),
        };
        let (first, mut key) = (self.sources.len(), Vec::new());
        self.push_source(self.source(self.results[result]), &mut key);
        match self.element(&place) {
            Some(element) => self.push_source(element, &mut key),
            // A place by itself is like no other.
            None => key.push_all([0, self.all.len()]),
        }
        self.finish(key, first, (&[], Some(result)));
    }

    fn finish(&mut self, key: Vec<usize>, first: usize, (ops, stores): (&[usize], Option<usize>)) {
        let next = self.shapes.len();
        let shape = *self.shapes.or_insert(key, next);
        let begin = self.ops.len();
        self.ops.extend_from_slice(ops);
        self.all.push(Item { shape, ops: begin..self.ops.len(), sources: first..self.sources.len(), stores });
    }
}

/// Text before the last index in brackets that is a number, that number, and the text after it.
fn at_index(text: &str) -> Option<(&str, usize, &str)> {
    for (open, _) in text.rmatch_indices('[') {
        let (before, rest) = text.split_at(open + 1);
        let digits = rest.find(|letter: char| !letter.is_ascii_digit())?;
        let (digits, after) = rest.split_at(digits);
        if let (Ok(index), true) = (digits.parse(), after.starts_with(']')) {
            return Some((before, index, after));
        }
    }
    None
}

/// Which instructions have a name of their own in unrolled code: what is read again, and what would be too long where it
/// stands.
pub(super) fn named(tape: &Tape, uses: &[u32]) -> Vec<bool> {
    let mut terms: Vec<usize> = Vec::with_capacity(tape.ops.len());
    let mut named = Vec::with_capacity(tape.ops.len());
    for (index, instruction) in tape.ops.iter().enumerate() {
        let of_operands: usize = instruction.op.operands().map(|operand| terms[operand.index()]).sum();
        let is_number = matches!(instruction.op, Op::Number(_));
        let is_paired = matches!(instruction.op, Op::Sin(_)) && is_pair(tape, uses, index)
            || matches!(instruction.op, Op::Cos(_)) && index > 0 && is_pair(tape, uses, index - 1);
        let is_named = is_paired || !is_number && (uses[index] > 1 || of_operands > MOST_TERMS);
        named.push(is_named);
        terms.push(if is_named { 1 } else { of_operands.max(1) });
    }
    named
}
