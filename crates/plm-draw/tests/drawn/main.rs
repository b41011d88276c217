//! Texts after gestures.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod deeds;
mod gallery;
mod lifted;
mod random;
mod sketched;
mod slides;
mod support;
mod tables;
