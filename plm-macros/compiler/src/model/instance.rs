//! Parts in use, as tables and pictures tell of them.

use plm_cas::Expr;

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
    /// Fields that its use sets.
    pub fields: Vec<SetField>,
    /// Sizes that pictures show.
    pub sizes: Vec<Size>,
    /// Shapes that pictures draw.
    pub shapes: Vec<Shape>,
}

/// A field that the use of a part sets.
#[derive(Clone, Debug)]
pub struct SetField {
    /// Its path: `damping`, `spring.stiffness`.
    pub name: String,
    /// Its value, SI, where it is one number of the part itself.
    pub value: Option<Expr>,
}
