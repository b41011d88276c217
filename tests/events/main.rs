//! Conditions of a declaration, and what else makes forces jump, within runs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]
#![allow(clippy::excessive_precision, reason = "references are written as they were published")]

#[path = "../support/beside_text.rs"]
mod beside_text;
mod kinks;
mod near_singular;
#[path = "../support/random.rs"]
mod random;
mod sets;
mod short_events;
mod sides;
