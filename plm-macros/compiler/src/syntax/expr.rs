//! Expressions, by precedence climbing.
//!
//! ```text
//! expr     := "if" expr "then" expr "else" expr | chain
//! chain    := operand { operator operand }      or < and < comparison < + - < * /
//! operand  := ("-" | "+") operand | "not" chain | primary ["^" operand]
//! primary  := (quantity | NAME index | NAME "(" exprs ")" | "(" expr ")") { "." NAME index }
//! quantity := (NUMBER | "pi") [unit] | "(" expr "," expr ")" [unit]
//! index    := { "[" expr "]" }
//! ```
//!
//! A capture of a `macro_rules!` is a primary too, and takes a unit as a number does; so does `pi`.

use plm_cas::Number;
use proc_macro2::{Delimiter, TokenTree};
use syn::ext::IdentExt;
use syn::{Token, token};

use super::input::{Input, Reported, Result};
use super::keyword as kw;
use super::name::{Ident, IndexedName};
use super::operator::Operator;
use super::quantity::quantity;
use super::unit::unit_after_number;
use crate::diag::Code;
use crate::span::Span;
use crate::units::DisplayUnit;

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its kind.
    pub kind: ExprKind,
    /// Its place.
    pub span: Span,
}

/// Forms of expressions.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// An unreadable expression. The mistake is reported; the item keeps its name, so that its uses are no mistakes.
    Unknown,
    /// A bare number.
    Number(Number),
    /// A number or a pair with a unit.
    Quantity(Box<Expr>, DisplayUnit),
    /// `(x, y)`
    Pair(Box<Expr>, Box<Expr>),
    /// `name`, `name[i]`
    Name(IndexedName),
    /// `expr.name.name[i]`
    Path(Box<Expr>, Vec<IndexedName>),
    /// `f(args)`
    Call(Ident, Vec<Expr>),
    /// `-expr`
    Neg(Box<Expr>),
    /// `not expr`
    Not(Box<Expr>),
    /// `base ^ exponent`
    Power(Box<Expr>, Box<Expr>),
    /// `expr op expr op expr …`, operators of one precedence, from left to right. A list and not a tree, so that a
    /// long sum is not deep.
    Chain(Box<Expr>, Vec<Link>),
    /// `if expr then expr else expr`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
}

/// An operator with its right operand.
#[derive(Clone, Debug)]
pub struct Link {
    /// The operator.
    pub operator: Operator,
    /// Its right operand.
    pub operand: Expr,
}

impl Expr {
    /// An expression.
    pub(super) fn parse(input: Input) -> Result<Expr> {
        input.nested(|input| if input.peek(Token![if]) { condition(input) } else { chain(input, 0) })
    }

    /// The value of an item. If it cannot be read, what is left of it is skipped: to a `;` or a `,`.
    pub(super) fn value(input: Input) -> Expr {
        let start = input.position();
        Expr::parse(input).unwrap_or_else(|Reported| Expr::unknown(input, start))
    }

    /// Skips what is left of the value of an item.
    pub(super) fn unknown(input: Input, start: usize) -> Expr {
        input.advance_to(|input| input.peek(Token![;]) || input.peek(Token![,]));
        Expr { kind: ExprKind::Unknown, span: input.span_from(start) }
    }

    /// `(a, b, …)`, also empty.
    pub(super) fn arguments(input: Input) -> Result<Vec<Expr>> {
        input.group(Delimiter::Parenthesis, "`(`", |input| {
            let mut list = Vec::new();
            while !input.is_empty() {
                list.push(Expr::parse(input)?);
                if !input.is_empty() {
                    input.expect(Token![,], "`,` or `)`")?;
                }
            }
            Ok(list)
        })
    }

    /// With the unit after it, if there is one.
    pub(super) fn with_unit(self, input: Input) -> Result<Expr> {
        let start = self.span.first as usize;
        let Some(unit) = unit_after_number(input)? else { return Ok(self) };
        Ok(Expr { kind: ExprKind::Quantity(Box::new(self), unit), span: input.span_from(start) })
    }
}

fn condition(input: Input) -> Result<Expr> {
    let start = input.position();
    input.advance();
    let condition = Expr::parse(input)?;
    if input.peek(token::Brace) {
        return Err(input.expected_but("`then`", "write `if a < b then c else d`"));
    }
    input.expect(kw::then, "`then`")?;
    let yes = Expr::parse(input)?;
    if !input.eat(Token![else]) {
        return Err(input.expected_but("`else`", "there is always a value: `if a < b then c else d`"));
    }
    let no = Expr::parse(input)?;
    let kind = ExprKind::If(Box::new(condition), Box::new(yes), Box::new(no));
    Ok(Expr { kind, span: input.span_from(start) })
}

/// Operands joined by operators that bind at least as tightly as `least`.
fn chain(input: Input, least: u8) -> Result<Expr> {
    let start = input.position();
    let mut left = operand(input)?;
    while let Some(precedence) = Operator::peek(input).map(Operator::precedence).filter(|p| *p >= least) {
        let mut links = Vec::new();
        while let Some(operator) = Operator::peek(input).filter(|of| of.precedence() == precedence) {
            input.take_operator(operator);
            links.push(Link { operator, operand: chain(input, precedence + 1)? });
        }
        if precedence == Operator::Less.precedence() && links.len() > 1 {
            let span = input.span_from(start);
            input
                .error(Code::UnexpectedToken, span, "comparisons do not chain")
                .help("join them with `and`: `a < b and b < c`");
            return Err(Reported);
        }
        left = Expr { kind: ExprKind::Chain(Box::new(left), links), span: input.span_from(start) };
    }
    Ok(left)
}

fn operand(input: Input) -> Result<Expr> {
    let start = input.position();
    if is_captured(input) {
        return powers(input, start);
    }
    if input.eat(Token![-]) {
        let inner = input.nested(operand)?;
        return Ok(Expr { kind: ExprKind::Neg(Box::new(inner)), span: input.span_from(start) });
    }
    if input.eat(Token![+]) {
        return input.nested(operand);
    }
    if input.eat(kw::not) || input.eat_exclamation() {
        // `not a < b` is `not (a < b)`: nothing else of it has a meaning.
        let inner = input.nested(|input| chain(input, Operator::Less.precedence()))?;
        return Ok(Expr { kind: ExprKind::Not(Box::new(inner)), span: input.span_from(start) });
    }
    powers(input, start)
}

fn powers(input: Input, start: usize) -> Result<Expr> {
    let base = primary(input)?;
    if !input.eat_power(start) {
        return Ok(base);
    }
    let exponent = input.nested(operand)?;
    let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
    Ok(Expr { kind, span: input.span_from(start) })
}

fn primary(input: Input) -> Result<Expr> {
    let start = input.position();
    if is_captured(input) {
        return input.group(Delimiter::None, "an expression", Expr::parse)?.with_unit(input);
    }
    if input.peek_number() {
        return quantity(input);
    }
    let base = if input.peek(token::Paren) { parenthesised(input)? } else { name_or_call(input)? };
    if input.peek(Token![::]) {
        return Err(input.path_of_rust(start));
    }
    let mut members = Vec::new();
    while input.peek(Token![.]) && input.peek2(syn::Ident::peek_any) {
        input.advance();
        members.push(IndexedName::parse(input, "a member")?);
    }
    if let Some(method) = members.last().filter(|_| input.peek(token::Paren)) {
        return Err(input.method_call(start, method));
    }
    if members.is_empty() {
        let is_pi =
            matches!(&base.kind, ExprKind::Name(name) if name.ident.text == "pi" && name.indices.is_empty());
        return if is_pi { base.with_unit(input) } else { Ok(base) };
    }
    Ok(Expr { kind: ExprKind::Path(Box::new(base), members), span: input.span_from(start) })
}

/// Does an operation stand here that a `macro_rules!` has captured? It is one operand; a path or a literal is what it
/// is without the invisible brackets.
fn is_captured(input: Input) -> bool {
    let is_operator = |tree| matches!(tree, TokenTree::Punct(mark) if "+-*/<>&|^".contains(mark.as_char()));
    let captured = input.cursor().group(Delimiter::None);
    captured.is_some_and(|(inside, ..)| inside.token_stream().into_iter().any(is_operator))
}

fn name_or_call(input: Input) -> Result<Expr> {
    let start = input.position();
    if !input.peek(syn::Ident::peek_any) {
        return Err(input.expected("an expression"));
    }
    let kind = if input.peek2(token::Paren) {
        ExprKind::Call(Ident::parse(input, "a function")?, Expr::arguments(input)?)
    } else {
        ExprKind::Name(IndexedName::parse(input, "a name")?)
    };
    Ok(Expr { kind, span: input.span_from(start) })
}

/// `(expr)`, which takes no unit, or `(expr, expr)`, which may.
fn parenthesised(input: Input) -> Result<Expr> {
    let start = input.position();
    let (x, y) = input.group(Delimiter::Parenthesis, "`(`", |input| {
        let x = Expr::parse(input)?;
        let y = if input.eat(Token![,]) { Some(Expr::parse(input)?) } else { None };
        if y.is_some() && input.peek(Token![,]) {
            return Err(input.expected_but("the closing bracket", "in the plane a vector has two components"));
        }
        Ok((x, y))
    })?;
    let Some(y) = y else { return Ok(x) };
    let kind = ExprKind::Pair(Box::new(x), Box::new(y));
    Expr { kind, span: input.span_from(start) }.with_unit(input)
}
