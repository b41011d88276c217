//! From tokens to a tree.
//!
//! ```text
//! declaration := { header } docs [visibility] NAME "{" { item } "}"
//! header      := "crate" "=" path ";" | "parts" "{" { definition } "}" | definition
//! definition  := docs ("joint" | "part") NAME "(" [ NAME ":" NAME { "," … } ] ")" "{" { item } "}"
//!              | docs "domain" NAME "{" "across" NAME ":" unit ";" { "through" NAME ":" unit ";" } "}"
//!
//! item := "gravity" ":" expr ";"                                    in a mechanism
//!       | "formulation" ":" ("tree" | "loops" | "absolute") ";"
//!       | "stabilisation" ":" ("projection" | "baumgarte" ["(" expr ")"]) ";"
//!       | "impacts" ":" ("poisson" | "newton" | "sequential") ";"
//!       | "code" ":" ("rolled" | "unrolled") ";"
//!       | "emit" ":" "step" "(" NAME { "," NAME } ")" ";"
//!       | "allow" "(" CODE { "," CODE } ")" ";"
//!       | "observe" path { "," path } ";"
//!       | definition
//!       | "choice" NAME ":" NAME { "|" NAME } ["=" NAME] ";"        in a part
//!       | "function" NAME "(" NAME ":" unit { "," NAME ":" unit } ")" ":" unit ["=" expr] ";"
//!       | "points" NAME ":" unit ";"
//!       | "pair" ":" NAME ";"
//!       | "picture" name { "," name } ";"
//!       | "picture" NAME "on" path ["," path] ["at" expr] [":" expr { "," expr } ["for" NAME "in" expr ".." ["="] expr]] ";"
//!       | "given" expr "{" { item } "}" ["else" "{" { item } "}"]
//!       | NAME "on" path ["from" path] ":" expr ";"
//!       | ("param" | "input" | "state" | "discrete") name [":" unit] ["=" expr] ["," ("locked" | "optional")] ";"    in both
//!       | "ground" "{" { port } "}"
//!       | "node" name ":" NAME "=" expr ";"
//!       | ("let" | "rate") name "=" expr ";"
//!       | "body" name "{" { field | port | start } "}"
//!       | NAME name "(" exprs ")" (";" | "{" { name { "." name } ["(" names ")"] ":" expr { "," expr } ["," "locked"] ";" } "}")
//!       | "constraint" NAME ":" expr "=" expr (";" | "{" "when" ":" expr ";" "}")
//!       | "unilateral" name ":" expr (">=" | "<=") expr (";" | "{" { ("restitution" | "when") ":" expr ";" } "}")
//!       | "friction" name ":" "rate" "(" expr ")" "within" bound (";" | "{" { "static" ":" bound ";" | "when" ":" expr ";" } "}")
//!       | "require" NAME ":" expr ";"
//!       | "when" (expr | "start") "{" { path "=" expr ";" } "}"
//!       | "output" output { "," output } ";"
//!       | "repeat" NAME "in" expr ".." ["="] expr "{" { item } "}"
//! field  := ("mass" | "inertia" | "centre" | "density" | "thickness" | "width" | "drawing_angle" | "depth") ":" expr ";" | "coordinates" ":" NAME ";"
//!         | ("contour" | "hole") ":" (expr { "," expr } | STRING) ";"
//! port   := "port" name ":" expr ["," ("angle" | "axis") ":" expr] ["," "depth" ":" expr] ";"
//! start  := "start" NAME ":" expr ["," "locked"] ";"
//! bound  := expr [".." expr]
//! output := [name "="] expr ["in" unit]
//! name   := NAME { "[" expr "]" }
//! ```
//! (expressions: `expr.rs`; units: `unit.rs`)
//!
//! Each construct has a file, with its type and its parser. The parsers read a stream of syn (`input.rs`), and the parser
//! of a construct that begins with a word of its own, `body`, `port`, stands after that word or takes it, as it says.
//!
//! The parser goes on at the next item after a mistake, so that three mistakes give three errors. Its recursion is
//! bounded: a stack overflow cannot be caught.

mod block;
mod body;
mod contact;
mod declaration;
mod domain;
mod event;
mod expr;
mod foreign_syntax;
mod handed;
mod input;
mod instance;
mod item;
mod keyword;
mod name;
mod operator;
mod output;
mod part;
mod quantity;
mod row;
pub mod rust;
mod shape;
mod unit;
mod value;

/// The tree of a declaration, as written: names are not bound, but units are known (their table is closed).
pub mod ast {
    pub use super::block::{Given, Repeat, Turns, all_items};
    pub use super::body::{Body, Contour, Port, Start};
    pub use super::contact::{Bound, Friction, Unilateral};
    pub use super::declaration::{Declaration, Mechanism, Shared};
    pub use super::domain::{Domain, Node, Quantity};
    pub use super::event::{Assignment, Moment, When};
    pub use super::expr::{Expr, ExprKind, Link};
    pub use super::handed::{Function, Points};
    pub use super::instance::{Field, Instance};
    pub use super::item::{Item, ItemKind};
    pub use super::name::{Ident, IndexedName};
    pub use super::operator::Operator;
    pub use super::output::Output;
    pub use super::part::{Argument, Choice, Definition};
    pub use super::row::Load;
    pub use super::shape::Shape;
    pub use super::value::Value;
}

pub(crate) use body::WORDS as BODY_WORDS;
pub(crate) use foreign_syntax::CONSTANTS;
pub(crate) use item::item_words;
pub(crate) use keyword::ALL as INNER_WORDS;
pub(crate) use unit::unit_help;

use crate::diag::Diagnostics;
use crate::token::Source;
use ast::{Declaration, Shared};

/// Reads a declaration. Mistakes go to the sink; what could be read comes back.
pub fn parse(source: &Source, sink: &mut Diagnostics) -> Declaration {
    input::read(source, sink, Declaration::parse)
}

/// Reads a file of the parts library: definitions and nothing else.
pub fn parse_parts(source: &Source, sink: &mut Diagnostics) -> Shared {
    input::read(source, sink, Shared::parse)
}
