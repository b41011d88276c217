//! A loop: its pattern as a tape of its own.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedMap;
use plm_cas::{Expr, Instr, Op, Ref, Tape};

use super::super::super::table_compression;
use super::super::fragment::{Fragment, literal};
use super::super::statement::Statement;
use super::super::{Around, Bindings, Lowering, blocks};
use super::items::Source;
use super::plan::{Loop, Role, Slot};
use super::{Writer, affine};
use crate::formulate::Place;

/// The pattern of a loop.
#[derive(Default)]
struct Pattern {
    tape: Tape,
    /// Text of what is known without an operation, by instruction.
    known: SortedMap<usize, String>,
    /// Instructions of what is known, by text.
    leaves: SortedMap<String, usize>,
    /// Operations that have no name of their own since they stand within others.
    absorbed: Vec<usize>,
    /// Instructions of the items, by their offsets.
    values: Vec<Option<usize>>,
    /// Lines that stand before the loop.
    before: Vec<String>,
    /// Elements of arrays among that, by what makes the arrays.
    tables: SortedMap<String, String>,
    /// Locals of the function that the loop reads.
    reads: Vec<usize>,
    /// Names of carried values: by offset and by how many repetitions ago.
    carried: SortedMap<(usize, usize), String>,
    /// Stores of a repetition: the place and the instruction.
    stored: Vec<(String, usize)>,
}

impl Writer<'_> {
    /// Writes a loop and tells where its values are found.
    pub(super) fn write_loop(&mut self, which: usize) {
        let the_loop = &self.plan.loops[which];
        let mut pattern = Pattern { values: vec![None; the_loop.region.period], ..Pattern::default() };
        let leaves =
            the_loop.roles.iter().map(|role| self.operand(&mut pattern, the_loop, role)).collect_vec();
        self.operations(&mut pattern, the_loop, &leaves);
        self.keep(&mut pattern, which);
        let text = self.text(&mut pattern, the_loop.region.count);
        self.block(text, pattern.reads);
        for item in the_loop.region.start..the_loop.region.end() {
            if let (Some(value), Some((of, place))) = (self.items.value(item), self.plan.place(item)) {
                self.lowering.fragments[value] = Fragment::atom(format!("{}[{place}]", self.arrays[&of]));
            }
        }
    }

    /// The instruction of an operand that the pattern does not compute.
    fn operand(&mut self, pattern: &mut Pattern, the_loop: &Loop, role: &Role) -> Option<usize> {
        let (count, i) = (the_loop.region.count, self.index.clone());
        let (text, like) = match role {
            Role::Inner(_) => return None,
            Role::Same(Source::Number(value)) => return Some(pattern.number(*value)),
            Role::Same(source) => (self.outside(pattern, *source), Some(*source)),
            Role::Constants(numbers) => {
                let numbers = numbers.iter().map(|number| constant(*number)).collect_vec();
                let numbers = table_compression::constants(&numbers);
                (pattern.table(self, &format!("let #: &[f64; {count}] = const {{ &{numbers} }};"), &i), None)
            }
            Role::Gathered(all) => {
                let values = all.iter().map(|source| self.outside(pattern, *source)).collect_vec().join(", ");
                let text = format!("let #: [{}; {count}] = [{values}];", self.lowering.scalar);
                (pattern.table(self, &text, &i), all.first().copied())
            }
            Role::Element { array, index, step } => {
                let place = affine(&i, index.cast_signed(), *step);
                (self.element(*array, &place), None)
            }
            Role::Carried(offset, depth) => {
                let item = Source::Item(the_loop.region.start + offset);
                (self.carried(pattern, the_loop, (*offset, *depth)), Some(item))
            }
            Role::Kept { of, first, step } => {
                let low = self.plan.kept.get(of).map_or(0, |range| range.0);
                let item = Source::Item(self.plan.loops[of.region].region.start + of.offset);
                (format!("{}[{}]", self.arrays[of], affine(&i, first - low, *step)), Some(item))
            }
        };
        let expr = match like {
            Some(Source::Item(item)) => {
                self.items.value(item).and_then(|value| self.items.tape.ops[value].expr)
            }
            Some(Source::Symbol(index)) => self.items.tape.ops[index].expr,
            _ => None,
        };
        Some(pattern.leaf(text, expr))
    }

    /// Text of a value from before the loop.
    fn outside(&self, pattern: &mut Pattern, source: Source) -> String {
        let Source::Item(item) = source else { return self.leaf(source) };
        let Some(value) = self.items.value(item) else { return String::new() };
        let fragment = &self.lowering.fragments[value];
        pattern.reads.extend_from_slice(&fragment.reads);
        fragment.text.clone()
    }

    /// The name of a value of a repetition before, with what it is in the first.
    fn carried(&mut self, pattern: &mut Pattern, the_loop: &Loop, (offset, depth): (usize, usize)) -> String {
        let start = the_loop.region.start + offset;
        for back in 1..=depth {
            if !pattern.carried.contains_key(&(offset, back)) {
                let first = self.outside(pattern, Source::Item(start - back * the_loop.region.period));
                let name = self.general_name(start);
                pattern.before.push(format!("let mut {name} = {first};"));
                pattern.carried.insert((offset, back), name);
            }
        }
        pattern.carried[&(offset, depth)].clone()
    }

    /// The operations of all items of the pattern.
    fn operations(&self, pattern: &mut Pattern, the_loop: &Loop, leaves: &[Option<usize>]) {
        let mut operands = the_loop.roles.iter().zip(leaves);
        let mut next = |pattern: &Pattern| match operands.next() {
            Some((Role::Inner(offset), _)) => pattern.values[*offset].unwrap_or_default(),
            Some((_, leaf)) => leaf.unwrap_or_default(),
            None => 0,
        };
        for offset in 0..the_loop.region.period {
            let item = &self.items.all[the_loop.region.start + offset];
            let mut own: Vec<(usize, usize)> = Vec::new();
            for &index in &self.items.ops[item.ops.clone()] {
                let Instr { op, expr, .. } = self.items.tape.ops[index];
                let op = op.with_operands(|operand| {
                    let known = own.iter().find(|(index, _)| *index == operand.index());
                    Ref::at(known.map_or_else(|| next(pattern), |(_, at)| *at))
                });
                own.push((index, pattern.push(op, expr)));
            }
            if let Some(((_, value), absorbed)) = own.split_last() {
                pattern.absorbed.push_all(absorbed.iter().map(|(_, at)| *at));
                pattern.values[offset] = Some(*value);
            }
            if item.stores.is_some() {
                let [value, place] = [next(pattern), next(pattern)];
                let place = pattern.known.get(&place).cloned().unwrap_or_default();
                pattern.stored.push((place, value));
            }
        }
    }

    /// Keeps what other code reads.
    fn keep(&self, pattern: &mut Pattern, which: usize) {
        for (offset, value) in pattern.values.iter().enumerate() {
            let of = Slot { region: which, offset };
            if let (Some(value), Some(array), Some(range)) =
                (value, self.arrays.get(&of), self.plan.kept.get(&of))
            {
                let place = if range.0 > 0 { "0".to_owned() } else { affine(&self.index, -range.0, 1) };
                pattern.stored.push((format!("{array}[{place}]"), *value));
            }
        }
    }

    /// The text of the loop.
    fn text(&mut self, pattern: &mut Pattern, count: usize) -> String {
        let carried = pattern.carried.iter().map(|(key, name)| (*key, name.clone())).collect_vec();
        let now = carried.iter().filter(|((_, back), _)| *back == 1);
        let now = now.filter_map(|((offset, _), _)| pattern.values[*offset]);
        let results = pattern.stored.iter().map(|(_, value)| *value).chain(now).collect_vec();
        let (scalar, bindings) = (self.lowering.scalar, Bindings::new());
        let around = Around { reserved: &[], by_reference: true, scalar, direct: None, rerolled: false };
        let mut body = Lowering::new(&pattern.tape, &results, &bindings, &around);
        let named = pattern.named(&body.uses, &body.is_result);
        body.known_names = Some(&named);
        body.known = std::mem::take(&mut pattern.known);
        body.groups.clear();
        body.is_general = true;
        std::mem::swap(&mut body.names, &mut self.lowering.names);
        body.lower_until(pattern.tape.ops.len());
        for (place, value) in &pattern.stored {
            body.store(&Place::Path(place.clone()), *value);
        }
        // What was carried longest goes first, before it is overwritten.
        for ((offset, back), name) in carried.iter().rev() {
            if *back > 1 {
                let value = pattern.carried[&(*offset, back - 1)].clone();
                let reads = Vec::new();
                body.lines.statements.push(Statement::Store { place: name.clone(), value, reads });
            } else if let Some(value) = pattern.values[*offset] {
                body.store(&Place::Path(name.clone()), value);
            }
        }
        std::mem::swap(&mut body.names, &mut self.lowering.names);
        let inner = blocks::body(&body.lines, 8);
        let before = [&["{".to_owned()], pattern.before.as_slice()].concat().join("\n    ");
        format!("{before}\n    for {} in 0..{count} {{\n{inner}    }}\n}}", self.index)
    }
}

impl Pattern {
    fn push(&mut self, op: Op, expr: Option<Expr>) -> usize {
        self.tape.ops.push(Instr { op, expr, uses: 0 });
        self.tape.ops.len() - 1
    }

    fn number(&mut self, value: f64) -> usize {
        if let Some(&known) = self.leaves.get(&literal(value)) {
            return known;
        }
        let at = self.push(Op::Number(value), None);
        self.leaves.insert(literal(value), at);
        at
    }

    fn leaf(&mut self, text: String, expr: Option<Expr>) -> usize {
        if let Some(&known) = self.leaves.get(&text) {
            return known;
        }
        let at = self.push(Op::Symbol(Expr::ZERO), expr);
        self.leaves.insert(text.clone(), at);
        self.known.insert(at, text);
        at
    }

    /// An array that is made before the loop; `#` is its name, and then its element.
    fn table(&mut self, writer: &mut Writer, text: &str, index: &str) -> String {
        if let Some(known) = self.tables.get(text) {
            return known.clone();
        }
        let (is_constant, name) = (text.starts_with("let #: &"), writer.lowering.names.numbered("k"));
        self.before.push(text.replacen('#', &name, 1));
        let element = if is_constant { format!("lit({name}[{index}])") } else { format!("{name}[{index}]") };
        self.tables.insert(text.to_owned(), element.clone());
        element
    }

    /// Which instructions have a name: products that are not fused where they stand alone are not fused in the pattern.
    fn named(&self, uses: &[u32], is_result: &[bool]) -> Vec<bool> {
        let named = |(index, instruction): (usize, &Instr)| match instruction.op {
            Op::Number(_) => false,
            Op::Symbol(_) => uses[index] > 1,
            _ => is_result[index] || uses[index] > 1 || !self.absorbed.contains(&index),
        };
        self.tape.ops.iter().enumerate().map(named).collect_vec()
    }
}

fn constant(value: f64) -> String {
    literal(value).trim_start_matches("lit(").trim_end_matches(')').to_owned()
}
