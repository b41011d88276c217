//! From text to tokens, for parts libraries and tests. (Tokens of rustc are flattened by the macro crate.)

mod number;
mod text;

pub use number::{NumberText, split_number};
pub use text::lex;
