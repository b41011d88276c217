//! Formulas as trees of what is written: sums with signs, fractions, powers, functions.

use crate::collect::CollectVec;
use plm_cas::{Expr, Function, Node, Number};

use super::name::{Name, Names};

/// Nodes that lie deeper are not written: nobody reads them, and the writers recurse.
const DEEPEST: usize = 60;

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Formula {
    Number(String),
    Name(Name),
    /// Terms, and whether each is subtracted.
    Sum(Vec<(bool, Formula)>),
    Product(Vec<Formula>),
    Fraction(Box<Formula>, Box<Formula>),
    Power(Box<Formula>, u32),
    Call(Function, Vec<Formula>),
    /// Values by a condition: `a < b`, the value where it holds, and the other one.
    Cases(Box<[Formula; 4]>),
    /// More than is written.
    Ellipsis,
}

/// A formula with its sign: is it subtracted?
pub(super) type Signed = (bool, Formula);

/// Makes formulas of expressions of the present graph.
pub(super) struct Writer<'a> {
    names: &'a Names,
}

impl Writer<'_> {
    pub(super) fn new(names: &Names) -> Writer<'_> {
        Writer { names }
    }

    pub(super) fn name(&self, symbol: Expr) -> Name {
        self.names.of(symbol)
    }

    /// The terms of an expression.
    pub(super) fn terms(&self, of: Expr) -> Vec<Signed> {
        match self.signed(of, 0) {
            (false, Formula::Sum(terms)) => terms,
            (true, Formula::Sum(terms)) => {
                terms.into_iter().map(|(minus, term)| (!minus, term)).collect_vec()
            }
            one => vec![one],
        }
    }

    /// An expression with its sign.
    pub(super) fn signed(&self, of: Expr, depth: usize) -> Signed {
        if depth > DEEPEST {
            return (false, Formula::Ellipsis);
        }
        match of.node() {
            Node::Number(number) => (number.is_negative(), fraction(vec![], vec![], number.abs())),
            Node::Symbol => (false, Formula::Name(self.names.of(of))),
            Node::Defined(value) => self.signed(value, depth + 1),
            Node::Sum { constant, terms } => self.sum(constant, &terms, depth),
            Node::Product(factors) => (false, self.product(Number::ONE, &factors, depth)),
            Node::Call(function, arguments) => {
                let arguments = arguments.iter().map(|&argument| self.whole(argument, depth + 1));
                (false, Formula::Call(function, arguments.collect_vec()))
            }
            Node::Select(condition, yes, no) => {
                let Node::Less(a, b) = condition.node() else { return (false, Formula::Ellipsis) };
                let parts = [a, b, yes, no].map(|part| self.whole(part, depth + 1));
                (false, Formula::Cases(Box::new(parts)))
            }
            Node::Less(..) => (false, Formula::Ellipsis),
        }
    }

    /// An expression with its sign in front of it.
    fn whole(&self, of: Expr, depth: usize) -> Formula {
        match self.signed(of, depth) {
            (false, formula) => formula,
            (true, Formula::Sum(terms)) => {
                Formula::Sum(terms.into_iter().map(|(minus, term)| (!minus, term)).collect_vec())
            }
            signed => Formula::Sum(vec![signed]),
        }
    }

    /// The first positive term stands in front, the constant at the end.
    fn sum(&self, constant: Number, terms: &[(Number, Expr)], depth: usize) -> Signed {
        let mut signed =
            terms.iter().map(|&(coefficient, term)| self.scaled(coefficient, term, depth + 1)).collect_vec();
        if let (true, [_]) = (constant.is_zero(), &signed[..]) {
            return signed.remove(0);
        }
        if !constant.is_zero() {
            signed.push((constant.is_negative(), fraction(vec![], vec![], constant.abs())));
        }
        if let Some(first) = signed.iter().position(|(minus, _)| !minus) {
            signed[..=first].rotate_right(1);
        }
        (false, Formula::Sum(signed))
    }

    fn scaled(&self, coefficient: Number, term: Expr, depth: usize) -> Signed {
        let (minus, size) = (coefficient.is_negative(), coefficient.abs());
        match term.node() {
            Node::Product(factors) => (minus, self.product(size, &factors, depth)),
            _ if size.is_one() => {
                let (inner, formula) = self.signed(term, depth);
                (minus != inner, formula)
            }
            _ => (minus, self.product(size, &[(term, 1)], depth)),
        }
    }

    /// Numbers in front, then names, the time, sums, rates, and functions.
    fn product(&self, size: Number, factors: &[(Expr, i32)], depth: usize) -> Formula {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for &(factor, exponent) in factors {
            let formula = self.whole(factor, depth + 1);
            let order = order(&formula);
            let power = exponent.unsigned_abs();
            let formula = if power == 1 { formula } else { Formula::Power(Box::new(formula), power) };
            if exponent > 0 { &mut above } else { &mut below }.push((order, formula));
        }
        for side in [&mut above, &mut below] {
            side.sort_by_key(|(order, _)| *order);
        }
        let bare = |side: Vec<(i32, Formula)>| side.into_iter().map(|(_, formula)| formula).collect_vec();
        fraction(bare(above), bare(below), size)
    }
}

/// The place of a factor among others.
fn order(factor: &Formula) -> i32 {
    match factor {
        Formula::Number(_) => 0,
        Formula::Name(name) if name.dots > 0 => 4,
        Formula::Name(name) if name.base == "t" && name.below.is_empty() => 2,
        Formula::Name(_) => 1,
        Formula::Sum(_) => 3,
        _ => 5,
    }
}

/// `size * above / below`; the size is not negative.
fn fraction(mut above: Vec<Formula>, mut below: Vec<Formula>, size: Number) -> Formula {
    let text = match size {
        // Among letters a share is a fraction, among numbers a decimal.
        Number::Exact { num, den: den @ 2..=12, pi: 0 } if above.iter().any(is_letter) => {
            format!("{num}/{den}")
        }
        _ => size.to_string(),
    };
    let (number, divisor) = text.split_once('/').map_or((text.as_str(), None), |(a, b)| (a, Some(b)));
    if let (Some(divisor), true, false) = (divisor, below.is_empty(), above.is_empty()) {
        let share =
            Formula::Fraction(Box::new(numbers(number)), Box::new(numbers(divisor.trim_matches(['(', ')']))));
        above.insert(0, share);
        return product(above);
    }
    if number != "1" || above.is_empty() {
        above.insert(0, numbers(number));
    }
    if let Some(divisor) = divisor {
        below.insert(0, numbers(divisor.trim_matches(['(', ')'])));
    }
    let above = product(above);
    if below.is_empty() { above } else { Formula::Fraction(Box::new(above), Box::new(product(below))) }
}

/// Does a letter stand in a factor that is no coordinate's rate?
fn is_letter(factor: &Formula) -> bool {
    match factor {
        Formula::Name(name) => name.dots == 0,
        Formula::Power(base, _) => is_letter(base),
        _ => false,
    }
}

/// `3*pi` of the algebra's text of a number.
fn numbers(text: &str) -> Formula {
    let one = |part: &str| match part.split_once('^') {
        Some(("pi", power)) => Formula::Power(Box::new(pi()), power.parse().unwrap_or(1)),
        _ if part == "pi" => pi(),
        _ => Formula::Number(part.to_owned()),
    };
    product(text.split('*').map(one).collect_vec())
}

fn pi() -> Formula {
    Formula::Name(Name { base: "pi".to_owned(), below: Vec::new(), dots: 0 })
}

/// A product of several factors, or the only one.
pub(super) fn product(mut factors: Vec<Formula>) -> Formula {
    if factors.len() == 1 {
        return factors.remove(0);
    }
    let is_one = |factor: &Formula| *factor == Formula::Number("1".to_owned());
    factors.retain(|factor| !is_one(factor));
    if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
}
