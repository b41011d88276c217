//! From a tape to statements that read as if a person had written them.
//!
//! What is used once stands where it is used, what is used again gets a `let` with the name that derivation gave it.
//! The operations and their order are those of the tape, so that the interpreter is the oracle of the emitted code.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::{Count, Expr, Op, Ref, Tape};

mod blocks;
pub(crate) mod names;
mod piece;
mod statement;

use self::names::Names;
use self::piece::{Piece, literal};
use self::statement::{Lines, Statement};
use crate::formulate::{Function, Place};

/// rustc recurses over the terms of a statement: what has more than these gets a `let`, so that an operation on two
/// such values stays within 16.
const MOST_TERMS: usize = 8;
/// Numbers of angles whose sines and cosines fill a vector.
const WHOLE_VECTORS: [usize; 2] = [8, 4];
/// Two or three angles that are left over go into a vector too where sines are most of the work: up to so many operations
/// an angle. In longer code the way into vectors and back stands on a critical path that has room for sines one by one
/// (per step, in vectors or not: double pendulum 77 ns or 96; four-bar linkage in absolute coordinates 414 or 330).
const SHORT: usize = 40;

/// Source text of every symbol that a function may read, e.g. `x[2]`, `self.damping`.
pub(super) type Bindings = SortedMap<Expr, String>;

/// What surrounds the statements of a function.
pub(super) struct Around<'a> {
    /// The names of its arguments.
    pub(super) reserved: &'a [&'a str],
    /// Arrays among them are references, or values.
    pub(super) by_reference: bool,
    /// Where it has an argument `DIRECT`: angles that this tells of, whether their sines and cosines need no branch.
    pub(super) direct: Option<&'a [Expr]>,
}

/// The statements of a function and its operations.
pub(super) fn statements(function: &Function, bindings: &Bindings, around: &Around) -> (String, Count) {
    let lines = lower(function, bindings, around);
    let count = lines.count;
    (blocks::with_literals(lines, around.by_reference), count)
}

/// An expression as one of Rust: a block where it needs locals.
pub(super) fn inline(expr: Expr, bindings: &Bindings) -> String {
    if let Some(number) = expr.as_number() {
        return literal(number.to_f64());
    }
    let function = Function::of_results(vec![(Place::Value, expr)]);
    let reserved: Vec<&str> = bindings.values().map(String::as_str).chain(["lit"]).collect_vec();
    let around = Around { reserved: &reserved, by_reference: true, direct: None };
    let lines = lower(&function, bindings, &around);
    match (&lines.value, lines.statements.is_empty()) {
        (Some((value, _)), true) => value.clone(),
        _ => format!("{{\n{}}}", blocks::body(&lines, 4)),
    }
}

/// Lowers a function.
fn lower(function: &Function, bindings: &Bindings, around: &Around) -> Lines {
    let tape = function.tape();
    let first_result = tape.outputs.len() - function.results.len();
    let mut lowering = Lowering::new(&tape, first_result, bindings, around);
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
    for (k, (place, _)) in function.results.iter().enumerate() {
        let result = tape.outputs[first_result + k];
        lowering.lower_until((result.index() + 1).max(done));
        done = done.max(result.index() + 1);
        lowering.store(place, result);
    }
    lowering.finish()
}

struct Lowering<'a> {
    tape: &'a Tape,
    bindings: &'a Bindings,
    /// Angles that `DIRECT` tells of.
    direct: Option<&'a [Expr]>,
    names: Names,
    /// How often a result needs each instruction.
    uses: Vec<u32>,
    /// Is the instruction a result by itself?
    is_result: Vec<bool>,
    /// Text of the instructions before `pieces.len()`.
    pieces: Vec<Piece>,
    /// Sines (by instruction) whose angles are coordinates, in groups that are computed together.
    groups: Vec<Vec<usize>>,
    /// What was lowered before its turn.
    early: SortedMap<usize, Piece>,
    lines: Lines,
}

impl<'a> Lowering<'a> {
    fn new(tape: &'a Tape, first_result: usize, bindings: &'a Bindings, around: &Around<'a>) -> Self {
        let &Around { reserved, direct, .. } = around;
        let uses = uses(tape, &tape.outputs[first_result..]);
        let groups = angle_groups(tape, &uses);
        let needed =
            tape.ops.iter().zip(&uses).filter(|(_, uses)| **uses > 0).map(|(instruction, _)| instruction);
        let lines =
            Lines { statements: Vec::new(), value: None, locals: Vec::new(), count: Count::of(needed) };
        let names = Names::with_reserved(reserved);
        let mut is_result = vec![false; tape.ops.len()];
        for result in &tape.outputs[first_result..] {
            is_result[result.index()] = true;
        }
        let pieces = Vec::with_capacity(tape.ops.len());
        let early = SortedMap::new();
        Lowering { tape, bindings, direct, names, uses, is_result, pieces, groups, early, lines }
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
        while self.pieces.len() < end {
            let index = self.pieces.len();
            let piece = if self.uses[index] == 0 { Piece::default() } else { self.lower(index) };
            self.pieces.push(piece);
        }
    }

    fn lower(&mut self, index: usize) -> Piece {
        if let Some(piece) = self.early.remove(&index) {
            return piece;
        }
        let op = self.tape.ops[index].op;
        if let Op::Sin(angle) = op
            && is_pair(self.tape, &self.uses, index)
        {
            self.bind_sines(index, angle);
            return self.early.remove(&index).unwrap_or_default();
        }
        let piece = self.piece(op);
        if matches!(op, Op::Symbol(_)) && is_name(&piece.text) {
            return piece;
        }
        let again = self.uses[index] > 1 && !matches!(op, Op::Number(_));
        let reads_symbol = matches!(op, Op::Symbol(_)) && !(self.uses[index] == 1 && self.is_result[index]);
        if again || reads_symbol || piece.terms > MOST_TERMS { self.bind(index, piece) } else { piece }
    }

    /// Sine and cosine of an angle, with all angles of its group.
    fn bind_sines(&mut self, index: usize, angle: Ref) {
        if let Some(at) = self.groups.iter().position(|group| group.contains(&index)) {
            let sines = self.groups.swap_remove(at);
            self.bind_group(&sines);
            return;
        }
        let by = if self.is_direct(angle) { "sin_cos_by::<DIRECT>" } else { "sin_cos" };
        let angle = self.pieces[angle.index()].clone();
        let (sine, cosine) = self.local_pair(&angle);
        let pattern = format!("({}, {})", sine.text, cosine.text);
        let value = format!("{}.{by}()", angle.within(4));
        let makes = vec![sine.reads[0], cosine.reads[0]];
        self.lines.statements.push(Statement::Let { makes, pattern, value, reads: angle.reads });
        self.early.insert(index, sine);
        self.early.insert(index + 1, cosine);
    }

    /// `let ([sin_a, sin_b], [cos_a, cos_b]) = S::sin_cos_all([a, b]);`
    fn bind_group(&mut self, sines: &[usize]) {
        let (mut makes, mut reads) = (Vec::new(), Vec::new());
        let mut angles = sines.iter().filter_map(|&index| self.tape.ops[index].op.operands().next());
        let by = if angles.all(|angle| self.is_direct(angle)) {
            "sin_cos_all_by::<DIRECT, _>"
        } else {
            "sin_cos_all"
        };
        let mut texts: [Vec<String>; 3] = Default::default();
        for &index in sines {
            let Some(angle) = self.tape.ops[index].op.operands().next() else { continue };
            let angle = self.angle(angle.index());
            let (sine, cosine) = self.local_pair(&angle);
            makes.extend([sine.reads[0], cosine.reads[0]]);
            for (list, piece) in texts.iter_mut().zip([&sine, &cosine, &angle]) {
                list.push(piece.text.clone());
            }
            reads.extend(angle.reads);
            self.early.insert(index, sine);
            self.early.insert(index + 1, cosine);
        }
        let [sines, cosines, angles] = texts.map(|list| list.join(", "));
        let pattern = format!("([{sines}], [{cosines}])");
        let value = format!("S::{by}([{angles}])");
        self.lines.statements.push(Statement::Let { makes, pattern, value, reads });
    }

    /// Is an angle one that `DIRECT` tells of?
    fn is_direct(&self, angle: Ref) -> bool {
        let angles = self.direct.unwrap_or_default();
        matches!(self.tape.ops[angle.index()].op, Op::Symbol(symbol) if angles.contains(&symbol))
    }

    /// What the root of `max(0, a)` is the root of, where numbers below zero are refused by `DIRECT`.
    fn above_zero(&self, root: Ref) -> Option<Ref> {
        let is_zero = |at: Ref| matches!(self.tape.ops[at.index()].op, Op::Number(0.0));
        match self.tape.ops[root.index()].op {
            Op::Max(zero, a) if self.direct.is_some() && is_zero(zero) && self.uses[root.index()] == 1 => {
                Some(a)
            }
            _ => None,
        }
    }

    /// A coordinate, before its turn if need be.
    fn angle(&mut self, index: usize) -> Piece {
        if let Some(piece) = self.pieces.get(index).or_else(|| self.early.get(&index)) {
            return piece.clone();
        }
        let piece = self.piece(self.tape.ops[index].op);
        let bound = self.bind(index, piece);
        self.early.insert(index, bound.clone());
        bound
    }

    fn local_pair(&mut self, angle: &Piece) -> (Piece, Piece) {
        let suffix =
            if angle.strength == 4 && angle.reads.len() == 1 { angle.text.as_str() } else { "angle" };
        (self.local(&format!("sin_{suffix}")), self.local(&format!("cos_{suffix}")))
    }

    /// Gives a value a name.
    fn bind(&mut self, index: usize, piece: Piece) -> Piece {
        let hint = self.tape.ops[index].expr.and_then(Expr::name);
        let name = match hint {
            Some(hint) => self.names.unique(&hint),
            None => self.names.numbered("t"),
        };
        let local = self.named(name);
        let (pattern, makes) = (local.text.clone(), local.reads.clone());
        if let (Op::Symbol(_), Some((array, element))) = (self.tape.ops[index].op, element(&piece.text)) {
            let array = array.to_owned();
            self.lines.statements.push(Statement::Read { local: local.reads[0], array, element });
            return local;
        }
        self.lines.statements.push(Statement::Let { makes, pattern, value: piece.text, reads: piece.reads });
        local
    }

    /// A new local by the name of a path of the model.
    fn local(&mut self, path: &str) -> Piece {
        let name = self.names.unique(path);
        self.named(name)
    }

    fn named(&mut self, name: String) -> Piece {
        self.lines.locals.push(name.clone());
        Piece { text: name, strength: 4, terms: 1, reads: vec![self.lines.locals.len() - 1] }
    }

    /// Text of an operation on the texts of its operands.
    fn piece(&self, op: Op) -> Piece {
        let at = |operand: Ref| &self.pieces[operand.index()];
        match op {
            Op::Number(value) => Piece::atom(literal(value)),
            Op::Symbol(symbol) => {
                Piece::atom(self.bindings.get(&symbol).cloned().unwrap_or_else(|| "()".to_owned()))
            }
            Op::Add(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => at(x).called("mul_add", &[at(y), at(a)]),
                (Some([x, y]), None) => at(x).called("mul_add", &[at(y), at(b)]),
                (None, None) => at(a).joined(" + ", at(b), 1),
            },
            Op::Sub(a, b) => match (self.product(a), self.product(b)) {
                (_, Some([x, y])) => self.negative(x).called("mul_add", &[at(y), at(a)]),
                (Some([x, y]), None) => at(x).called("mul_add", &[at(y), &self.negative(b)]),
                (None, None) => at(a).joined(" - ", at(b), 1),
            },
            Op::Mul(a, b) => at(a).joined(" * ", at(b), 2),
            Op::Div(a, b) => at(a).joined(" / ", at(b), 2),
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
            Op::Min(a, b) => at(a).called("min", &[at(b)]),
            Op::Max(a, b) => at(a).called("max", &[at(b)]),
            Op::Less(a, b) => at(a).called("lt", &[at(b)]),
            Op::Select(c, a, b) => Piece::call("S::select", &[at(c), at(a), at(b)]),
        }
    }

    /// The factors of a product that stands where it is used. With its sum it makes a `mul_add`, which has the bits of
    /// product and sum, or fewer roundings with the feature `fma`: sums commute, and signs of factors pass through.
    fn product(&self, at: Ref) -> Option<[Ref; 2]> {
        match self.tape.ops[at.index()].op {
            Op::Mul(x, y) if self.pieces[at.index()].strength == 2 => Some([x, y]),
            _ => None,
        }
    }

    fn negative(&self, at: Ref) -> Piece {
        match self.tape.ops[at.index()].op {
            Op::Number(value) => Piece::atom(literal(-value)),
            _ => self.pieces[at.index()].negated(),
        }
    }

    fn store(&mut self, place: &Place, value: Ref) {
        let piece = self.pieces[value.index()].clone();
        let place = match place {
            Place::Value => {
                self.lines.value = Some((piece.text, piece.reads));
                return;
            }
            Place::Element(array, i) => format!("{array}[{i}]"),
            Place::Entry(matrix, i, j) => format!("{matrix}[{i}][{j}]"),
            Place::Path(path) => path.clone(),
        };
        self.lines.statements.push(Statement::Store { place, value: piece.text, reads: piece.reads });
    }

    fn finish(mut self) -> Lines {
        while let Some(Statement::Title(_)) = self.lines.statements.last() {
            self.lines.statements.pop();
        }
        self.lines
    }
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

/// Is this a sine that is wanted with the cosine behind it?
fn is_pair(tape: &Tape, uses: &[u32], index: usize) -> bool {
    let next = tape.ops.get(index + 1).map(|next| next.op);
    let same = matches!((tape.ops[index].op, next), (Op::Sin(a), Some(Op::Cos(b))) if a == b);
    same && uses[index] > 0 && uses[index + 1] > 0
}

/// Sines whose angles are inputs of the function, in groups that are computed together.
fn angle_groups(tape: &Tape, uses: &[u32]) -> Vec<Vec<usize>> {
    let of_symbol = |index: &usize| match tape.ops[*index].op {
        Op::Sin(angle) => matches!(tape.ops[angle.index()].op, Op::Symbol(_)) && is_pair(tape, uses, *index),
        _ => false,
    };
    let sines: Vec<usize> = (0..tape.ops.len()).filter(of_symbol).collect_vec();
    let (mut groups, mut rest) = (Vec::new(), sines.as_slice());
    for lanes in WHOLE_VECTORS {
        while let Some((group, others)) = rest.split_at_checked(lanes) {
            groups.push(group.to_vec());
            rest = others;
        }
    }
    if rest.len() > 1 && tape.count().total() <= SHORT * sines.len() {
        groups.push(rest.to_vec());
    }
    groups
}

/// How often the results, and what they need, read each instruction.
fn uses(tape: &Tape, results: &[Ref]) -> Vec<u32> {
    let mut uses = vec![0; tape.ops.len()];
    for result in results {
        uses[result.index()] += 1;
    }
    for (index, instruction) in tape.ops.iter().enumerate().rev() {
        if uses[index] > 0 {
            for operand in instruction.op.operands() {
                uses[operand.index()] += 1;
            }
        }
    }
    uses
}
