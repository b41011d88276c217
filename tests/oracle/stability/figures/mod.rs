//! The pictures, and the known value beside what came out.

pub mod dead;
pub mod dyads;
pub mod extremes;
pub mod flat;
pub mod indices;
pub mod long;
pub mod near_singular;
pub mod short_events;
pub mod stiff;
pub mod theory;
pub mod waiting;

use std::fmt::Write as _;

use plm_runtime::Fault;
use plm_view::Chart;

/// A scene: its picture, and its lines of the table.
pub struct Figure {
    /// Name of the file.
    pub slug: &'static str,
    pub chart: Chart,
    pub rows: Vec<Row>,
}

/// A line of the table.
pub struct Row {
    pub quantity: String,
    /// What theory, a closed form or a reference says.
    pub known: String,
    pub found: String,
    /// Whether it is as near as it has to be.
    pub holds: bool,
}

impl Row {
    pub fn new(
        quantity: impl Into<String>,
        known: impl Into<String>,
        found: impl Into<String>,
        holds: bool,
    ) -> Self {
        Self { quantity: quantity.into(), known: known.into(), found: found.into(), holds }
    }

    /// An error that has to stay below a bound; one that is not a number does not.
    pub fn below(quantity: impl Into<String>, bound: f64, unit: &str, found: f64) -> Self {
        Self::new(quantity, format!("< {bound:.1e}{unit}"), format!("{found:.1e}{unit}"), found < bound)
    }

    /// A run that gets to its end.
    pub fn end(quantity: impl Into<String>, end: &Result<(), Fault>) -> Self {
        let found = end.as_ref().map_or_else(ToString::to_string, |()| "survives".to_owned());
        Self::new(quantity, "survives", found, end.is_ok())
    }
}

/// The tables of all scenes, and what is not as it has to be.
#[derive(Default)]
pub struct Page {
    /// Every table between its anchors.
    pub text: String,
    missed: Vec<String>,
}

impl Page {
    /// Adds the lines of a scene; its table.
    pub fn add(&mut self, slug: &str, rows: &[Row]) -> String {
        let mut table = "| | known | found |\n|---|---|---|\n".to_owned();
        for Row { quantity, known, found, holds } in rows {
            let mark = if *holds { "" } else { " **missed**" };
            let _ = writeln!(table, "| {quantity} | {known} | {found}{mark} |");
            if !holds {
                self.missed.push(format!("{slug}: {quantity}: {found} instead of {known}"));
            }
        }
        let _ = write!(self.text, "<!-- ANCHOR: {slug} -->\n{table}<!-- ANCHOR_END: {slug} -->\n\n");
        table
    }

    /// How the program ends.
    ///
    /// # Errors
    /// The lines that are not as near to what is known as they have to be.
    pub fn outcome(&self) -> Result<(), String> {
        if self.missed.is_empty() { Ok(()) } else { Err(self.missed.join("\n")) }
    }
}

/// The largest absolute value so far, for a logarithmic axis.
pub fn so_far(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut largest = 0.0_f64;
    let sized = points.into_iter().map(|(time, value)| {
        largest = largest.max(value.abs());
        (time, largest)
    });
    sized.filter(|(_, value)| *value > 0.0).collect()
}
