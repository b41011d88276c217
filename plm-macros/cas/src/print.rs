//! Expressions as people write them: `b.x - a.x + 0.5*cos(b.angle)`, `x*y/(2*z)`, with as few parentheses as
//! the meaning allows.

use core::fmt;

use crate::graph::Graph;
use crate::node::{Expr, Node};
use crate::number::Number;

/// How tightly the place binds for which a fragment of text is made.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Place {
    /// Whole line, function argument.
    Open,
    /// Term of a sum.
    Term,
    /// Factor of a product.
    Factor,
    /// Base of a power, divisor.
    Base,
}

/// Text that is still to be written; the last one comes first.
enum Pending {
    Text(String),
    Node(Expr, Place),
    /// `coefficient * e`, the coefficient not negative.
    Scaled(Number, Expr, Place),
}

/// Text of an expression, made by [`Graph::display`].
pub struct Infix<'a> {
    graph: &'a Graph,
    e: Expr,
}

/// Beyond this many bytes the text ends in "...": a shared graph can be exponentially longer when written out.
const LONGEST: usize = 10_000;

impl Graph {
    /// The expression in infix form. Atoms stand by their names; sums begin with a positive term if they have one.
    pub fn display(&self, e: Expr) -> Infix<'_> {
        Infix { graph: self, e }
    }
}

impl fmt::Display for Infix<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut pending = vec![Pending::Node(self.e, Place::Open)];
        let mut written = 0;
        while let Some(next) = pending.pop() {
            match next {
                Pending::Text(text) => {
                    written += text.len();
                    f.write_str(&text)?;
                }
                Pending::Node(e, place) => self.node(e, place, &mut pending),
                Pending::Scaled(coefficient, e, place) => self.product(coefficient, e, place, &mut pending),
            }
            if written > LONGEST {
                return f.write_str("...");
            }
        }
        Ok(())
    }
}

impl Infix<'_> {
    fn node(&self, e: Expr, place: Place, pending: &mut Vec<Pending>) {
        let start = pending.len();
        match self.graph.node(e) {
            Node::Symbol | Node::Defined(_) => {
                pending.push(Pending::Text(self.graph.name(e).unwrap_or("_").to_owned()));
            }
            Node::Number(value) => number(*value, place, pending),
            Node::Sum { constant, terms } => self.sum(*constant, terms, place, pending),
            Node::Product(_) => self.product(Number::ONE, e, place, pending),
            Node::Call(function, arguments) => {
                pending.push(Pending::Text(format!("{function}(")));
                for (i, &argument) in arguments.iter().enumerate() {
                    if i > 0 {
                        pending.push(Pending::Text(", ".to_owned()));
                    }
                    pending.push(Pending::Node(argument, Place::Open));
                }
                pending.push(Pending::Text(")".to_owned()));
                pending[start..].reverse();
            }
            Node::Less(a, b) => {
                let (a, b) = (Pending::Node(*a, Place::Term), Pending::Node(*b, Place::Term));
                pending.extend([a, Pending::Text(" < ".to_owned()), b]);
                enclose(place > Place::Open, start, pending);
            }
            Node::Select(condition, a, b) => {
                pending.push(Pending::Text("if ".to_owned()));
                pending.push(Pending::Node(*condition, Place::Open));
                pending.push(Pending::Text(" then ".to_owned()));
                pending.push(Pending::Node(*a, Place::Open));
                pending.push(Pending::Text(" else ".to_owned()));
                pending.push(Pending::Node(*b, Place::Open));
                enclose(place > Place::Open, start, pending);
            }
        }
    }

    fn sum(&self, constant: Number, terms: &[(Number, Expr)], place: Place, pending: &mut Vec<Pending>) {
        let start = pending.len();
        if let [(coefficient, inner)] = *terms
            && constant.is_zero()
        {
            return self.scaled(coefficient, inner, place, pending);
        }
        signed_terms(Number::ONE, constant, terms, pending);
        enclose(place > Place::Open, start, pending);
    }

    /// A single scaled term. A negated sum is written with its signs turned.
    fn scaled(&self, coefficient: Number, inner: Expr, place: Place, pending: &mut Vec<Pending>) {
        let start = pending.len();
        match self.graph.node(inner) {
            Node::Sum { constant, terms }
                if coefficient.is_minus_one()
                    && (constant.is_negative() || terms.iter().any(|t| t.0.is_negative())) =>
            {
                signed_terms(coefficient, *constant, terms, pending);
                enclose(place > Place::Open, start, pending);
            }
            _ if coefficient.is_negative() => {
                pending.push(Pending::Text("-".to_owned()));
                pending.push(Pending::Scaled(-coefficient, inner, Place::Term));
                enclose(place > Place::Open, start, pending);
            }
            _ => self.product(coefficient, inner, place, pending),
        }
    }

    /// `coefficient * e` as one fraction.
    fn product(&self, coefficient: Number, e: Expr, place: Place, pending: &mut Vec<Pending>) {
        let start = pending.len();
        let single = [(e, 1)];
        let factors = match self.graph.node(e) {
            Node::Product(factors) => &**factors,
            _ => &single,
        };
        let (mut above, mut below) = (Vec::new(), Vec::new());
        if !coefficient.is_one() {
            let divided = factors.iter().any(|f| f.1 < 0);
            let (numerator, denominator) = match coefficient {
                Number::Exact { num: 1, den, pi: 0 } if divided => ("1".to_owned(), Some(den.to_string())),
                other => other.fraction_text(),
            };
            if numerator != "1" {
                above.push((Pending::Text(numerator), 1));
            }
            below.extend(denominator.map(|text| (Pending::Text(text), 1)));
        }
        for &(factor, exponent) in factors {
            let side = if exponent > 0 { &mut above } else { &mut below };
            side.push((Pending::Node(factor, Place::Factor), exponent.unsigned_abs()));
        }
        if above.is_empty() {
            above.push((Pending::Text("1".to_owned()), 1));
        }
        if let ([(Pending::Node(e, inner), 1)], []) = (&mut above[..], &below[..]) {
            *inner = place; // nothing but the expression itself
            let e = *e;
            return self.node(e, place, pending);
        }
        let many = below.len() > 1;
        push_factors(above, pending);
        if !below.is_empty() {
            pending.push(Pending::Text(if many { "/(" } else { "/" }.to_owned()));
            if let ([(Pending::Node(_, place), _)], false) = (&mut below[..], many) {
                *place = Place::Base;
            }
            push_factors(below, pending);
            if many {
                pending.push(Pending::Text(")".to_owned()));
            }
        }
        enclose(place >= Place::Factor, start, pending);
    }
}

fn number(number: Number, place: Place, pending: &mut Vec<Pending>) {
    let start = pending.len();
    let text = number.to_string();
    let compound = number.is_negative() || text.contains(['/', '*', '^']);
    pending.push(Pending::Text(text));
    enclose(compound && place >= Place::Factor, start, pending);
}

/// Terms in order, the first positive one at the front, the constant at the end. In reading order.
fn signed_terms(sign: Number, constant: Number, terms: &[(Number, Expr)], pending: &mut Vec<Pending>) {
    let mut summands: Vec<(Number, Option<Expr>)> = terms.iter().map(|&(c, e)| (sign * c, Some(e))).collect();
    if !constant.is_zero() {
        summands.push((sign * constant, None));
    }
    if let Some(first) = summands.iter().position(|summand| !summand.0.is_negative()) {
        summands[..=first].rotate_right(1);
    }
    for (i, (coefficient, term)) in summands.into_iter().enumerate() {
        let text = match (i, coefficient.is_negative()) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        pending.push(Pending::Text(text.to_owned()));
        pending.push(match term {
            Some(term) => Pending::Scaled(coefficient.abs(), term, Place::Term),
            None => Pending::Text(coefficient.abs().to_string()),
        });
    }
}

fn push_factors(factors: Vec<(Pending, u32)>, pending: &mut Vec<Pending>) {
    for (i, (factor, exponent)) in factors.into_iter().enumerate() {
        if i > 0 {
            pending.push(Pending::Text("*".to_owned()));
        }
        match (factor, exponent) {
            (factor, 1) => pending.push(factor),
            (Pending::Node(e, _), _) => {
                pending.push(Pending::Node(e, Place::Base));
                pending.push(Pending::Text(format!("^{exponent}")));
            }
            (other, _) => pending.push(other),
        }
    }
}

/// Puts what was pushed since `start` in parentheses if asked to, and turns it into the order of a stack.
fn enclose(parentheses: bool, start: usize, pending: &mut Vec<Pending>) {
    if parentheses {
        pending.insert(start, Pending::Text("(".to_owned()));
        pending.push(Pending::Text(")".to_owned()));
    }
    pending[start..].reverse();
}
