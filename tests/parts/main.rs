//! Parts of the library beside closed forms, published figures and conservation laws.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod functions;
mod hydraulics;
mod plates;
mod pneumatics;
mod signals;
