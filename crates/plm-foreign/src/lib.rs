//! Mechanisms for other languages: objects in memory of the caller, numbers by kind and index, errors as codes with a text.
//!
//! [`Object`] is a mechanism with a run of it, and is safe; [`ffi`] has its functions behind pointers. Text of a source file ([`source`])
//! gives the functions the names of a mechanism, and [`header()`] declares them for C. All of it is made of `Described::TABLES`, nothing by
//! hand for each mechanism. `plm::view::library` builds a library of any mechanism.
//!
//! This crate has unsafe code: it checks every pointer before it reads from it, as far as a pointer can be checked.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

#[cfg(feature = "fmi")]
extern crate alloc;

mod cpp;
mod declared;
#[allow(unsafe_code, reason = "pointers of other languages")]
pub mod ffi;
#[cfg(feature = "fmi")]
pub mod fmi;
pub mod header;
mod kind;
mod number;
mod object;
mod run;
pub mod saved;
mod source;
mod status;
mod text;

pub use cpp::cpp_header;
pub use declared::declared;
pub use header::header;
pub use kind::Kind;
pub use number::Number;
pub use object::{Object, ObjectBy};
pub use plm_runtime::linearised::{Linearised, Matrix};
pub use run::{By, Called, Choice, Chosen, Either, Run};
pub use source::{Entry, Names, Si, source};
pub use status::{Error, Status};
pub use text::Text;

use plm_runtime::Statics;
use plm_runtime::linearised::Linearisable;
use plm_runtime::words::InWords;

/// Mechanisms that can be handed to other languages: every one in `f64` or `f32`.
pub trait Foreign: Linearisable<S: Number, U: InWords> + Statics {}

impl<M: Linearisable<S: Number, U: InWords> + Statics> Foreign for M {}
