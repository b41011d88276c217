//! Equations of a part: constraint rows, and what acts on its ports.

use syn::Token;
use syn::ext::IdentExt;

use super::expr::Expr;
use super::input::{Input, Result};
use super::item::ItemKind;
use super::keyword as kw;
use super::name::{Ident, IndexedName};
use crate::span::Span;

/// A load on a port: `force` or `torque` on a frame, a through quantity of its domain on a node.
#[derive(Clone, Debug)]
pub struct Load {
    /// Its quantity: `force`, `torque`, `flow`.
    pub quantity: Ident,
    /// On what.
    pub on: Expr,
    /// From what: it feels the opposite.
    pub from: Option<Expr>,
    /// How much.
    pub value: Expr,
    /// The words `force on b from a`.
    pub span: Span,
}

impl Load {
    /// Does `force on name` stand here, and not a part of that name?
    pub(super) fn peek(input: Input) -> bool {
        let is_name = syn::Ident::peek_any;
        input.peek(is_name) && input.peek2(kw::on) && input.peek3(is_name)
    }

    /// `force on b from a: expr;`
    pub(super) fn parse(input: Input) -> Result<Load> {
        let start = input.position();
        let quantity = Ident::parse(input, "what acts")?;
        input.expect(kw::on, "`on`")?;
        let on = Expr::parse(input)?;
        let from = if input.eat(kw::from) { Some(Expr::parse(input)?) } else { None };
        let span = input.span_from(start);
        input.expect(Token![:], "`:`")?;
        let value = Expr::parse(input)?;
        input.semicolon()?;
        Ok(Load { quantity, on, from, value, span })
    }
}

/// `name: left = right;` after `constraint`.
pub(super) fn constraint(input: Input) -> Result<ItemKind> {
    let start = input.position();
    let name = IndexedName::parse(input, "the name of the row")?;
    if [".", "=", "+", "-", "*", "/"].contains(&input.next()) {
        return Err(input.constraint_without_name(start));
    }
    input.expect(Token![:], "`:`")?;
    let left = Expr::parse(input)?;
    let (left, right) = match input.sides_of_equality(left) {
        Ok(sides) => sides,
        Err(left) => {
            input.expect(Token![=], "`= 0`")?;
            (left, Expr::parse(input)?)
        }
    };
    let when = input.condition_of_row()?;
    Ok(ItemKind::Constraint(name, left, right, when))
}
