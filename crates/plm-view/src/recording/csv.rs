//! Recordings as tables of text.

mod heading;
mod headings;
mod read;
mod text;
mod unit;

use std::io::{self, Write};
use std::path::Path;

use super::Recording;
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

    /// Reads a table of text: a line of headings, one of which is the time, then a line of numbers for each moment.
    ///
    /// It reads tables of [`write_csv`](Self::write_csv), to the bit, and tables of others: `time`, `t`, `Time [s]`, `t (ms)`, `time/s`,
    /// `time_us`, `Zeit in s` are headings of the time (in s without a unit; it is recorded in s), columns are separated by commas,
    /// semicolons or tabs or by what Excel's line `sep=;` says, and numbers may have a decimal comma where commas do not separate them.
    /// Units stand in the headings or in a line below; an empty field is a gap (NaN). Lines may end as on any system, the last one without
    /// a break. Blank lines, comments after `#`, lines before the headings, separators at the end of lines, a first column that numbers the
    /// lines and a byte-order mark are skipped. The text is UTF-8, UTF-16 with its mark, or else of code page 1252, as spreadsheets on
    /// Windows write it; a notice ([`About::notices`](super::About::notices)) reports that.
    ///
    /// A table that is cut off within its last number looks like one without the last line break; for a results file ([`Recording::write`])
    /// it is reported.
    ///
    /// # Errors
    /// If the file cannot be read or has a mistake, with its line and column; [`Unread::whole`] has the rows before it.
    pub fn read_csv(path: impl AsRef<Path>) -> Result<Self, Unread<Self>> {
        read_file(path.as_ref(), usize::MAX, |bytes| {
            let mut recording = Self::default();
            let problem = read::into(&mut recording, bytes).err();
            (recording, problem.into_iter().collect())
        })
    }
}
