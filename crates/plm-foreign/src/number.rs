//! The numbers of a library.

use plm_runtime::Real;

/// A number of C and of Rust: of these a mechanism is for other languages.
pub trait Number: Real {
    /// Its name in C.
    const C: &'static str;
    /// Its name in Rust.
    const RUST: &'static str;
}

impl Number for f64 {
    const C: &'static str = "double";
    const RUST: &'static str = "f64";
}

impl Number for f32 {
    const C: &'static str = "float";
    const RUST: &'static str = "f32";
}
