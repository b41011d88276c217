//! Names and their indices.

use proc_macro2::Delimiter;
use syn::ext::IdentExt;
use syn::token;

use super::expr::Expr;
use super::input::{Input, Result};
use crate::span::Span;

/// A name and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ident {
    /// The name.
    pub text: String,
    /// Its place.
    pub span: Span,
}

impl Ident {
    /// A name, which may be a keyword of Rust; `what` says what it would be.
    pub(super) fn parse(input: Input, what: &str) -> Result<Ident> {
        let span = input.here();
        match input.call(syn::Ident::parse_any) {
            Ok(ident) => Ok(Ident { text: ident.unraw().to_string(), span }),
            Err(_) => Err(input.expected(what)),
        }
    }
}

/// A name with its indices: `bar`, `bar[i]`.
#[derive(Clone, Debug)]
pub struct IndexedName {
    /// The name.
    pub ident: Ident,
    /// Its indices.
    pub indices: Vec<Expr>,
}

impl IndexedName {
    /// `name`, `name[i]`, `name[i][j]`; `what` says what it would be.
    pub(super) fn parse(input: Input, what: &str) -> Result<IndexedName> {
        let ident = Ident::parse(input, what)?;
        let mut indices = Vec::new();
        while input.peek(token::Bracket) {
            indices.push(input.group(Delimiter::Bracket, "an index", Expr::parse)?);
        }
        Ok(IndexedName { ident, indices })
    }
}
