//! Charts as SVG: panels one above another over a common horizontal axis.
//!
//! A chart is data first: axes, and a list of panels with their curves. A kind of chart is one function that fills
//! them ([`Chart::over_time`]); how panels are drawn is the same for all.

mod axis;
mod decimation;
mod draw;
mod label;
mod linear_scale;
mod log_scale;
mod series;
#[cfg(test)]
mod table;

use std::io;
use std::path::Path;

use crate::error::{Error, write_file};
use crate::recording::{Column, Recording, Role};

pub use axis::Axis;
pub use draw::{CURVES, FONT, INK, dark_style, text_width, wrap};
pub use series::{Rule, Series};

/// Height of a frame in a row of panels, in pixels.
const STRIP: f64 = 190.0;
/// Height of the first frame of a chart of its own.
const PLATE: f64 = 380.0;

/// A picture of curves, 800 pixels wide.
///
/// ```
/// use plm_view::{Axis, Chart, Rule, Series};
///
/// let coarse_to_fine = [(1e-4, 8.0), (1e-7, 30.0), (1e-10, 110.0)];
/// let chart = Chart::new(Axis::log("error", "m").falling(), Axis::log("CPU time", "µs"))
///     .titled("Accuracy against speed")
///     .with(Series::new("method A", coarse_to_fine).marked())
///     .with_rule(Rule::vertical(1e-9, "rounding"));
/// assert!(chart.to_svg().starts_with("<svg"));
/// ```
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    note: String,
    /// The horizontal axis, common to all panels and labelled under the last one.
    x: Axis,
    panels: Vec<Panel>,
}

/// One frame with its own vertical axis, its curves and their legend.
#[derive(Clone, Debug)]
struct Panel {
    y: Axis,
    height: f64,
    series: Vec<Series>,
    rules: Vec<Rule>,
}

impl Chart {
    /// A chart with one panel, still empty.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { title: String::new(), note: String::new(), x, panels: vec![Panel::new(y, PLATE)] }
    }

    /// A chart of low panels over a common axis, none yet: each is added by [`below`](Self::below).
    pub fn rows(x: Axis) -> Self {
        Self { title: String::new(), note: String::new(), x, panels: Vec::new() }
    }

    /// The recorded quantities over time, in one panel for each unit, in the order of the columns. Readings are points; residuals have
    /// a panel of their own.
    pub fn over_time(recording: &Recording) -> Self {
        let mut kinds: Vec<(&str, bool)> = Vec::new();
        for column in recording.columns() {
            let kind = kind(column);
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
        Self {
            title: String::new(),
            note: String::new(),
            x: Axis::linear("time", "s").tight(),
            panels: kinds.into_iter().map(|kind| Panel::of_kind(recording, kind)).collect(),
        }
    }

    /// Adds a title.
    #[must_use]
    pub fn titled(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// Adds a smaller text between title and curves; `\n` begins a new line.
    #[must_use]
    pub fn noted(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }

    /// Adds a panel below the others; curves and lines that are added from now on go there.
    #[must_use]
    pub fn below(mut self, y: Axis) -> Self {
        self.panels.push(Panel::new(y, STRIP));
        self
    }

    /// Adds a curve to the last panel.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        if let Some(panel) = self.panels.last_mut() {
            panel.series.push(series);
        }
        self
    }

    /// Adds a line of reference to the last panel.
    #[must_use]
    pub fn with_rule(mut self, rule: Rule) -> Self {
        if let Some(panel) = self.panels.last_mut() {
            panel.rules.push(rule);
        }
        self
    }

    /// The picture as the text of an SVG file. It needs no font of its own and the same chart gives the same
    /// text.
    pub fn to_svg(&self) -> String {
        draw::svg(self)
    }

    /// Writes the picture as an SVG file and makes the folders above it where they are missing.
    ///
    /// # Errors
    /// If the file cannot be written; the error names it.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), io::Result::Ok(self.to_svg().into_bytes()))
    }
}

/// Columns of one kind share a panel: those of a unit, residuals apart.
fn kind(column: &Column) -> (&str, bool) {
    (&column.unit, column.role == Role::Residual)
}

impl Panel {
    fn new(y: Axis, height: f64) -> Self {
        Self { y, height, series: Vec::new(), rules: Vec::new() }
    }

    /// The columns of a panel over time.
    fn of_kind(recording: &Recording, own: (&str, bool)) -> Self {
        let times = recording.times();
        let mut series = Vec::new();
        for (index, column) in recording.columns().iter().enumerate() {
            if kind(column) == own {
                let points = times.iter().zip(recording.rows()).map(|(&time, row)| (time, row[index]));
                let one = Series::new(column.name.clone(), points);
                series.push(if column.role == Role::Motion { one } else { one.as_points() });
            }
        }
        // A series of readings is named by their quantity and a further noun.
        let has_lines = series.iter().any(|one| one.style.has_line());
        let named = series.iter().filter(|one| one.style.has_line() == has_lines);
        let quantity = label::common_quantity(named.map(|one| one.name.as_str()));
        let y = Axis::linear(quantity, own.0);
        Self { series, ..Self::new(y, STRIP) }
    }
}
