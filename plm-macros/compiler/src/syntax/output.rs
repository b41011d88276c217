//! Outputs.

use proc_macro2::Delimiter;
use syn::Token;
use syn::buffer::Cursor;

use super::expr::Expr;
use super::input::{Input, Result};
use super::name::IndexedName;
use super::unit::unit;
use crate::span::Span;
use crate::units::DisplayUnit;

/// One output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name, if it is written; else the path is its name.
    pub name: Option<IndexedName>,
    /// The expression to show.
    pub value: Expr,
    /// In which unit.
    pub unit: Option<(DisplayUnit, Span)>,
}

impl Output {
    /// `expr`, `name = expr`, `expr in unit`
    pub(super) fn parse(input: Input) -> Result<Output> {
        let mut name = None;
        if begins_with_name(input) {
            name = Some(IndexedName::parse(input, "a name")?);
            input.expect(Token![=], "`=`")?;
        }
        let value = Expr::parse(input)?;
        let name = name.or_else(|| input.name_after(&value));
        let mut shown = None;
        if input.eat(Token![in]) {
            let start = input.position();
            shown = Some((unit(input)?, input.span_from(start)));
        }
        Ok(Output { name, value, unit: shown })
    }
}

/// Does `name =` or `name[i] =` stand here?
fn begins_with_name(input: Input) -> bool {
    let mut after = input.cursor().token_tree().map(|(_, after)| after);
    while let Some((_, _, next)) = after.and_then(|cursor| cursor.group(Delimiter::Bracket)) {
        after = Some(next);
    }
    after.and_then(equals).is_some_and(|next| equals(next).is_none())
}

/// The cursor after a `=`.
fn equals(cursor: Cursor) -> Option<Cursor> {
    cursor.punct().filter(|(mark, _)| mark.as_char() == '=').map(|(_, after)| after)
}
