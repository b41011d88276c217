//! Elementary functions for `f32` and `f64` with the same bits on every target.
//!
//! Every result is made from IEEE 754 additions, subtractions, multiplications and divisions in round-to-nearest, and
//! from integer operations; the order of the operations is fixed, nothing is fused, and no library of the platform is
//! called. So x86-64 (SSE2 and later), ARM, RISC-V and WebAssembly have to agree to the last bit; CI runs x86-64. The x87 unit
//! of i586 and modes that flush subnormal numbers to zero are not IEEE arithmetic and are not supported.
//!
//! Only NaNs are excepted: which of its bit patterns comes out is left open, by processors and by Rust's own rules (the
//! primitive type `f32`, "NaN bit patterns").
//!
//! No function allocates or panics. Special cases follow C99, Annex F. `ERRORS.md` has the measured errors.
//!
//! [`mod@f64`] and [`mod@f32`] hold the same functions. The f32 ones never compute in f64, which small targets lack.
//! [`exact`] has the rounding errors of sums and products, for numbers of twice the precision. [`Operations`] counts what is computed.
//!
//! With the feature `std` square roots come from the processor; without it they are found and corrected in integers, with
//! the same bits, unless `processor-sqrt-f32` or `processor-sqrt-f64` says that the processor has an instruction (in the crate
//! plm-processor, whose assembly is unsafe). With the feature `fma` polynomials are evaluated with one rounding a term: other bits, within the same
//! bounds of error.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]
#![forbid(unsafe_code)]
// Coefficients stand as tools/minimax.py prints them.
#![allow(clippy::unreadable_literal)]

#[cfg(any(feature = "std", test))]
extern crate std;

mod asin;
mod atan;
pub mod exact;
mod exp;
mod float;
mod functions;
mod hypot;
mod ln;
mod operations;
mod pair;
mod powi;
mod reduce;
mod sin_cos;
mod sqrt;
mod tan;

pub use functions::{f32, f64};
pub use operations::Operations;
