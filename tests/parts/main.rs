//! Parts of the library beside closed forms, published figures and conservation laws.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod bristles;
mod catches;
mod joints;
mod loose;
