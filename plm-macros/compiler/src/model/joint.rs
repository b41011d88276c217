//! Parts at the top level: what they join, as which kinematic pair, in which mirror image.

use crate::model::{Declared, Name};
use crate::span::Span;

/// An instance of a part at the top level of the declaration.
#[derive(Clone, Debug)]
pub struct Part {
    /// Name of the instance, e.g. `shoulder`.
    pub name: Name,
    /// Name of its definition, e.g. `revolute`.
    pub kind: String,
    /// Its kinematic pair, if the definition states one.
    pub pair: Option<Pair>,
    /// Place in its definition that states the pair.
    pub declared: Option<Declared>,
    /// The frames that it joins, in the order of its arguments.
    pub frames: Vec<FrameRef>,
    /// The mirror image that its use asks for, and where.
    pub branch: Option<(Turn, Span)>,
}

/// Which way the second body of a revolute turns from the first. The mirror images of a loop differ in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Positive.
    Left,
    /// Negative.
    Right,
}

impl Turn {
    /// Both, as the language names them.
    pub const NAMES: [(&'static str, Turn); 2] = [("left", Turn::Left), ("right", Turn::Right)];

    /// Its name in the language.
    pub fn name(self) -> &'static str {
        Turn::NAMES.iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// That of the other mirror image.
    #[must_use]
    pub fn other(self) -> Turn {
        if self == Turn::Left { Turn::Right } else { Turn::Left }
    }
}

/// Kinematic pairs that formulations in joint coordinates can walk through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pair {
    /// Points coincide.
    Revolute,
    /// One translation along the first frame's x axis.
    Prismatic,
    /// A point slides along the first frame's x axis and turns freely.
    PinSlot,
    /// No relative motion.
    Weld,
}

/// A frame of a body or of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRef {
    /// Index of the body; `None` for the ground.
    pub body: Option<usize>,
    /// Index of the port in the body's (or the ground's) list.
    pub port: usize,
}
