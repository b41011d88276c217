//! Uses of parts.

use proc_macro2::Delimiter;
use syn::{Token, token};

use super::body::share_unit;
use super::expr::{Expr, ExprKind};
use super::input::{Input, Reported, Result};
use super::name::{Ident, IndexedName};
use crate::span::Span;

/// The use of a part.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Name of the definition.
    pub kind: Ident,
    /// Its own name.
    pub name: IndexedName,
    /// Ports that it is connected to.
    pub arguments: Vec<Expr>,
    /// Its parameters, and starts of its states.
    pub fields: Vec<Field>,
}

/// `name: expr, locked;` in the use of a part; `part.name: expr;` reaches into the parts that it contains. A function has its
/// arguments after the name, `lift(angle): expr;`, and points are a list, `corners: (0, 0), (1, 0) m;`.
#[derive(Clone, Debug)]
pub struct Field {
    /// Path of the value that is set, segment by segment.
    pub path: Vec<IndexedName>,
    /// Names of the arguments of a function.
    pub arguments: Vec<IndexedName>,
    /// To what.
    pub value: Expr,
    /// The other points of a list.
    pub others: Vec<Expr>,
    /// Is it the start of a state that is locked?
    pub locked: Option<Span>,
}

impl Instance {
    /// `kind name(args);` or `kind name(args) { fields }`
    pub(super) fn parse(input: Input) -> Result<Instance> {
        let kind = Ident::parse(input, "the name of a part")?;
        let name = IndexedName::parse(input, "a name")?;
        if kind.text == "start" && input.peek(Token![.]) {
            return Err(input.start_beside_its_body(kind.span, name.ident.span));
        }
        let start = input.position();
        let arguments = Expr::arguments(input)
            .unwrap_or_else(|Reported| vec![Expr { kind: ExprKind::Unknown, span: input.span_from(start) }]);
        let mut fields = Vec::new();
        if input.peek(token::Brace) {
            fields = input.group(Delimiter::Brace, "`{`", |input| Ok(input.all(Field::parse)))?;
            input.eat(Token![;]);
        } else if input.peek(Token![:]) {
            input.parameters_without_braces(&kind.text, &name.ident.text);
        } else {
            input.semicolon()?;
        }
        Ok(Instance { kind, name, arguments, fields })
    }
}

impl Field {
    /// `name.name: expr, locked;`, `name(argument): expr;` or `name: expr, expr;`
    fn parse(input: Input) -> Result<Field> {
        input.docs();
        let start = input.position();
        let mut path = vec![IndexedName::parse(input, "the name of a parameter")?];
        while input.eat(Token![.]) {
            path.push(IndexedName::parse(input, "the name of a parameter")?);
        }
        let text = input.text_of(input.span_from(start));
        let mut arguments = Vec::new();
        if input.peek(token::Paren) {
            let names = |input: Input| input.terminated(|input| IndexedName::parse(input, "an argument"));
            arguments = input.group(Delimiter::Parenthesis, "`(`", names)?;
        }
        input.colon_of(&text)?;
        let mut values = vec![Expr::value(input)];
        while input.peek(Token![,]) && input.peek2(token::Paren) {
            input.advance();
            values.push(Expr::value(input));
        }
        let locked = input.locked()?;
        if let Some(last) = values.last() {
            input.end_of(last)?;
        }
        share_unit(&mut values);
        let others = values.split_off(1);
        let value = values.pop().unwrap_or(Expr { kind: ExprKind::Unknown, span: input.span_from(start) });
        Ok(Field { path, arguments, value, others, locked })
    }

    /// All of its path.
    pub fn span(&self) -> Span {
        let first = self.path.first().map(|name| name.ident.span);
        let last = self.path.last().map(|name| name.ident.span);
        first.zip(last).map_or(self.value.span, |(first, last)| first.to(last))
    }
}
