//! Mechanisms for other languages: objects in memory of the caller, numbers by kind and index, errors as codes with a text.
//!
//! [`Object`] is a mechanism with a run of it, and is safe; [`border`] has the same behind pointers. Text of a source file
//! ([`source`]) gives the functions the names of a mechanism, and [`header()`] tells C of them. All of it is made of
//! [`Described::TABLES`], nothing by hand for each mechanism. `plm::view::library` builds a
//! library of any mechanism.
//!
//! This crate has unsafe code: what it dereferences it looks at first, as far as a pointer can be looked at.
#![no_std]

#[cfg(feature = "fmi")]
extern crate alloc;

#[allow(unsafe_code, reason = "pointers of other languages")]
pub mod border;
#[cfg(feature = "fmi")]
pub mod fmi;
pub mod header;
mod kind;
mod object;
pub mod saved;
mod source;
mod status;
mod text;

pub use header::header;
pub use kind::Kind;
pub use object::Object;
pub use source::{Names, Si, source};
pub use status::{Status, Trouble};
pub use text::Text;

use plm_runtime::words::InWords;
use plm_runtime::{Described, Statics};

/// What can be handed to other languages: every mechanism in `f64`.
pub trait Foreign: Described<S = f64, U: InWords> + Statics {}

impl<M: Described<S = f64, U: InWords> + Statics> Foreign for M {}
