//! Identification and optimal control against what is known otherwise. Mechanisms are texts, which cost no rustc.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::missing_panics_doc,
    missing_docs,
    unreachable_pub,
    reason = "tests"
)]

mod base;
mod control;
mod covariance;
mod files;
mod identify;

use plm::dynamic::Compiled;
use plm::runtime::{StartValues, Statics};

/// A mechanism of few bodies.
pub type Few = plm::dynamic::Dynamic<f64, 9, 8, 32, 9>;

/// Compiles a declaration.
#[track_caller]
pub fn mechanism(text: &str) -> Few {
    Compiled::new("test", text).unwrap_or_else(|why| panic!("{why}")).mechanism().unwrap()
}

/// Sets a start value.
pub fn set_start(of: &mut Few, name: &str, value: f64) {
    of.starts_mut().each(&mut |own, start| {
        if own == name {
            *start = start.at(value);
        }
    });
}
