//! Charts as SVG: panels one above another over a common horizontal axis.
//!
//! A chart is data first: a list of panels, each with two axes and some curves. A kind of chart is one function
//! that fills the panels ([`Chart::over_time`]); how panels are drawn is the same for all of them.

mod axis;
mod draw;
mod label;
mod thin;

use std::io;
use std::path::Path;

use crate::error::{Error, write_file};
use crate::recording::Recording;

use axis::Axis;

/// A picture of curves.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    /// The horizontal axis, common to all panels and labelled under the last one.
    x: Axis,
    panels: Vec<Panel>,
}

/// One frame with its own vertical axis, its curves and their legend.
#[derive(Clone, Debug)]
struct Panel {
    y: Axis,
    curves: Vec<Curve>,
}

/// A named line through points. A point that cannot be drawn (NaN, infinite) interrupts it.
#[derive(Clone, Debug)]
struct Curve {
    name: String,
    points: Vec<(f64, f64)>,
}

impl Chart {
    /// The recorded quantities over time, in one panel for each unit, in the order of the columns.
    pub fn over_time<const N: usize>(recording: &Recording<N>) -> Self {
        let times = recording.times();
        let mut units: Vec<&str> = Vec::new();
        for column in recording.columns() {
            if !units.contains(&column.unit.as_str()) {
                units.push(&column.unit);
            }
        }
        Self {
            title: String::new(),
            x: Axis::tight(label::with_unit("time", "s"), times.iter().copied()),
            panels: units.into_iter().map(|unit| Panel::of_unit(recording, unit)).collect(),
        }
    }

    /// The same chart under a title.
    #[must_use]
    pub fn titled(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// The picture as the text of an SVG file. It needs no font of its own and the same chart gives the same
    /// text.
    ///
    /// # Errors
    /// If the drawing library fails.
    pub fn to_svg(&self) -> io::Result<String> {
        draw::svg(self)
    }

    /// Writes the picture as an SVG file and makes the folders above it where they are missing.
    ///
    /// # Errors
    /// If the file cannot be written; the error names it.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), self.to_svg().map(String::into_bytes))
    }
}

impl Panel {
    /// The columns of this unit over time.
    fn of_unit<const N: usize>(recording: &Recording<N>, unit: &str) -> Self {
        let times = recording.times();
        let mut curves = Vec::new();
        for (index, column) in recording.columns().iter().enumerate() {
            if column.unit == unit {
                let points = times.iter().zip(recording.rows()).map(|(&time, row)| (time, row[index]));
                curves.push(Curve { name: column.name.clone(), points: points.collect() });
            }
        }
        let quantity = label::common_quantity(curves.iter().map(|curve| curve.name.as_str()));
        let values = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
        Self { y: Axis::padded(label::with_unit(quantity, unit), values), curves }
    }
}
