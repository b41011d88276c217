//! How bodies are put together and kept together.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod assembly;
#[path = "../support/linkage.rs"]
mod linkage;
#[path = "../support/mechanisms.rs"]
mod mechanisms;
mod projection;
mod redundant;
