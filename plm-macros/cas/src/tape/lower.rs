//! From nodes to operations.

use super::plan::{Plan, Treatment};
use super::{Instr, Op, Ref, Tape};
use crate::graph::Graph;
use crate::hash::{Mixer, Table};
use crate::node::{Expr, Function, Node};
use crate::number::Number;

const NONE: Ref = Ref(u32::MAX);

struct Lowering<'g> {
    graph: &'g Graph,
    plan: Plan,
    ops: Vec<Instr>,
    /// Finds the instruction of an operation that is there already.
    memo: Table,
    /// For each node the index of the instruction that computes it, plus one; 0 while there is none. That of a turned
    /// sum, or of a product that carries its sign, computes the negative.
    place: Vec<u32>,
}

pub(super) fn lower(graph: &Graph, roots: &[Expr]) -> Tape {
    let plan = Plan::new(graph, roots);
    let place = vec![0; plan.length()];
    let mut lowering = Lowering { graph, plan, ops: Vec::new(), memo: Table::new(), place };
    let mut outputs = Vec::with_capacity(roots.len());
    for &root in roots {
        lowering.visit(root);
        let at = lowering.at(root);
        lowering.ops[at.index()].uses += 1;
        outputs.push(at);
    }
    Tape { ops: lowering.ops, outputs }
}

impl Lowering<'_> {
    /// Lowers everything below `root`, operands first, from left to right.
    fn visit(&mut self, root: Expr) {
        let mut open = vec![(root, false)];
        while let Some((e, operands_done)) = open.pop() {
            if self.place[e.index()] != 0 {
                continue;
            }
            if operands_done {
                if self.plan.of(e) != Treatment::Absorbed {
                    let at = self.node(e);
                    self.settle(e, at);
                }
                continue;
            }
            open.push((e, true));
            let first = open.len();
            self.graph.node(e).for_each_child(|child| open.push((child, false)));
            open[first..].reverse();
        }
    }

    /// Notes where the value of `e` stands, and for whom the instruction is.
    fn settle(&mut self, e: Expr, at: Ref) {
        self.place[e.index()] = at.0 + 1;
        if matches!(self.plan.of(e), Treatment::Turned | Treatment::Carrier) {
            return; // the instruction holds the negative, which has an expression of its own
        }
        let instr = &mut self.ops[at.index()];
        let atom = |e: Expr| matches!(self.graph.node(e), Node::Symbol | Node::Defined(_));
        if instr.expr.is_none_or(|known| !atom(known) && atom(e)) {
            instr.expr = Some(e);
        }
    }

    fn node(&mut self, e: Expr) -> Ref {
        let graph = self.graph;
        match graph.node(e) {
            Node::Number(number) => self.number(*number),
            Node::Symbol => self.emit(Op::Symbol(e)),
            Node::Defined(value) => self.at(*value),
            Node::Sum { constant, terms } => match **terms {
                [(coefficient, term)] if constant.is_zero() => self.scaled(coefficient, term),
                _ => self.sum(*constant, terms, self.plan.of(e) == Treatment::Turned),
            },
            Node::Product(factors) => self.product(Number::ONE, factors),
            Node::Call(function, arguments) => self.call(*function, arguments),
            Node::Less(a, b) => self.emit(Op::Less(self.at(*a), self.at(*b))),
            Node::Select(condition, a, b) => {
                self.emit(Op::Select(self.at(*condition), self.at(*a), self.at(*b)))
            }
        }
    }

    fn at(&self, e: Expr) -> Ref {
        Ref(self.place[e.index()].wrapping_sub(1)) // nowhere is NONE
    }

    fn number(&mut self, number: Number) -> Ref {
        self.emit(Op::Number(number.to_f64()))
    }

    /// Left to right, beginning with a term that needs no sign.
    fn sum(&mut self, constant: Number, terms: &[(Number, Expr)], turned: bool) -> Ref {
        let first = first_summand(constant, terms, turned);
        let mut total = match terms.get(first) {
            Some(&(coefficient, term)) => self.scaled(if turned { -coefficient } else { coefficient }, term),
            None => self.number(if turned { -constant } else { constant }),
        };
        for (i, &(coefficient, term)) in terms.iter().enumerate() {
            if i != first {
                let (value, opposite) = self.magnitude(coefficient.abs(), term);
                let negative = coefficient.is_negative() != turned;
                total = self.emit(if negative == opposite {
                    Op::Add(total, value)
                } else {
                    Op::Sub(total, value)
                });
            }
        }
        if !constant.is_zero() && first != terms.len() {
            let value = self.number(constant.abs());
            let negative = constant.is_negative() != turned;
            total = self.emit(if negative { Op::Sub(total, value) } else { Op::Add(total, value) });
        }
        total
    }

    /// `coefficient * term` or, if only that is there already, `-coefficient * term` and true.
    fn magnitude(&mut self, coefficient: Number, term: Expr) -> (Ref, bool) {
        if !coefficient.is_one() && self.plan.of(term) == Treatment::Own {
            let product = |lowering: &Self, coefficient: Number| {
                let number = lowering.find(Op::Number(coefficient.to_f64()))?;
                lowering.find(Op::Mul(number, lowering.at(term)))
            };
            if let (None, Some(opposite)) = (product(self, coefficient), product(self, -coefficient)) {
                return (opposite, true);
            }
        }
        (self.scaled(coefficient, term), false)
    }

    /// `coefficient * term`.
    fn scaled(&mut self, coefficient: Number, term: Expr) -> Ref {
        let graph = self.graph;
        match (self.plan.of(term), graph.node(term)) {
            (Treatment::Absorbed, Node::Product(factors)) => self.product(coefficient, factors),
            // The negative is what stands there; only a negation turns its term.
            (Treatment::Turned | Treatment::Carrier, _) => self.at(term),
            _ if coefficient.is_one() => self.at(term),
            _ if coefficient.is_minus_one() => self.emit(Op::Neg(self.at(term))),
            _ => {
                let number = self.number(coefficient);
                self.emit(Op::Mul(number, self.at(term)))
            }
        }
    }

    /// `coefficient * factors` with one division at most.
    fn product(&mut self, coefficient: Number, factors: &[(Expr, i32)]) -> Ref {
        let above = factors.iter().any(|f| f.1 > 0);
        let mut numerator = NONE;
        if !coefficient.is_one() || !above {
            numerator = self.number(coefficient);
        }
        numerator = self.powers(numerator, factors, 1);
        let denominator = self.powers(NONE, factors, -1);
        if denominator == NONE { numerator } else { self.emit(Op::Div(numerator, denominator)) }
    }

    /// Multiplies `product` by the powers whose exponents have the given sign.
    fn powers(&mut self, mut product: Ref, factors: &[(Expr, i32)], sign: i64) -> Ref {
        let exponents =
            || factors.iter().map(|&(factor, n)| (factor, i64::from(n) * sign)).filter(|f| f.1 > 0);
        let common = exponents().fold(0, |divisor, f| gcd(divisor, f.1));
        let together = common > 1 && exponents().count() > 1; // x^2*y^2 = (x*y)^2
        let root = if together { common } else { 1 };
        let mut base = if together { NONE } else { product };
        for (factor, exponent) in exponents() {
            base = self.times_power(base, self.at(factor), exponent / root);
        }
        if together {
            product = self.times_power(product, base, root);
            return product;
        }
        base
    }

    /// `product * base^exponent`: up to cubes one factor after the other, beyond that by squaring.
    fn times_power(&mut self, mut product: Ref, base: Ref, exponent: i64) -> Ref {
        if exponent <= 3 {
            for _ in 0..exponent {
                product = self.times(product, base);
            }
            return product;
        }
        let (mut square, mut left, mut power) = (base, exponent, NONE);
        while left > 0 {
            if left & 1 == 1 {
                power = self.times(power, square);
            }
            left >>= 1;
            if left > 0 {
                square = self.emit(Op::Mul(square, square));
            }
        }
        self.times(product, power)
    }

    fn times(&mut self, product: Ref, factor: Ref) -> Ref {
        if product == NONE { factor } else { self.emit(Op::Mul(product, factor)) }
    }

    fn call(&mut self, function: Function, arguments: &[Expr]) -> Ref {
        let a = self.at(arguments[0]);
        let b = self.at(arguments[arguments.len() - 1]);
        self.emit(match function {
            Function::Sin | Function::Cos => return self.pair(function, arguments[0]),
            Function::Asin => Op::Asin(a),
            Function::Acos => Op::Acos(a),
            Function::Atan2 => Op::Atan2(a, b),
            Function::Sqrt => Op::Sqrt(a),
            Function::Exp => Op::Exp(a),
            Function::Ln => Op::Ln(a),
            Function::Abs => Op::Abs(a),
            Function::Sign => Op::Sign(a),
            Function::Floor => Op::Floor(a),
            Function::Min => Op::Min(a, b),
            Function::Max => Op::Max(a, b),
        })
    }

    /// Sine and cosine of one angle side by side, if both are wanted.
    fn pair(&mut self, wanted: Function, angle: Expr) -> Ref {
        let at = self.at(angle);
        let mut result = NONE;
        for (function, op) in [(Function::Sin, Op::Sin(at)), (Function::Cos, Op::Cos(at))] {
            let node = self.graph.find(&Node::Call(function, [angle].into()));
            let Some(e) = node.filter(|&e| self.plan.of(e) != Treatment::Absent) else { continue };
            let value = self.emit(op);
            self.settle(e, value);
            if function == wanted {
                result = value;
            }
        }
        result
    }

    /// The instruction of an operation that is there already.
    fn find(&self, op: Op) -> Option<Ref> {
        let key = key(op);
        let found = self.memo.find(hash(key), |i| self::key(self.ops[i].op) == key);
        found.map(|i| Ref(i as u32))
    }

    /// The instruction of an operation, found or appended.
    fn emit(&mut self, op: Op) -> Ref {
        if let Some(known) = self.find(op) {
            return known;
        }
        let (operands, count) = op.operand_array();
        for operand in &operands[..count] {
            self.ops[operand.index()].uses += 1;
        }
        self.memo.push(hash(key(op)));
        self.ops.push(Instr { op, expr: None, uses: 0 });
        Ref(self.ops.len() as u32 - 1)
    }
}

/// Index of the summand that a sum begins with: the first positive term, else the constant (the index after the terms),
/// else the first term that can carry the sign in its coefficient, else the first. `turned` reverses all signs.
fn first_summand(constant: Number, terms: &[(Number, Expr)], turned: bool) -> usize {
    for i in 0..terms.len() {
        if terms[i].0.is_negative() == turned {
            return i;
        }
    }
    if !constant.is_zero() {
        return terms.len();
    }
    terms.iter().position(|term| !term.0.abs().is_one()).unwrap_or(0)
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Key by which operations are equal: kind, operands, the bits of a constant.
fn key(op: Op) -> (u64, u64, u64) {
    let two = |a: Ref, b: Ref| u64::from(a.0) << 32 | u64::from(b.0);
    let (operands, _) = op.operand_array();
    let kind = u64::from(op.kind());
    match op {
        Op::Number(value) => (kind, value.to_bits(), 0),
        Op::Symbol(e) => (kind, u64::from(e.0), 0),
        _ => (kind, two(operands[0], operands[1]), u64::from(operands[2].0)),
    }
}

fn hash(key: (u64, u64, u64)) -> u32 {
    let mut mixer = Mixer::new(key.0);
    mixer.word(key.1);
    mixer.word(key.2);
    mixer.finish()
}
