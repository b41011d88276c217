//! From a tape to statements that read as if a person had written them.
//!
//! A value that is used once stands where it is used, one that is used again gets a `let` with the name from derivation.
//! The operations and their order are those of the tape, so that the interpreter is the oracle of the emitted code.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;
use plm_cas::{Count, Expr, Op, Ref, Tape};

mod around;
mod blocks;
mod fragment;
pub(crate) mod names;
mod parts;
mod rerolling;
mod sines;
mod statement;

pub(super) use self::around::Around;
use self::around::Constants;
use self::fragment::{Fragment, literal};
use self::names::Names;
pub(super) use self::parts::{Part, Parts, parts};
use self::sines::angle_groups;
pub(crate) use self::sines::is_pair;
use self::statement::{Lines, Statement};
use crate::formulate::{Function, Place};

/// rustc recurses over the terms of a statement: what has more than these gets a `let`, so that an operation on two
/// such values stays within 16.
pub(crate) const MOST_TERMS: usize = 8;

/// Source text of every symbol that a function may read, e.g. `x[2]`, `self.damping`.
pub(super) type Bindings = SortedMap<Expr, String>;

/// The statements of a function and its operations.
pub(super) fn statements(function: &Function, bindings: &Bindings, around: &Around) -> (String, Count) {
    let rerolled = around.rerolled.then(|| rerolling::lower(function, bindings, around)).flatten();
    let lines = rerolled.unwrap_or_else(|| lower((function, Constants::Factors), bindings, around));
    let count = lines.count;
    (blocks::with_literals(lines, around), count)
}

/// An expression as one of Rust: a block where it needs locals.
pub(super) fn inline(expr: Expr, bindings: &Bindings) -> String {
    if let Some(number) = expr.as_number() {
        return literal(number.to_f64());
    }
    let function = Function::of_results(vec![(Place::Value, expr)]);
    let reserved: Vec<&str> = bindings.values().map(String::as_str).chain(["lit"]).collect_vec();
    let around =
        Around { reserved: &reserved, by_reference: true, scalar: "S", direct: None, rerolled: false };
    let lines = lower((&function, Constants::Numbers), bindings, &around);
    match (&lines.value, lines.statements.is_empty()) {
        (Some((value, _)), true) => value.clone(),
        _ => format!("{{\n{}}}", blocks::body(&lines, 4)),
    }
}

/// Lowers a function, with its constants written so.
fn lower((function, constants): (&Function, Constants), bindings: &Bindings, around: &Around) -> Lines {
    let tape = function.tape();
    let first_result = tape.outputs.len() - function.results.len();
    let results: Vec<usize> = tape.outputs[first_result..].iter().map(|result| result.index()).collect_vec();
    let mut lowering = Lowering { constants, ..Lowering::new(&tape, &results, bindings, around) };
    let mut root = 0;
    let mut done = 0;
    for section in &function.sections {
        let end =
            (root..root + section.roots.len()).map(|k| tape.outputs[k].index() + 1).max().unwrap_or(done);
        root += section.roots.len();
        lowering.title(&section.title);
        lowering.lower_until(end.max(done));
        done = done.max(end);
    }
    if !function.sections.is_empty() {
        lowering.title("Results");
    }
    for ((place, _), &result) in function.results.iter().zip(&results) {
        lowering.lower_until((result + 1).max(done));
        done = done.max(result + 1);
        lowering.store(place, result);
    }
    lowering.finish()
}

struct Lowering<'a> {
    tape: &'a Tape,
    bindings: &'a Bindings,
    scalar: &'a str,
    constants: Constants,
    /// Angles that `DIRECT` tells of.
    direct: Option<&'a [Expr]>,
    names: Names,
    /// How often a result needs each instruction.
    uses: Vec<u32>,
    /// Is the instruction a result by itself?
    is_result: Vec<bool>,
    /// Text of the instructions before `fragments.len()`.
    fragments: Vec<Fragment>,
    /// Has the instruction a name?
    named: Vec<bool>,
    /// True for values with a name, where that is known: of a part of a function by the whole.
    known_names: Option<&'a [bool]>,
    /// Do names hold for every repetition of a loop?
    is_general: bool,
    /// Instructions whose values are known, as text.
    known: SortedMap<usize, String>,
    /// Sines (by instruction) whose angles are coordinates, in groups that are computed together.
    groups: Vec<Vec<usize>>,
    /// Values that were lowered before their turn.
    early: SortedMap<usize, Fragment>,
    lines: Lines,
}

impl<'a> Lowering<'a> {
    fn new(tape: &'a Tape, results: &[usize], bindings: &'a Bindings, around: &Around<'a>) -> Self {
        let &Around { reserved, direct, scalar, .. } = around;
        let known = SortedMap::new();
        let uses = uses(tape, results, &known);
        let groups = angle_groups(tape, &uses);
        let needed =
            tape.ops.iter().zip(&uses).filter(|(_, uses)| **uses > 0).map(|(instruction, _)| instruction);
        let lines = Lines {
            arrays: Vec::new(),
            statements: Vec::new(),
            value: None,
            locals: Vec::new(),
            count: Count::of(needed),
        };
        let names = Names::with_reserved(reserved);
        let mut is_result = vec![false; tape.ops.len()];
        for &result in results {
            is_result[result] = true;
        }
        let (fragments, named) = (Vec::with_capacity(tape.ops.len()), vec![false; tape.ops.len()]);
        let (early, known_names) = (SortedMap::new(), None);
        Lowering {
            tape,
            bindings,
            scalar,
            constants: Constants::Factors,
            direct,
            names,
            uses,
            is_result,
            fragments,
            named,
            known_names,
            is_general: false,
            known,
            groups,
            early,
            lines,
        }
    }

    /// Announces a section; a section without statements leaves no title.
    fn title(&mut self, title: &str) {
        if let Some(Statement::Title(last)) = self.lines.statements.last_mut() {
            title.clone_into(last);
        } else {
            self.lines.statements.push(Statement::Title(title.to_owned()));
        }
    }

    /// Lowers all instructions before `end`.
    fn lower_until(&mut self, end: usize) {
        while self.fragments.len() < end {
            let index = self.fragments.len();
            let fragment = if self.uses[index] == 0 { Fragment::default() } else { self.lower(index) };
            self.fragments.push(fragment);
        }
    }

    fn lower(&mut self, index: usize) -> Fragment {
        if let Some(fragment) = self.early.remove(&index) {
            return fragment;
        }
        if let Some(text) = self.known.get(&index) {
            let fragment = Fragment::atom(text.clone());
            return if self.uses[index] > 1 { self.bind(index, fragment) } else { fragment };
        }
        let op = self.tape.ops[index].op;
        if let Op::Sin(angle) = op
            && is_pair(self.tape, &self.uses, index)
        {
            self.bind_sines(index, angle);
            return self.early.remove(&index).unwrap_or_default();
        }
        let fragment = self.fragment(op);
        if matches!(op, Op::Symbol(_)) && is_name(&fragment.text) {
            return fragment;
        }
        let again = self.uses[index] > 1 && !matches!(op, Op::Number(_));
        let reads_symbol = matches!(op, Op::Symbol(_)) && !(self.uses[index] == 1 && self.is_result[index]);
        let is_named = match self.known_names {
            Some(named) => named[index],
            None => again || reads_symbol || fragment.terms > MOST_TERMS,
        };
        if is_named { self.bind(index, fragment) } else { fragment }
    }

    /// The argument `a` of the root of `max(0, a)`, where numbers below zero are refused by `DIRECT`.
    fn above_zero(&self, root: Ref) -> Option<Ref> {
        let is_zero = |at: Ref| matches!(self.tape.ops[at.index()].op, Op::Number(0.0));
        match self.tape.ops[root.index()].op {
            Op::Max(zero, a) if self.direct.is_some() && is_zero(zero) && self.uses[root.index()] == 1 => {
                Some(a)
            }
            _ => None,
        }
    }

    /// Gives a value a name.
    fn bind(&mut self, index: usize, fragment: Fragment) -> Fragment {
        self.named[index] = true;
        let hint = self.tape.ops[index].expr.and_then(Expr::name);
        let name = match hint {
            Some(hint) if self.is_general => self.names.unique(&without_numbers(&hint)),
            Some(hint) => self.names.unique(&hint),
            None => self.names.numbered("t"),
        };
        let local = self.named(name);
        let (pattern, makes) = (local.text.clone(), local.reads.clone());
        if let (Op::Symbol(_), Some((array, element))) = (self.tape.ops[index].op, element(&fragment.text)) {
            let array = array.to_owned();
            self.lines.statements.push(Statement::Read { local: local.reads[0], array, element });
            return local;
        }
        self.lines.statements.push(Statement::Let {
            makes,
            pattern,
            value: fragment.text,
            reads: fragment.reads,
        });
        local
    }

    /// A new local by the name of a path of the model.
    fn local(&mut self, path: &str) -> Fragment {
        let name = self.names.unique(path);
        self.named(name)
    }

    fn named(&mut self, name: String) -> Fragment {
        self.lines.locals.push(name.clone());
        Fragment { text: name, strength: 4, terms: 1, reads: vec![self.lines.locals.len() - 1] }
    }

    /// Text of an operation on the texts of its operands.
    fn fragment(&self, op: Op) -> Fragment {
        let at = |operand: Ref| &self.fragments[operand.index()];
        match op {
            Op::Number(value) => Fragment::atom(literal(value)),
            Op::Symbol(symbol) => {
                Fragment::atom(self.bindings.get(&symbol).cloned().unwrap_or_else(|| "()".to_owned()))
            }
            Op::Add(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => self.factor(at(x)).called("mul_add", &[at(y), at(a)]),
                (Some([x, y]), None) => self.factor(at(x)).called("mul_add", &[at(y), at(b)]),
                (None, None) => at(a).joined(" + ", at(b), 1),
            },
            Op::Sub(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => self.factor(&self.negative(x)).called("mul_add", &[at(y), at(a)]),
                (Some([x, y]), None) => self.factor(at(x)).called("mul_add", &[at(y), &self.negative(b)]),
                (None, None) => at(a).joined(" - ", at(b), 1),
            },
            Op::Mul(a, b) => self.factor(at(a)).joined(" * ", at(b), 2),
            Op::Div(a, b) => self.factor(at(a)).joined(" / ", at(b), 2),
            Op::Neg(a) => self.negative(a),
            Op::Sqrt(a) => match self.above_zero(a) {
                Some(a) => at(a).called("root_by::<DIRECT>", &[]),
                None => at(a).called("sqrt", &[]),
            },
            Op::Sin(a) => at(a).called("sin", &[]),
            Op::Cos(a) => at(a).called("cos", &[]),
            Op::Asin(a) => at(a).called("asin", &[]),
            Op::Acos(a) => at(a).called("acos", &[]),
            Op::Atan2(y, x) => at(y).called("atan2", &[at(x)]),
            Op::Exp(a) => at(a).called("exp", &[]),
            Op::Ln(a) => at(a).called("ln", &[]),
            Op::Abs(a) => at(a).called("abs", &[]),
            Op::Sign(a) => at(a).called("signum0", &[]),
            Op::Floor(a) => at(a).called("floor", &[]),
            Op::Min(a, b) => at(a).called("min", &[at(b)]),
            Op::Max(a, b) => at(a).called("max", &[at(b)]),
            Op::Less(a, b) => at(a).called("lt", &[at(b)]),
            Op::Select(c, a, b) => {
                Fragment::call(&format!("{}::select", self.scalar), &[at(c), at(a), at(b)])
            }
        }
    }

    /// The text of an operand that multiplies or is divided.
    fn factor(&self, operand: &Fragment) -> Fragment {
        match self.constants {
            Constants::Numbers => operand.clone(),
            Constants::Factors => operand.as_factor(),
        }
    }

    /// The factors of a product that stands where it is used. With its sum it makes a `mul_add`, which has the bits of
    /// product and sum, or fewer roundings with the feature `fma`: sums commute, and signs of factors pass through.
    fn product(&self, at: Ref) -> Option<[Ref; 2]> {
        match self.tape.ops[at.index()].op {
            Op::Mul(x, y) if self.fragments[at.index()].strength == 2 => Some([x, y]),
            _ => None,
        }
    }

    fn negative(&self, at: Ref) -> Fragment {
        match self.tape.ops[at.index()].op {
            Op::Number(value) => Fragment::atom(literal(-value)),
            _ => self.fragments[at.index()].negated(),
        }
    }

    fn store(&mut self, place: &Place, value: usize) {
        let fragment = self.fragments[value].clone();
        let place = match place {
            Place::Value => {
                self.lines.value = Some((fragment.text, fragment.reads));
                return;
            }
            Place::Element(array, i) => format!("{array}[{i}]"),
            Place::Entry(matrix, i, j) => format!("{matrix}[{i}][{j}]"),
            Place::Path(path) => path.clone(),
            Place::Rows(place) => place.to_string(),
        };
        self.lines.statements.push(Statement::Store { place, value: fragment.text, reads: fragment.reads });
    }

    /// Some values are what the function returns, as an array.
    fn list(&mut self, values: &[usize]) {
        let fragments = values.iter().map(|&value| &self.fragments[value]);
        let (texts, reads): (Vec<&str>, Vec<&[usize]>) =
            fragments.map(|fragment| (fragment.text.as_str(), fragment.reads.as_slice())).unzip();
        self.lines.value = Some((format!("[{}]", texts.join(", ")), reads.concat()));
    }

    fn finish(mut self) -> Lines {
        while let Some(Statement::Title(_)) = self.lines.statements.last() {
            self.lines.statements.pop();
        }
        self.lines
    }
}

/// A name without the numbers in it.
fn without_numbers(name: &str) -> String {
    let rest: String = name.chars().filter(|letter| !letter.is_ascii_digit()).collect();
    if rest.contains(char::is_alphabetic) { rest } else { name.to_owned() }
}

/// Is this a name by itself?
fn is_name(text: &str) -> bool {
    text.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
}

/// Array and element of `x[3]` or `self.x[3]`.
fn element(text: &str) -> Option<(&str, usize)> {
    let (array, element) = text.strip_suffix(']')?.split_once('[')?;
    Some((array, element.parse().ok()?)).filter(|_| array.split('.').all(is_name))
}

/// How often the results, and what they need, read each instruction; what is `known` needs nothing.
pub(crate) fn uses(tape: &Tape, results: &[usize], known: &SortedMap<usize, String>) -> Vec<u32> {
    let mut uses = vec![0; tape.ops.len()];
    for &result in results {
        uses[result] += 1;
    }
    for (index, instruction) in tape.ops.iter().enumerate().rev() {
        if uses[index] > 0 && !known.contains_key(&index) {
            for operand in instruction.op.operands() {
                uses[operand.index()] += 1;
            }
        }
    }
    uses
}
