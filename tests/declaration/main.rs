//! What the language of declarations says, seen in what runs, and what a mechanism tells of itself.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]

mod branches;
mod described;
mod joints;
mod language;
mod observe;
mod pictures;
