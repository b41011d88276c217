//! Recordings as tables of text.

use std::io::{self, Write};
use std::path::Path;

use csv::ReaderBuilder;

use super::{Column, Recording};
use crate::error::{Error, Unread, read_file, write_file};

const TIME: &str = "time (s)";

impl Recording {
    /// Writes times and columns as a CSV file (RFC 4180) and makes the folders above it where they are missing.
    ///
    /// The first line holds names and units, `time (s),arm.angle (deg)`. Each number is the shortest text that
    /// reads back to the same bits.
    ///
    /// # Errors
    /// If the file cannot be written, or a row has not a number for each column; the error names the file.
    pub fn write_csv(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let mut bytes = Vec::new();
        let contents = self.write_csv_to(&mut bytes).map(|()| bytes);
        write_file(path.as_ref(), contents)
    }

    /// Writes the table as CSV to `writer`; see [`Recording::write_csv`].
    ///
    /// # Errors
    /// If `writer` fails, or a row has not a number for each column.
    pub fn write_csv_to(&self, writer: impl Write) -> io::Result<()> {
        self.check()?;
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_field(TIME)?;
        for column in self.columns() {
            csv.write_field(column.heading())?;
        }
        csv.write_record(None::<&[u8]>)?;
        for (time, row) in self.times().iter().zip(self.rows()) {
            for number in std::iter::once(time).chain(row) {
                // `Debug` is the shortest text that reads back to the same bits, with an exponent where
                // `Display` would write hundreds of digits.
                csv.write_field(format!("{number:?}"))?;
            }
            csv.write_record(None::<&[u8]>)?;
        }
        csv.flush()
    }

    /// Reads a CSV file that has times in its first column, and names and units in its first line, as
    /// [`write_csv`](Self::write_csv) writes it: with a line break at the end of each line, the last one too. Without it a
    /// number at the end may have lost digits.
    ///
    /// # Errors
    /// If the file cannot be read, is none of these, or ends within a line; [`Unread::whole`] has the rows before what is wrong.
    pub fn read_csv(path: impl AsRef<Path>) -> Result<Self, Unread<Self>> {
        read_file(path.as_ref(), usize::MAX, |bytes| {
            let mut recording = Self::default();
            let problem = recording.read_csv_from(bytes).err();
            (recording, problem.into_iter().collect())
        })
    }

    fn read_csv_from(&mut self, bytes: &[u8]) -> Result<(), String> {
        let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
        let (lines, rest) = bytes.split_at(whole);
        let cut_off = || {
            let line = 1 + lines.split_inclusive(|byte| *byte == b'\n').count();
            format!("line {line}: the file is cut off there, before the line break")
        };
        let mut csv = ReaderBuilder::new().from_reader(if lines.is_empty() { rest } else { lines });
        let headings = csv.headers().map_err(|error| told(&error))?.clone();
        if headings.get(0) != Some(TIME) {
            return Err(format!("its first column is not `{TIME}`"));
        }
        if lines.is_empty() {
            return Err(cut_off());
        }
        *self = Self::new(headings.iter().skip(1).map(column));
        for record in csv.records() {
            let record = record.map_err(|error| told(&error))?;
            let line = record.position().map_or(0, csv::Position::line);
            let number = |(heading, field): (&str, &str)| {
                let number = field.trim().parse::<f64>();
                number.map_err(|_| format!("line {line}, column `{heading}`: `{field}` is no number"))
            };
            let numbers = headings.iter().zip(&record).map(number).collect::<Result<Vec<f64>, String>>()?;
            if let Some((time, row)) = numbers.split_first() {
                self.push(*time, row);
            }
        }
        if rest.is_empty() { Ok(()) } else { Err(cut_off()) }
    }
}

/// A mistake of a table in words, with its line.
fn told(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!("line {line}: {len} numbers where the first line names {expected_len} columns")
        }
        _ => error.to_string(),
    }
}

/// Of a heading: `arm.angle (deg)`.
fn column(heading: &str) -> Column {
    let parts = heading.strip_suffix(')').and_then(|text| text.rsplit_once(" ("));
    parts.unwrap_or((heading, "")).into()
}
