//! What the language of declarations says of a mechanism as a whole: its gravity, the branches of its loops, what it shows of its joints.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod branches;
mod gravity;
mod joints;
