//! Values with a name: parameters, inputs and states; `let` and `rate`.

use syn::Token;

use super::expr::Expr;
use super::input::{Input, Result};
use super::keyword as kw;
use super::name::IndexedName;
use super::unit::declared_unit;
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
}

impl Value {
    /// `name: unit = expr;`, of a state with `, locked`.
    pub(super) fn parse(input: Input, is_state: bool) -> Result<Value> {
        let name = IndexedName::parse(input, "a name")?;
        let start = input.position();
        let mut unit = None;
        if input.eat(Token![:]) {
            let Ok(found) = declared_unit(input) else {
                let value = Expr::unknown(input, start);
                input.end_of(&value)?;
                return Ok(Value { name, unit, value: Some(value), locked: false });
            };
            unit = Some(found);
        }
        let value = input.eat(Token![=]).then(|| Expr::value(input));
        let locked = is_state && input.locked()?.is_some();
        match &value {
            Some(value) => input.end_of(value)?,
            None => input.semicolon()?,
        }
        Ok(Value { name, unit, value, locked })
    }
}

/// `name = expr;` behind `let` or `rate`.
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
        if !self.eat(Token![,]) {
            return Ok(None);
        }
        let span = self.here();
        self.expect(kw::locked, "`locked`")?;
        Ok(Some(span))
    }
}
