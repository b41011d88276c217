//! Tests across the crates: declared mechanisms, compiled and run.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]
#![allow(clippy::approx_constant, reason = "the manual prints what it prints")]

mod absolute;
mod assembly;
mod brief;
mod carried;
mod compliance;
mod derivatives;
mod described;
mod feedback;
mod figures;
mod kinks;
mod language;
mod limits;
mod linkages;
mod manual;
mod near;
mod newton;
mod observe;
mod operations;
mod oracle;
mod pairs;
mod physics;
mod pictures;
#[path = "../support/random.rs"]
mod random;
mod reach;
mod reactions;
mod redundant;
mod references;
mod robust;
mod rungs;
mod scenes;
mod sides;
mod starts;
mod twofold;
