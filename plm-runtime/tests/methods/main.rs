//! Integrators against exact solutions and published references.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod bends;
mod catalogue;
mod clock;
mod counts;
mod dense;
mod faults;
mod gauss;
#[path = "../support/linkage.rs"]
mod linkage;
#[path = "../support/mechanisms.rs"]
mod mechanisms;
mod order;
#[path = "../support/oscillator.rs"]
mod oscillator;
mod radau;
#[path = "../../../tests/support/random.rs"]
mod random;
mod references;
mod resume;
mod ros34pw2;
mod single;
#[path = "../support/smooth.rs"]
mod smooth;
