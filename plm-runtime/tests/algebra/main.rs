//! Numbers of other kinds, and small linear algebra, against an independent one.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod double_double;
mod dual;
mod enclosure;
mod linalg;
mod linear;
#[path = "../support/linkage.rs"]
mod linkage;
#[path = "../support/mechanisms.rs"]
mod mechanisms;
#[path = "../support/oscillator.rs"]
mod oscillator;
#[path = "../../../tests/support/random.rs"]
mod random;
mod scalar;
#[path = "../support/smooth.rs"]
mod smooth;
