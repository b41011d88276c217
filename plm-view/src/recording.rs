//! A table of samples over time.

use std::io::{self, Write};
use std::path::Path;

use crate::error::{Error, write_file};

/// What one number of a row is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name as in the declaration, such as `arm.angle`.
    pub name: String,
    /// Unit of the numbers as in the declaration, such as `N*m`; empty for a pure number.
    pub unit: String,
}

impl Column {
    /// `arm.angle (deg)`; the name alone for a pure number.
    fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} ({})", self.name, self.unit) }
    }
}

impl<N: Into<String>, U: Into<String>> From<(N, U)> for Column {
    fn from((name, unit): (N, U)) -> Self {
        Self { name: name.into(), unit: unit.into() }
    }
}

/// Samples of `N` quantities over time, in the order in which they were taken.
///
/// The number of quantities is part of the type: a row with one number too many or too few does not compile.
#[derive(Clone, Debug)]
pub struct Recording<const N: usize> {
    columns: [Column; N],
    times: Vec<f64>,
    rows: Vec<[f64; N]>,
}

impl<const N: usize> Recording<N> {
    /// An empty recording of these columns, each `(name, unit)`.
    pub fn new<C: Into<Column>>(columns: [C; N]) -> Self {
        Self { columns: columns.map(Into::into), times: Vec::new(), rows: Vec::new() }
    }

    /// Adds the sample `row`, in the units of the columns, taken at `time` (s).
    ///
    /// Every number is kept, NaN and infinities too: they show where a run went wrong.
    pub fn push(&mut self, time: f64, row: [f64; N]) {
        self.times.push(time);
        self.rows.push(row);
    }

    /// The columns after the time.
    pub fn columns(&self) -> &[Column; N] {
        &self.columns
    }

    /// The times of the samples (s).
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The samples, one row for each time.
    pub fn rows(&self) -> &[[f64; N]] {
        &self.rows
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Writes the table as a CSV file (RFC 4180) and makes the folders above it where they are missing.
    ///
    /// The first line holds names and units, `time (s),arm.angle (deg)`. Each number is the shortest text that
    /// reads back to the same bits.
    ///
    /// # Errors
    /// If the file cannot be written; the error names it.
    pub fn write_csv(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let mut bytes = Vec::new();
        let contents = self.write_csv_to(&mut bytes).map(|()| bytes);
        write_file(path.as_ref(), contents)
    }

    /// Writes the table as CSV to `writer`; see [`Recording::write_csv`].
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write_csv_to(&self, writer: impl Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_field("time (s)")?;
        for column in &self.columns {
            csv.write_field(column.heading())?;
        }
        csv.write_record(None::<&[u8]>)?;
        for (time, row) in self.times.iter().zip(&self.rows) {
            for number in std::iter::once(time).chain(row) {
                // `Debug` is the shortest text that reads back to the same bits, with an exponent where
                // `Display` would write hundreds of digits.
                csv.write_field(format!("{number:?}"))?;
            }
            csv.write_record(None::<&[u8]>)?;
        }
        csv.flush()
    }
}
