//! Expressions as lists in prefix form, `(+ (* 2 x) (sin y))`: the notation of the table of rules and of tests.
//!
//! Printed text reads back to the same node. A name reads as the first atom of that name, or as a new symbol.

use core::fmt;

use crate::graph::Graph;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

/// Error of a text in prefix form.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseError(String);

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl core::error::Error for ParseError {}

/// Text and nodes that are still to be written.
enum Pending {
    Text(String),
    Node(Expr),
}

impl Graph {
    /// The expression in prefix form, written out in full.
    pub fn sexpr(&self, e: Expr) -> String {
        let mut text = String::new();
        let mut pending = vec![Pending::Node(e)];
        while let Some(next) = pending.pop() {
            match next {
                Pending::Text(token) => text.push_str(&token),
                Pending::Node(e) => {
                    let start = pending.len();
                    self.push_list(e, &mut pending);
                    pending[start..].reverse();
                }
            }
        }
        text
    }

    /// One node in reading order.
    fn push_list(&self, e: Expr, pending: &mut Vec<Pending>) {
        let mut list = |head: &str, items: &mut dyn FnMut(&mut Vec<Pending>)| {
            pending.push(Pending::Text(format!("({head}")));
            items(pending);
            pending.push(Pending::Text(")".to_owned()));
        };
        match self.node(e) {
            Node::Number(number) => pending.push(Pending::Text(number_text(*number))),
            Node::Symbol | Node::Defined(_) => {
                pending.push(Pending::Text(self.name(e).unwrap_or("_").to_owned()));
            }
            Node::Sum { constant, terms } => match **terms {
                [(coefficient, term)] if constant.is_zero() => {
                    list("*", &mut |out| scaled(coefficient, term, out));
                }
                _ => list("+", &mut |out| {
                    if !constant.is_zero() {
                        item(Pending::Text(number_text(*constant)), out);
                    }
                    for &(coefficient, term) in &**terms {
                        if coefficient.is_one() {
                            item(Pending::Node(term), out);
                        } else {
                            out.push(Pending::Text(" (*".to_owned()));
                            scaled(coefficient, term, out);
                            out.push(Pending::Text(")".to_owned()));
                        }
                    }
                }),
            },
            Node::Product(factors) => match **factors {
                [(factor, exponent)] => list("^", &mut |out| power(factor, exponent, out)),
                _ => list("*", &mut |out| {
                    for &(factor, exponent) in &**factors {
                        if exponent == 1 {
                            item(Pending::Node(factor), out);
                        } else {
                            out.push(Pending::Text(" (^".to_owned()));
                            power(factor, exponent, out);
                            out.push(Pending::Text(")".to_owned()));
                        }
                    }
                }),
            },
            Node::Call(function, arguments) => list(function.name(), &mut |out| {
                arguments.iter().for_each(|&argument| item(Pending::Node(argument), out));
            }),
            Node::Less(a, b) => {
                list("<", &mut |out| [*a, *b].map(Pending::Node).into_iter().for_each(|p| item(p, out)));
            }
            Node::Select(c, a, b) => {
                list("if", &mut |out| [*c, *a, *b].map(Pending::Node).into_iter().for_each(|p| item(p, out)));
            }
        }
    }

    /// Reads an expression in prefix form.
    ///
    /// Operators: `+ - * / ^ < if`, the functions by name, `tan`; atoms: decimals, fractions such as `-1/3`, `pi`,
    /// rounded numbers such as `~0.1`, names.
    ///
    /// # Errors
    /// Unbalanced parentheses, an unknown operator, a wrong number of operands, or a `^` without an integer.
    pub fn parse_sexpr(&mut self, text: &str) -> Result<Expr, ParseError> {
        let spaced = text.replace('(', " ( ").replace(')', " ) ");
        let mut open: Vec<(&str, Vec<Expr>)> = vec![("", Vec::new())];
        let mut head_follows = false;
        for token in spaced.split_whitespace() {
            match token {
                "(" => head_follows = true,
                ")" => {
                    let (head, operands) = open.pop().unwrap_or_default();
                    let value = self.apply(head, &operands)?;
                    open.last_mut().ok_or_else(|| error(")", "closes nothing"))?.1.push(value);
                }
                head if head_follows => {
                    open.push((head, Vec::new()));
                    head_follows = false;
                }
                atom => {
                    let value = self.atom(atom);
                    if let Some((_, operands)) = open.last_mut() {
                        operands.push(value);
                    }
                }
            }
        }
        match &open[..] {
            [("", values)] if values.len() == 1 && !head_follows => Ok(values[0]),
            _ => Err(error(text, "is not one complete expression")),
        }
    }

    fn atom(&mut self, text: &str) -> Expr {
        if let Some(Ok(rounded)) = text.strip_prefix('~').map(str::parse) {
            return self.number(Number::from_f64(rounded));
        }
        let fraction = text
            .split_once('/')
            .and_then(|(num, den)| Number::parse_decimal(num)?.div(Number::parse_decimal(den)?));
        if let Some(number) = fraction.or_else(|| Number::parse_decimal(text)) {
            return self.number(number);
        }
        match text {
            "pi" => self.pi(),
            name => self.find_name(name).unwrap_or_else(|| self.symbol(name)),
        }
    }

    fn apply(&mut self, head: &str, operands: &[Expr]) -> Result<Expr, ParseError> {
        Ok(match (head, operands) {
            ("+", _) => self.sum(operands),
            ("*", _) => self.product(operands),
            ("-", &[a]) => self.neg(a),
            ("-", &[a, b]) => self.sub(a, b),
            ("/", &[a, b]) => self.div(a, b),
            ("^", &[a, n]) => {
                let exponent = self.as_number(n).and_then(Number::as_int).and_then(|n| i32::try_from(n).ok());
                self.powi(a, exponent.ok_or_else(|| error(head, "needs an integer exponent"))?)
            }
            ("tan", &[x]) => self.tan(x),
            ("<", &[a, b]) => self.less(a, b),
            ("if", &[c, a, b]) => self.select(c, a, b),
            _ => {
                let named = |f: &Function| f.name() == head && f.arity() == operands.len();
                let function = Function::ALL.into_iter().find(named);
                self.call(
                    function.ok_or_else(|| error(head, "is no operator of so many operands"))?,
                    operands,
                )
            }
        })
    }
}

fn error(what: &str, why: &str) -> ParseError {
    ParseError(format!("`{what}` {why}"))
}

fn item(pending: Pending, out: &mut Vec<Pending>) {
    out.push(Pending::Text(" ".to_owned()));
    out.push(pending);
}

fn scaled(coefficient: Number, term: Expr, out: &mut Vec<Pending>) {
    item(Pending::Text(number_text(coefficient)), out);
    item(Pending::Node(term), out);
}

fn power(base: Expr, exponent: i32, out: &mut Vec<Pending>) {
    item(Pending::Node(base), out);
    item(Pending::Text(exponent.to_string()), out);
}

/// A number as an atom or a list that reads back to it.
fn number_text(number: Number) -> String {
    match number {
        Number::Exact { num, den: 1, pi: 0 } => num.to_string(),
        Number::Exact { num, den, pi: 0 } => format!("{num}/{den}"),
        Number::Exact { num: 1, den: 1, pi: 1 } => "pi".to_owned(),
        Number::Exact { num, den, pi } => format!("(* {num}/{den} (^ pi {pi}))"),
        Number::Float(value) => format!("~{value:e}"),
    }
}
