//! The front end on whole declarations: what they mean, checked against the manual, against finite differences, and
//! against plain arithmetic.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod bodies;
mod contacts;
mod declarations;
mod expressions;
mod line_ends;
mod malformed_input;
mod nodes;
mod observe;
mod parts;
mod pictures;
#[path = "../../../../tests/support/random.rs"]
mod random;
mod requirements;
mod states;
mod support;
mod token_texts;
mod work;
