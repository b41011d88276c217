//! Parts of the library, a module for each field, against closed forms and published figures.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod contact;
