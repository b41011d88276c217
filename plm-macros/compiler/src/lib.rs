//! The compiler of plm: a declared mechanism in, Rust source and a report out.
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "lowered")]
mod assembled;
mod bug;
mod check;
mod collect;
mod compile;
mod derive;
pub mod diag;
mod emit;
mod evaluated;
mod facts;
mod fallback;
mod formulate;
pub mod front;
mod library;
#[cfg(feature = "lowered")]
pub mod lowered;
pub mod model;
mod numeric;
mod oracle;
mod outline;
mod picture;
mod reads;
mod report;
mod resolve;
pub mod sorted;
mod source;
pub mod span;
#[cfg(feature = "lowered")]
mod start_values;
pub mod syntax;
mod tables;
mod text;
pub mod token;
mod topology;
pub mod units;
pub mod words;
#[cfg(feature = "lowered")]
mod written;

#[cfg(feature = "lowered")]
pub use assembled::{Affine, Assembled, AssembledBody, AssembledInput, AssembledPart, FieldValue, InputTerm};
pub use bug::{bug_message, without_panic};
pub use compile::{Expansion, analyse, compile, names_only};
pub use emit::Code;
pub use facts::limits::{Least, Limit};
pub use facts::quantities::{Quantities, Quantity};
pub use formulate::{Elimination, OfRows, RowTerm};
pub use oracle::{InChart, Oracle};
pub use picture::{Picture, PictureBody, PicturePart, PicturePort, PictureShape};
pub use reads::{Motion, Reads};
pub use report::Report;
pub use source::{OfScalar, Source};
#[cfg(feature = "lowered")]
pub use start_values::StartValue;
#[cfg(feature = "lowered")]
pub use written::Written;
