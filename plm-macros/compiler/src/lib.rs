//! The compiler of plm: a declared mechanism in, Rust source and a report out.

mod check;
mod compile;
mod derive;
pub mod diag;
mod emit;
mod formulate;
pub mod front;
pub mod lex;
mod library;
pub mod model;
mod oracle;
mod report;
mod resolve;
pub mod span;
pub mod syntax;
pub mod token;
pub mod units;

pub use compile::{Expansion, compile};
pub use emit::Code;
pub use oracle::Oracle;
pub use report::Report;
