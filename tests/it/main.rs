//! Tests across the crates: declared mechanisms, compiled and run.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod assembly;
mod language;
mod manual;
mod oracle;
mod physics;
mod references;
mod robust;
mod scenes;
