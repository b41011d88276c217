//! Blocks of items: those that are repeated, and those that exist where a parameter is given.
//!
//! ```text
//! "repeat" NAME "in" expr ".." ["="] expr "{" { item } "}"
//! "given" expr "{" { item } "}" ["else" "{" { item } "}"]
//! ```

use syn::{Token, token};

use super::expr::{Expr, ExprKind};
use super::input::{Input, Reported, Result};
use super::item::{Context, Item, ItemKind};
use super::name::Ident;
use crate::diag::Code;

/// `i in from..to`
#[derive(Clone, Debug)]
pub struct Turns {
    /// The index.
    pub index: Ident,
    /// Its first value.
    pub from: Expr,
    /// The bound.
    pub to: Expr,
    /// Is the bound a value of the index, `0..=n`?
    pub inclusive: bool,
}

/// `repeat i in from..to { … }`
#[derive(Clone, Debug)]
pub struct Repeat {
    /// The index and its values.
    pub turns: Turns,
    /// Items to repeat.
    pub items: Vec<Item>,
}

/// `given friction { … } else { … }`
#[derive(Clone, Debug)]
pub struct Given {
    /// Parameters that the use sets, options of choices, and what `and`, `or`, `not` make of them.
    pub condition: Expr,
    /// Items where it holds.
    pub items: Vec<Item>,
    /// Items where it does not.
    pub otherwise: Vec<Item>,
}

impl Turns {
    /// `name in expr..expr`
    pub(super) fn parse(input: Input) -> Result<Turns> {
        let index = Ident::parse(input, "the name of an index")?;
        input.expect(Token![in], "`in`")?;
        let from = Expr::parse(input)?;
        input.expect(Token![.], "`..`")?;
        input.expect(Token![.], "`..`")?;
        let inclusive = input.eat(Token![=]);
        let to = Expr::parse(input)?;
        Ok(Turns { index, from, to, inclusive })
    }
}

impl Repeat {
    /// `name in expr..expr { items }`
    pub(super) fn parse(input: Input, context: Context) -> Result<Repeat> {
        let turns = Turns::parse(input)?;
        let items = Item::block(input, context)?;
        Ok(Repeat { turns, items })
    }
}

impl Given {
    /// `condition { items } else { items }` after `given`.
    pub(super) fn parse(input: Input) -> Result<Given> {
        let start = input.position();
        let condition = Expr::parse(input).unwrap_or_else(|Reported| {
            input.advance_to(|input| input.peek(Token![;]) || input.peek(token::Brace));
            Expr { kind: ExprKind::Unknown, span: input.span_from(start) }
        });
        if !input.peek(token::Brace) {
            return Err(match condition.kind {
                ExprKind::Unknown => Reported,
                _ => input.expected_but("`{`", "write `given parameter { … }`, with items in the braces"),
            });
        }
        let items = Item::block(input, Context::Part)?;
        let otherwise = if input.eat(Token![else]) { Item::block(input, Context::Part)? } else { Vec::new() };
        for item in items.iter().chain(&otherwise) {
            if let ItemKind::Pair(_) = item.kind {
                input
                    .error(Code::MisplacedItem, item.span, "a `pair` stands in no block")
                    .help("a joint is one pair always: write it outside of `given`");
            }
        }
        Ok(Given { condition, items, otherwise })
    }
}

/// Items and those in their blocks, whatever these depend on.
pub fn all_items(items: &[Item]) -> impl Iterator<Item = &Item> {
    let mut open = vec![items.iter()];
    std::iter::from_fn(move || {
        loop {
            match open.last_mut()?.next() {
                Some(item) => {
                    match &item.kind {
                        ItemKind::Repeat(repeat) => open.push(repeat.items.iter()),
                        ItemKind::Given(given) => {
                            open.push(given.otherwise.iter());
                            open.push(given.items.iter());
                        }
                        _ => {}
                    }
                    return Some(item);
                }
                None => drop(open.pop()),
            }
        }
    })
}
