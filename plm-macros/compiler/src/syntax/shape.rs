//! Pictures of parts: sizes that pictures show, and shapes.
//!
//! ```text
//! "picture" name { "," name } ";"
//! "picture" NAME "on" path ["," path] ["at" expr] [":" expr { "," expr } ["for" NAME "in" expr ".." ["="] expr]] ";"
//! ```

use syn::Token;

use super::block::Turns;
use super::body::share_unit;
use super::expr::Expr;
use super::input::{Input, Result};
use super::item::ItemKind;
use super::keyword as kw;
use super::name::{Ident, IndexedName};

/// A shape that is drawn of a part.
#[derive(Clone, Debug)]
pub struct Shape {
    /// How it is drawn: `outline`, `mark`, `line`, `surface`, `circle`.
    pub look: Ident,
    /// Its frame, or a node that belongs to one.
    pub on: Expr,
    /// The frame that its x axis points to; without it the axis is that of the frame.
    pub towards: Option<Expr>,
    /// Origin of its points in its frame; of a circle its centre.
    pub origin: Option<Expr>,
    /// Its points; of a circle the radius. None for a surface along the whole x axis.
    pub points: Vec<Expr>,
    /// Turns of an index, each of which has all points.
    pub turns: Option<Turns>,
}

/// Sizes or a shape after `picture`.
pub(super) fn picture(input: Input) -> Result<ItemKind> {
    if !input.peek2(kw::on) {
        let names = input.listed(|input| IndexedName::parse(input, "a parameter"))?;
        return Ok(ItemKind::Picture(names));
    }
    let look = Ident::parse(input, "how it is drawn")?;
    input.expect(kw::on, "`on`")?;
    let on = Expr::parse(input)?;
    let towards = if input.eat(Token![,]) { Some(Expr::parse(input)?) } else { None };
    let origin = if input.eat(kw::at) { Some(Expr::parse(input)?) } else { None };
    let mut points = Vec::new();
    if input.eat(Token![:]) {
        points.push(Expr::parse(input)?);
        while input.eat(Token![,]) {
            points.push(Expr::parse(input)?);
        }
        share_unit(&mut points);
    }
    let turns = if input.eat(Token![for]) { Some(Turns::parse(input)?) } else { None };
    input.semicolon()?;
    Ok(ItemKind::Shape(Box::new(Shape { look, on, towards, origin, points, turns })))
}
