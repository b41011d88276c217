//! Long functions with loops: what repeats itself, link after link, is written once.
//!
//! The operations and their operands are those of the unrolled code, product and sum are fused where they are there, and so
//! the bits are the same. What is read in the next repetition alone is carried, what other code reads stands in arrays.

mod body;
mod items;
mod plan;
mod regions;

use crate::collect::{CollectVec, MapEach, PushAll};
use crate::formulate::{Function, Place};
use crate::sorted::SortedMap;
use plm_cas::Op;

use self::items::{COSINES, Items, SINES, Source, named};
use self::plan::{Plan, Slot};
use super::fragment::{Fragment, literal};
use super::statement::{Lines, Statement};
use super::{Around, Bindings, Lowering, uses};

/// How many sines are computed together.
const LANES: usize = 8;

/// The function with loops; nothing where nothing repeats itself.
pub(super) fn lower(function: &Function, bindings: &Bindings, around: &Around) -> Option<Lines> {
    let tape = function.tape();
    let first = tape.outputs.len() - function.results.len();
    let results = tape.outputs[first..].iter().map(|result| result.index()).collect_vec();
    let uses = uses(&tape, &results, &SortedMap::new());
    let mut named = named(&tape, &uses);
    let mut lowering = Lowering::new(&tape, &results, bindings, around);
    let sines = [SINES, COSINES].map_each(|which| lowering.names.unique(["sines", "cosines"][which]));
    let items = Items::of((function, &tape), bindings, (&uses, &named), [&sines[0], &sines[1]]);
    let plan = Plan::of(&items);
    if plan.loops.is_empty() {
        return None;
    }
    for value in plan.read.iter().filter_map(|&item| items.value(item)) {
        named[value] = true;
    }
    lowering.known_names = Some(&named);
    lowering.groups.clear();
    lowering.fragments = vec![Fragment::default(); tape.ops.len()];
    let index = lowering.names.unique("i");
    let mut writer = Writer { items: &items, plan: &plan, lowering, arrays: SortedMap::new(), index };
    writer.declare(sines);
    writer.leaves();
    writer.all();
    Some(writer.lowering.finish())
}

struct Writer<'a> {
    items: &'a Items<'a>,
    plan: &'a Plan,
    lowering: Lowering<'a>,
    /// Names of the arrays of kept values.
    arrays: SortedMap<Slot, String>,
    /// The name of the counter of all loops.
    index: String,
}

impl Writer<'_> {
    /// Arrays stand in front of everything.
    fn declare(&mut self, sines: [String; 2]) {
        let count = self.items.sines.len();
        if count > 0 {
            self.lowering.lines.arrays.push_all(sines.map_each(|name| (name, count)));
            self.sines();
        }
        for (&of, &(low, high)) in &self.plan.kept {
            let item = self.plan.loops[of.region].region.start + of.offset;
            let name = self.general_name(item);
            let length = usize::try_from(high - low + 1).unwrap_or_default();
            self.lowering.lines.arrays.push((name.clone(), length));
            self.arrays.insert(of, name);
        }
    }

    /// The name of an item's value without the numbers in it, which change from one repetition to the next.
    fn general_name(&mut self, item: usize) -> String {
        let expr = self.items.value(item).and_then(|value| self.items.tape.ops[value].expr);
        match expr.and_then(plm_cas::Expr::name) {
            Some(hint) => self.lowering.names.unique(&super::without_numbers(&hint)),
            None => self.lowering.names.numbered("t"),
        }
    }

    /// Sines and cosines of all coordinates, as many at once as fill vectors.
    fn sines(&mut self) {
        let sines = &self.items.sines;
        let mut begin = 0;
        while begin < sines.len() {
            let ((array, first), _) = sines[begin];
            let step = match sines.get(begin + 1) {
                Some(&((other, second), _)) if other == array => second - first,
                _ => 1,
            };
            let in_row = |(k, sine): &(usize, &((usize, usize), usize))| sine.0 == (array, first + k * step);
            let count = sines[begin..].iter().enumerate().take_while(in_row).count();
            let (rounds, rest) = (count / LANES, count % LANES);
            let i = self.index.clone();
            if rounds > 0 {
                let angle = |lane: usize| {
                    affine(&i, (first + lane * step).cast_signed(), (LANES * step).cast_signed())
                };
                let place = |lane: usize| affine(&i, (begin + lane).cast_signed(), LANES.cast_signed());
                let text = self.sines_at_once(LANES, |lane| [angle(lane), place(lane)], array);
                self.block(format!("for {i} in 0..{rounds} {{\n{text}}}"), Vec::new());
            }
            if rest > 0 {
                let lane = |lane: usize| {
                    let after = rounds * LANES + lane;
                    [first + after * step, begin + after].map_each(|number| number.to_string())
                };
                let text = self.sines_at_once(rest, lane, array);
                self.block(format!("{{\n{text}}}"), Vec::new());
            }
            begin += count;
        }
    }

    /// Lines that compute so many sines and cosines; each is told where its angle stands, and where they go.
    fn sines_at_once(&self, count: usize, places: impl Fn(usize) -> [String; 2], array: usize) -> String {
        let all = (0..count).map(places).collect_vec();
        let angles = all.iter().map(|[angle, _]| self.element(array, angle)).collect_vec().join(", ");
        let stored = all.iter().enumerate().map(|(lane, [_, place])| {
            let [sine, cosine] = [SINES, COSINES].map_each(|array| self.element(array, place));
            format!("    {sine} = s[{lane}];\n    {cosine} = c[{lane}];\n")
        });
        let stored: String = stored.collect();
        format!("    let (s, c) = {}::sin_cos_all([{angles}]);\n{stored}", self.lowering.scalar)
    }

    fn block(&mut self, text: String, reads: Vec<usize>) {
        self.lowering.lines.statements.push(Statement::Block { text, reads });
    }

    /// An element of an array that exists anyway.
    fn element(&self, array: usize, index: &str) -> String {
        let (before, after) = &self.items.arrays[array];
        format!("{before}{index}{after}")
    }

    /// Constants and symbols stand wherever they are read.
    fn leaves(&mut self) {
        for index in 0..self.items.tape.ops.len() {
            if let Some(leaf) = self.items.leaf(index) {
                self.lowering.fragments[index] = Fragment::atom(self.leaf(leaf));
            }
        }
    }

    fn leaf(&self, source: Source) -> String {
        match source {
            Source::Number(value) => literal(value),
            Source::Element { array, index } => self.element(array, &index.to_string()),
            Source::Symbol(index) | Source::Item(index) => match self.items.tape.ops[index].op {
                Op::Symbol(symbol) => {
                    self.lowering.bindings.get(&symbol).cloned().unwrap_or_else(|| "()".to_owned())
                }
                _ => String::new(),
            },
        }
    }

    /// All items in order, those of a loop at once.
    fn all(&mut self) {
        let (mut at, mut titles) = (0, self.items.titles.iter().peekable());
        let entered: SortedMap<(usize, Slot), usize> =
            self.plan.entered(self.items).into_iter().map(|(item, of, place)| ((item, of), place)).collect();
        let mut entered = (&entered).into_iter().peekable();
        while at < self.items.all.len() {
            let inside = self.plan.inside(at);
            let end = inside.map_or(at + 1, |which| self.plan.loops[which].region.end());
            while let Some((_, title)) = titles.next_if(|title| title.0 < end) {
                self.lowering.title(title);
            }
            match inside {
                Some(which) => self.write_loop(which),
                None => self.item(at),
            }
            while let Some((&(item, of), place)) = entered.next_if(|((item, _), _)| *item < end) {
                self.enter(item, of, *place);
            }
            at = end;
        }
        for (&result, (place, _)) in self.items.results.iter().zip(&self.items.function.results) {
            if *place == Place::Value {
                self.lowering.store(place, result);
            }
        }
    }

    fn item(&mut self, at: usize) {
        let item = &self.items.all[at];
        for &op in &self.items.ops[item.ops.clone()] {
            if self.lowering.fragments[op].text.is_empty() {
                self.lowering.fragments[op] = self.lowering.lower(op);
            }
        }
        if let Some(result) = item.stores {
            self.lowering.store(&self.items.function.results[result].0, self.items.results[result]);
        }
    }

    /// Puts a value in its place among those of a loop.
    fn enter(&mut self, item: usize, of: Slot, place: usize) {
        let Some(value) = self.items.value(item) else { return };
        let Fragment { text, reads, .. } = self.lowering.fragments[value].clone();
        let place = format!("{}[{place}]", self.arrays[&of]);
        self.lowering.lines.statements.push(Statement::Store { place, value: text, reads });
    }
}

/// An index that moves with the counter of a loop.
fn affine(counter: &str, first: isize, step: isize) -> String {
    match (first, step) {
        (0, 1) => counter.to_owned(),
        (_, 1) => format!("{counter} + {first}"),
        (_, -1) => format!("{first} - {counter}"),
        (0, _) => format!("{step} * {counter}"),
        (_, 0..) => format!("{step} * {counter} + {first}"),
        _ => format!("{first} - {} * {counter}", -step),
    }
}
