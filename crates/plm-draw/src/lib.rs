//! Drawing: what a hand does to the picture of a mechanism is an edit of the text that declares it.
//!
//! A [`Gesture`] on a [`Sheet`], which is a text with its tree, and a [`Picture`], which has where its ports stand, is [`Drawn`]: edits and
//! values. Nothing is compiled. The text says everything that the picture shows, so that the edits that take a gesture back give the same
//! bytes.
//!
//! ```
//! use plm_draw::{Drag, Gesture, Picture, Placed, PortName, Sheet, applied, draw};
//!
//! let text = "pub P {\n    ground { port o: (0, 0) mm; }\n}\n";
//! let name = PortName::new("ground", "o");
//! let picture = Picture { ports: vec![Placed { name: name.clone(), at: [0.0, 0.0], angle: 0.0 }] };
//! let gesture = Gesture::Drag(Drag { port: name, to: [0.04, -0.0125], grid: 1e-3, free: false });
//! let drawn = draw(&Sheet::read(text, None), &picture, &gesture)?;
//! assert_eq!(applied(text, &drawn.edits), "pub P {\n    ground { port o: (40, -12.5) mm; }\n}\n");
//! # Ok::<(), plm_draw::Refusal>(())
//! ```
#![cfg_attr(docsrs, feature(doc_cfg))]

mod branch;
mod copy;
mod draw;
mod edit;
mod gesture;
mod insert;
pub mod layout;
pub mod lexer;
mod lift;
mod lock;
mod mirror;
mod names;
mod number;
mod picture;
mod port;
mod refusal;
mod remove;
mod rename;
mod rules;
mod setting;
mod sheet;
mod sketch;
mod slide;
mod start;
mod tools;
mod typed;

pub use draw::{draw, follow};
pub use edit::{Edit, applied, as_declared, inverse};
pub use gesture::{Drawn, End, Gesture};
pub use lift::{LIFTED, Lifted};
pub use names::{GROUND, PortName};
pub use number::{Change, Literal, decimal_step};
pub use picture::{Picture, Placed, Point};
pub use refusal::Refusal;
pub use rules::{Drag, Held};
pub use sheet::{Axes, Handle, Place, Polar, Sheet};
pub use sketch::{Sketch, SketchPart};
pub use start::{Ahead, Coordinate, StartAt};
pub use tools::{TOOLS, Tool};
pub use typed::{Dimension, Typed};

/// The text with parameters in the place of the numbers that a drag changes, so that they can be set without compiling.
///
/// # Errors
/// As [`draw`] of the same drag.
pub fn lift(sheet: &Sheet<'_>, picture: &Picture, drag: &Drag) -> Result<Lifted, Refusal> {
    lift::lifted(sheet, &rules::drag(sheet, picture, drag)?)
}
