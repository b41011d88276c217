//! What generated functions give at a state, bit by bit, and what that costs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]

mod derivatives;
mod double_double;
mod linkages;
mod operations;
mod oracle;
mod pairs;
#[path = "../support/random.rs"]
mod random;
mod scenes;
