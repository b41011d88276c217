//! Contents of a panel: named curves, and lines of reference.

/// A named line through points, in their order. A point that has no place on the axes (NaN, infinite, not positive on
/// a logarithmic scale) interrupts it.
#[derive(Clone, Debug)]
pub struct Series {
    pub(super) name: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) look: Option<Look>,
    pub(super) style: Style,
}

/// Drawing of the points of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// A line through them.
    Line,
    /// A line, and a marker at each.
    Marked,
    /// A marker at each.
    Points,
}

impl Style {
    pub(super) fn has_line(self) -> bool {
        self != Self::Points
    }

    pub(super) fn has_markers(self) -> bool {
        self != Self::Line
    }
}

/// Look that distinguishes a series from others: colour and shape of its markers, dashes and filling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Look {
    /// Members of a family share colour and shape; variants differ in dashes and filling.
    Family { family: usize, variant: usize },
    /// Grey, for a reference; one shape and one kind of dashes each.
    Muted(usize),
}

impl Series {
    /// A line without markers. It takes the next free colour of its panel; once these are used up, it is dashed.
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { name: name.into(), points: points.into_iter().collect(), look: None, style: Style::Line }
    }

    /// Adds a marker at every point.
    #[must_use]
    pub fn marked(self) -> Self {
        Self { style: Style::Marked, ..self }
    }

    /// Draws a marker at every point, and no line.
    #[must_use]
    pub fn as_points(self) -> Self {
        Self { style: Style::Points, ..self }
    }

    /// Sets the colour and the markers of family number `family`, dashed and filled as its variant number
    /// `variant` (the first one, 0, has a full line).
    #[must_use]
    pub fn of_family(self, family: usize, variant: usize) -> Self {
        Self { look: Some(Look::Family { family, variant }), ..self }
    }

    /// Makes the curve grey, for comparison with others; `number` decides the markers and the dashes.
    #[must_use]
    pub fn muted(self, number: usize) -> Self {
        Self { look: Some(Look::Muted(number)), ..self }
    }
}

/// A straight line across a panel at a value that is known otherwise, with its label.
#[derive(Clone, Debug)]
pub struct Rule {
    pub(super) at: At,
    pub(super) label: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum At {
    X(f64),
    Y(f64),
}

impl At {
    /// The value on the horizontal axis.
    pub(super) fn x(self) -> Option<f64> {
        if let Self::X(value) = self { Some(value) } else { None }
    }

    /// The value on the vertical axis.
    pub(super) fn y(self) -> Option<f64> {
        if let Self::Y(value) = self { Some(value) } else { None }
    }
}

impl Rule {
    /// Upright, at a value of the horizontal axis; its label stands above the frame.
    pub fn vertical(x: f64, label: impl Into<String>) -> Self {
        Self { at: At::X(x), label: label.into() }
    }

    /// Level, at a value of the vertical axis; its label stands at one of its ends, where curves are fewest.
    pub fn horizontal(y: f64, label: impl Into<String>) -> Self {
        Self { at: At::Y(y), label: label.into() }
    }
}
