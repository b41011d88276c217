//! Parts in use, as tables and pictures tell of them.

use super::{FrameRef, Pair, Shape, Size};

/// A part in use, in the declaration or inside of another part.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Full path, `arm.spring`.
    pub name: String,
    /// Name of its definition, e.g. `revolute`.
    pub kind: String,
    /// Its kinematic pair, if the definition states one.
    pub pair: Option<Pair>,
    /// Its arguments that are frames, by name.
    pub frames: Vec<(String, FrameRef)>,
    /// Sizes that pictures show.
    pub sizes: Vec<Size>,
    /// Shapes that pictures draw.
    pub shapes: Vec<Shape>,
}
