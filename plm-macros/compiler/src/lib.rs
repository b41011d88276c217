//! The compiler of plm: a declared mechanism in, Rust source and a report out.

mod bug;
mod check;
mod collect;
mod compile;
mod derive;
pub mod diag;
mod emit;
mod fallback;
mod formulate;
pub mod front;
mod library;
pub mod model;
mod numeric;
mod oracle;
mod outline;
mod picture;
mod reads;
mod report;
mod resolve;
pub mod sorted;
pub mod span;
mod start_values;
pub mod syntax;
mod tables;
mod text;
pub mod token;
mod topology;
pub mod units;
pub mod words;

pub use bug::{bug_message, without_panic};
pub use compile::{Expansion, compile, names_only};
pub use emit::Code;
pub use oracle::{InChart, Oracle};
pub use picture::{Picture, PictureBody, PicturePart, PicturePort, PictureShape};
pub use report::Report;
pub use start_values::StartValue;
