//! One-dimensional domains, and the nodes at which their parts meet.

use proc_macro2::Delimiter;
use syn::Token;

use super::expr::Expr;
use super::input::{Input, Result};
use super::keyword as kw;
use super::name::{Ident, IndexedName};
use super::unit::declared_unit;
use crate::units::DisplayUnit;

/// `domain name { across name: unit; through name: unit; … }`
#[derive(Clone, Debug)]
pub struct Domain {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Ident,
    /// The quantity that is equal for all that meets at a node.
    pub across: Quantity,
    /// Quantities that add up at a node.
    pub through: Vec<Quantity>,
}

/// `name: unit` of a domain.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name.
    pub name: Ident,
    /// Its unit.
    pub unit: DisplayUnit,
}

/// `node name: kind = expr;`
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name.
    pub name: IndexedName,
    /// Kind of port: `frame`, `body` or the name of a domain.
    pub kind: Ident,
    /// Its across quantity, or the port that it is another name of.
    pub value: Expr,
}

impl Domain {
    /// `name { across name: unit; through name: unit; … }` after `domain`.
    pub(super) fn parse(input: Input, docs: Vec<String>) -> Result<Domain> {
        let name = Ident::parse(input, "the name of the domain")?;
        input.group(Delimiter::Brace, "`{`", |input| {
            input.docs();
            input.expect(kw::across, "`across`")?;
            let across = Quantity::parse(input)?;
            let mut through = Vec::new();
            while through.is_empty() || !input.is_empty() {
                input.docs();
                input.expect(kw::through, "`through`")?;
                through.push(Quantity::parse(input)?);
            }
            Ok(Domain { docs, name, across, through })
        })
    }
}

impl Quantity {
    /// `name: unit;`
    fn parse(input: Input) -> Result<Quantity> {
        let name = Ident::parse(input, "the name of a quantity")?;
        input.expect(Token![:], "`:`")?;
        let unit = declared_unit(input)?;
        input.semicolon()?;
        Ok(Quantity { name, unit })
    }
}

impl Node {
    /// `name: kind = expr;` after `node`.
    pub(super) fn parse(input: Input) -> Result<Node> {
        let name = IndexedName::parse(input, "the name of the node")?;
        input.expect(Token![:], "`:`")?;
        let kind = Ident::parse(input, "`frame`, `body` or a domain")?;
        input.expect(Token![=], "`=`")?;
        Ok(Node { name, kind, value: input.last_value()? })
    }
}
