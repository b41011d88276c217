//! Sizes and shapes of parts that pictures show.

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use super::FrameRef;

/// A shape that pictures draw of a part.
#[derive(Clone, Debug)]
pub struct Shape {
    /// How it is drawn.
    pub look: Look,
    /// Its frame.
    pub at: FrameRef,
    /// The frame that its x axis points to; without it the axis is that of its frame.
    pub towards: Option<FrameRef>,
    /// Is it a symbol? Its points then count in half widths of a bar, and along the line to another frame as shares of it.
    pub is_symbol: bool,
    /// Points in the axes of its frame, m; a radius stands on the x axis. Expressions of parameters at most. The first point of a
    /// symbol and of a circle is where its origin is, m.
    pub points: Vec<Vec2>,
}

/// How a shape is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A plate within the points, in the colour of its body.
    Outline,
    /// A small plate in the colour of joints.
    Mark,
    /// A stroke through the points.
    Line,
    /// A stroke with solid material on its right.
    Surface,
    /// A circle with a mark on its x axis.
    Circle,
}

impl Look {
    /// All, by the words of the language.
    pub const ALL: [(&'static str, Look); 5] = [
        ("outline", Look::Outline),
        ("mark", Look::Mark),
        ("line", Look::Line),
        ("surface", Look::Surface),
        ("circle", Look::Circle),
    ];

    /// Its word.
    pub fn name(self) -> &'static str {
        Look::ALL.iter().find(|(_, look)| *look == self).map_or("", |(name, _)| name)
    }
}

/// A size of a part for pictures.
#[derive(Clone, Debug)]
pub struct Size {
    /// The parameter of the part, `piston_diameter`.
    pub name: String,
    /// Its value, SI; an expression of parameters at most.
    pub value: Expr,
}
