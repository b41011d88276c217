//! Texts of declarations: their tokens with comments, and their layout.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod edit;
pub mod layout;
pub mod lexer;

pub use edit::as_declared;
