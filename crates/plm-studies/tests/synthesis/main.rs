//! Synthesis and kinematics beside published figures, closed forms, other formulations, and mechanisms that are run.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod balance;
mod function;
mod kinematics;
mod loops;
mod motion;
mod path;
mod reach;
mod six_bar;
