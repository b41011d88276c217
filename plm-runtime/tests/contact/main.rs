//! Friction and unilateral contact of systems that are written by hand, against closed forms and quadratures.
#![allow(clippy::unwrap_used, clippy::panic, unreachable_pub, missing_docs, reason = "tests")]

mod block;
mod bodies;
mod corners;
mod energy;
mod friction;
mod generated;
mod impacts;
mod laws;
mod machines;
mod many;
mod oscillator;
mod painleve;
mod shares;
mod slider_crank;
mod stepping;
mod support;
