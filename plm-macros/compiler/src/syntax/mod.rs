//! From tokens to a tree.
//!
//! ```text
//! declaration := { header } docs [visibility] NAME "{" { item } "}"
//! header      := "crate" "=" path ";" | "parts" "{" { definition } "}" | definition
//! definition  := docs ("joint" | "part") NAME "(" [ NAME ":" NAME { "," … } ] ")" "{" { item } "}"
//!              | docs "domain" NAME "{" "across" NAME ":" unit ";" { "through" NAME ":" unit ";" } "}"
//!
//! item := "gravity" ":" expr ";"                                    in a mechanism
//!       | "rung" ":" ("tree" | "loops" | "absolute") ";"
//!       | "stabilisation" ":" ("projection" | "baumgarte" ["(" expr ")"]) ";"
//!       | "allow" "(" CODE { "," CODE } ")" ";"
//!       | "observe" path { "," path } ";"
//!       | definition
//!       | "choice" NAME ":" NAME { "|" NAME } ["=" NAME] ";"        in a part
//!       | "pair" ":" NAME ";"
//!       | "picture" name { "," name } ";"
//!       | NAME "on" path ["from" path] ":" expr ";"
//!       | ("param" | "input" | "state") name [":" unit] ["=" expr] ["," "locked"] ";"    in both
//!       | "ground" "{" { port } "}"
//!       | "node" name ":" NAME "=" expr ";"
//!       | ("let" | "rate") name "=" expr ";"
//!       | "body" name "{" { field | port | start } "}"
//!       | NAME name "(" exprs ")" (";" | "{" { name { "." name } ":" expr ["," "locked"] ";" } "}")
//!       | "constraint" NAME ":" expr "=" expr ";"
//!       | "require" NAME ":" expr ";"
//!       | "output" output { "," output } ";"
//!       | "repeat" NAME "in" expr ".." ["="] expr "{" { item } "}"
//! field  := ("mass" | "inertia" | "centre" | "drawing_angle" | "depth") ":" expr ";" | "coordinates" ":" NAME ";"
//!         | "contour" ":" (expr { "," expr } | STRING) ";"
//! port   := "port" name ":" expr ["," ("angle" | "axis") ":" expr] ["," "depth" ":" expr] ";"
//! start  := "start" NAME ":" expr ["," "locked"] ";"
//! output := [name "="] expr ["in" unit]
//! name   := NAME { "[" expr "]" }
//! ```
//! (expressions: `expr.rs`; units: `unit.rs`)
//!
//! The parser goes on at the next item after a mistake, so that three mistakes give three errors. Its recursion is
//! bounded: a stack overflow cannot be caught.

pub mod ast;
mod body;
mod cursor;
mod expr;
mod habits;
mod header;
mod item;
mod part;
mod unit;

pub(crate) use body::file_name;
pub(crate) use habits::CONSTANTS;
pub(crate) use unit::unit_help;

use crate::diag::Diagnostics;
use crate::token::Source;
use ast::{Declaration, Shared};
use cursor::Cursor;

/// Reads a declaration. Mistakes go to the sink; what could be read comes back.
pub fn parse(source: &Source, sink: &mut Diagnostics) -> Declaration {
    Cursor::new(source, sink).declaration()
}

/// Reads a file of the parts library: definitions and nothing else.
pub fn parse_parts(source: &Source, sink: &mut Diagnostics) -> Shared {
    let mut shared = Shared::default();
    Cursor::new(source, sink).definitions(&mut shared);
    shared
}
