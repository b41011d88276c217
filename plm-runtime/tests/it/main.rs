//! Tests of the runtime against exact solutions, published references and an independent linear algebra.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod assembly;
mod bead;
mod brief;
mod change_points;
mod charts;
mod clock;
mod counts;
mod dense;
mod dual;
mod events;
mod faults;
mod followed;
mod gauss;
mod linalg;
mod linear;
mod linkage;
mod mechanisms;
mod order;
mod oscillator;
mod projection;
mod radau;
#[path = "../../../tests/support/random.rs"]
mod random;
mod redundant;
mod references;
mod resume;
mod ros34pw2;
mod scalar;
mod single;
mod smooth;
mod tube;
mod twofold;
