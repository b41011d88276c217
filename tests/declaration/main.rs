//! What the language of declarations says of a mechanism as a whole: its gravity.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod gravity;
