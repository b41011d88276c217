//! The command `plm`: declarations of mechanisms without rustc.
//!
//! ```text
//! plm check FILE… [--json]     what is wrong, where, and what to do about it
//! plm run FILE --until SECONDS  its outputs over time
//! plm identify FILE --csv F …  its parameters from measurements
//! plm modes FILE               frequencies, dampings and shapes of its modes
//! plm expand FILE              the Rust code that the macro would emit
//! plm report FILE              bodies, rows, formulation, operations, assembly
//! plm export FILE              a project that makes a program, C, an FMU or a wheel of it, its MJCF or URDF, a link
//! plm import FILE              a declaration from URDF, SDF or MJCF, a contour from DXF
//! plm fmt [--check] FILE…      one layout, with comments kept
//! plm picture FILE             a drawing, as SVG
//! plm lsp                      a language server on standard input and output
//! plm mcp                      a server of the Model Context Protocol on standard input and output
//! ```
//!
//! A file is a declaration (`.plm`), or Rust with `mechanism! { … }` in it (`.rs`).
#![cfg_attr(docsrs, feature(doc_cfg))]

mod checked;
mod command;
mod equations;
mod excerpt;
#[cfg(feature = "identify")]
mod fitted;
mod interrupt;
mod json;
mod layout;
#[cfg(feature = "mcp")]
mod mcp;
mod package;
mod quote;
mod read;
#[cfg(feature = "identify")]
mod readings;
mod server;
mod table;
mod value;

use plm_draw::lexer;

pub use command::{Outcome, Streams, run};
pub use excerpt::declarations;
#[cfg(feature = "identify")]
pub use fitted::{Found, with_values};
pub use interrupt::interrupt;
pub use json::diagnostics;
#[cfg(feature = "mcp")]
pub use mcp::memory_limit;
#[cfg(feature = "identify")]
pub use readings::experiment;
pub use server::Server;
pub use value::value;
