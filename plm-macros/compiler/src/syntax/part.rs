//! Definitions of parts, and the choices that only they hold.

use proc_macro2::Delimiter;
use syn::Token;

use super::input::{Input, Result};
use super::item::{Context, Item};
use super::name::Ident;

/// `joint kind(a: frame, …) { … }` or `part kind(…) { … }`
#[derive(Clone, Debug)]
pub struct Definition {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Does it hold constraints?
    pub is_joint: bool,
    /// Its name.
    pub name: Ident,
    /// Ports that it is connected to.
    pub arguments: Vec<Argument>,
    /// Its items.
    pub items: Vec<Item>,
}

/// `a: frame`
#[derive(Clone, Debug)]
pub struct Argument {
    /// Its name inside.
    pub name: Ident,
    /// Kind of port: `frame`, `body` or the name of a domain.
    pub kind: Ident,
}

/// A choice that is made at compile time.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Its name.
    pub name: Ident,
    /// The options.
    pub options: Vec<Ident>,
    /// The option that is chosen unless the use says otherwise.
    pub default: Option<Ident>,
}

impl Definition {
    /// `name(arguments) { items }` after `joint` or `part`.
    pub(super) fn parse(input: Input, is_joint: bool, docs: Vec<String>) -> Result<Definition> {
        let name = Ident::parse(input, "the name of the part")?;
        let arguments =
            input.group(Delimiter::Parenthesis, "`(`", |input| input.terminated(Argument::parse))?;
        let items = Item::block(input, Context::Part)?;
        Ok(Definition { docs, is_joint, name, arguments, items })
    }
}

impl Argument {
    /// `name: kind`
    fn parse(input: Input) -> Result<Argument> {
        let name = Ident::parse(input, "the name of an argument")?;
        input.expect(Token![:], "`:`")?;
        Ok(Argument { name, kind: Ident::parse(input, "`frame`, `body` or a domain")? })
    }
}

impl Choice {
    /// `name: option | option = option;`
    pub(super) fn parse(input: Input) -> Result<Choice> {
        let name = Ident::parse(input, "the name of the choice")?;
        input.expect(Token![:], "`:`")?;
        let mut options = vec![Ident::parse(input, "an option")?];
        while input.eat(Token![|]) {
            options.push(Ident::parse(input, "an option")?);
        }
        let default = if input.eat(Token![=]) { Some(Ident::parse(input, "an option")?) } else { None };
        input.semicolon()?;
        Ok(Choice { name, options, default })
    }
}
