//! Random mechanisms against a reference in higher precision.
//!
//! ```sh
//! cargo run --release --example sweep -- --check-reference      # is the reference right?
//! ```
#![allow(missing_docs, reason = "the modules are private to an example")]
#![allow(unreachable_pub, reason = "the modules are private to an example")]

mod reference;
mod scene;

use std::process::ExitCode;

fn main() -> ExitCode {
    if reference::check::all() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
