//! Runs against laws of mechanics, published figures and references of many digits.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]
#![allow(clippy::approx_constant, reason = "the manual prints what it prints")]

mod absolute;
mod compliance;
mod feedback;
mod manual;
mod massless;
mod physics;
mod references;
#[path = "../support/standard.rs"]
mod scenes;
