//! Functions and lists of points that the use of a part hands over.

use proc_macro2::Delimiter;
use syn::Token;

use super::expr::Expr;
use super::input::{Input, Result};
use super::name::{Ident, IndexedName};
use super::unit::declared_unit;
use crate::units::DisplayUnit;

/// `function name(argument: unit, …): unit = expr;`
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Ident,
    /// Its arguments, with their units.
    pub arguments: Vec<(IndexedName, DisplayUnit)>,
    /// The unit of its value.
    pub unit: DisplayUnit,
    /// The value unless the use says otherwise.
    pub default: Option<Expr>,
}

/// `points name: unit;`
#[derive(Clone, Debug)]
pub struct Points {
    /// Its name.
    pub name: Ident,
    /// The unit of both components.
    pub unit: DisplayUnit,
}

impl Function {
    /// `name(argument: unit, …): unit = expr;` after `function`.
    pub(super) fn parse(input: Input) -> Result<Function> {
        let name = Ident::parse(input, "the name of the function")?;
        let arguments = input.group(Delimiter::Parenthesis, "`(`", |input| {
            input.terminated(|input| {
                let name = IndexedName::parse(input, "the name of an argument")?;
                input.expect(Token![:], "`:`")?;
                Ok((name, declared_unit(input)?))
            })
        })?;
        input.expect(Token![:], "`:`")?;
        let unit = declared_unit(input)?;
        let default = input.eat(Token![=]).then(|| Expr::value(input));
        match &default {
            Some(value) => input.end_of(value)?,
            None => input.semicolon()?,
        }
        Ok(Function { name, arguments, unit, default })
    }
}

impl Points {
    /// `name: unit;` after `points`.
    pub(super) fn parse(input: Input) -> Result<Points> {
        let name = Ident::parse(input, "the name of the points")?;
        input.expect(Token![:], "`:`")?;
        let unit = declared_unit(input)?;
        input.semicolon()?;
        Ok(Points { name, unit })
    }
}
