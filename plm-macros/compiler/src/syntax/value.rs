//! Values with a name: parameters, inputs and states; `let` and `rate`.

use syn::Token;

use super::expr::Expr;
use super::input::{Input, Result};
use super::keyword as kw;
use super::name::IndexedName;
use super::unit::declared_unit;
use crate::diag::Code;
use crate::span::Span;
use crate::units::DisplayUnit;

/// `name: unit = expr` of a param, an input or a state.
#[derive(Clone, Debug)]
pub struct Value {
    /// Its name.
    pub name: IndexedName,
    /// Its unit, if it is written.
    pub unit: Option<DisplayUnit>,
    /// Its default or start, if it is written.
    pub value: Option<Expr>,
    /// A state that a search for an equilibrium must leave alone?
    pub locked: bool,
    /// Span of the word `optional` after a parameter or an input: it need not be set.
    pub optional: Option<Span>,
}

/// The word that may stand after a value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Mark {
    /// Of a state.
    Locked,
    /// Of a parameter or an input.
    Optional,
}

impl Value {
    /// `name: unit = expr;`, with the word `, locked` or `, optional` that it may have.
    pub(super) fn parse(input: Input, mark: Option<Mark>) -> Result<Value> {
        let name = IndexedName::parse(input, "a name")?;
        let start = input.position();
        let mut unit = None;
        if input.eat(Token![:]) {
            let Ok(found) = declared_unit(input) else {
                let value = Expr::unknown(input, start);
                input.end_of(&value)?;
                return Ok(Value { name, unit, value: Some(value), locked: false, optional: None });
            };
            unit = Some(found);
        }
        let value = input.eat(Token![=]).then(|| Expr::value(input));
        let locked = mark == Some(Mark::Locked) && input.locked()?.is_some();
        let optional =
            if mark == Some(Mark::Optional) { input.marked(kw::optional, "`optional`")? } else { None };
        if let (Some(span), Some(_)) = (optional, &value) {
            let message = format!("`{}` has a default, and so need not be set", name.ident.text);
            input
                .error(Code::MisplacedItem, span, message)
                .help("leave `optional` out; `given` tells of any parameter whether the use sets it");
        }
        match &value {
            Some(value) => input.end_of(value)?,
            None => input.semicolon()?,
        }
        Ok(Value { name, unit, value, locked, optional })
    }
}

/// `name = expr;` after `let` or `rate`.
pub(super) fn named(input: Input, word: &str) -> Result<(IndexedName, Expr)> {
    input.skip_mut();
    let name = IndexedName::parse(input, "a name")?;
    input.skip_unit_of(word)?;
    input.expect(Token![=], "`=`")?;
    Ok((name, input.last_value()?))
}

impl Input<'_> {
    /// `, locked`, if it stands here.
    pub(super) fn locked(self) -> Result<Option<Span>> {
        self.marked(kw::locked, "`locked`")
    }

    /// A word after a comma, if there is one.
    fn marked<T: syn::parse::Peek>(self, word: T, what: &str) -> Result<Option<Span>> {
        if !self.eat(Token![,]) {
            return Ok(None);
        }
        let span = self.here();
        self.expect(word, what)?;
        Ok(Some(span))
    }
}
