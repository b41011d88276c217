//! Letters, colours and files that charts have in common with other drawings.

pub use crate::chart::{CURVES, FONT, INK, dark_style, text_width, wrap};
pub use crate::error::write_file;
pub use crate::markup::escape;
