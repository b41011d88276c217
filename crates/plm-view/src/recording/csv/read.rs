//! Tables of text as instruments, spreadsheets and programs write them.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::super::Recording;
use super::headings::{Headings, Line};
use super::text::{self, Text};

/// Reads a table into an empty recording, as far as it is right.
///
/// # Errors
/// The first mistake with its line and column, the text found and the expected one.
pub(super) fn into(recording: &mut Recording, bytes: &[u8]) -> Result<(), String> {
    let Text { lines: mut text, notice } = Text::of(bytes)?;
    let named = text::named_separator(&mut text);
    let headings = Headings::find(&text, named)?;
    let mut rows = Vec::new();
    let end = read(&headings, &text, &mut rows);
    let columns = headings.columns(&rows)?;
    *recording = Recording::new(columns.iter().map(|(_, column)| column.clone()));
    recording.about.notices.extend(notice);
    for (time, row) in &rows {
        recording.push(*time, columns.iter().map(|(at, _)| row[*at]).collect::<Vec<_>>());
    }
    end
}

/// Reads the lines of numbers below the headings: the time, s, and the numbers of all columns.
fn read(headings: &Headings, text: &[u8], rows: &mut Vec<(f64, Vec<f64>)>) -> Result<(), String> {
    let mut lines = Lines::new(text, headings.separator);
    let mut next = lines.next()?;
    while let Some(line) = next {
        let after = lines.next();
        let may_be_cut = text.last() != Some(&b'\n') && matches!(after, Ok(None));
        if line.number > headings.last {
            // A gap is nothing between two separators: nothing at the very end may be half of a line.
            let ends_open = line.fields.len() <= headings.names.len()
                && line.fields.iter().next_back().is_some_and(str::is_empty);
            let row = if may_be_cut && ends_open { headings.gap(&line) } else { headings.row(&line) };
            let told = |what| if may_be_cut { format!("{what}; the file is cut off there") } else { what };
            rows.push(row.map_err(told)?);
        }
        next = after?;
    }
    Ok(())
}

/// Lines that are neither blank nor comments, as fields.
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    reader: csv::Reader<&'a [u8]>,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8], separator: u8) -> Self {
        let mut builder = ReaderBuilder::new();
        builder.delimiter(separator).comment(Some(b'#')).has_headers(false).flexible(true).trim(Trim::All);
        Self { bytes, reader: builder.from_reader(bytes) }
    }

    /// The next line with its number.
    pub(super) fn next(&mut self) -> Result<Option<Line>, String> {
        let mut fields = StringRecord::new();
        while self.reader.read_record(&mut fields).map_err(|error| error.to_string())? {
            let is_comment = fields.get(0).is_some_and(|field| field.starts_with('#'));
            if !is_comment && fields.iter().any(|field| !field.is_empty()) {
                let number = fields.position().map_or(0, |at| self.line(at));
                return Ok(Some(Line { number, fields }));
            }
        }
        Ok(None)
    }

    /// The line of a record. Its position is that of comments and empty lines before it.
    fn line(&self, at: &csv::Position) -> u64 {
        let from = usize::try_from(at.byte()).unwrap_or_default();
        let rest = self.bytes.get(from..).unwrap_or_default();
        let is_skipped =
            |line: &&[u8]| line.first() == Some(&b'#') || line.iter().all(|byte| b"\r\n".contains(byte));
        at.line() + rest.split_inclusive(|byte| *byte == b'\n').take_while(is_skipped).count() as u64
    }
}

/// The fields of one line.
pub(super) fn fields(line: &str, separator: u8) -> Option<StringRecord> {
    Lines::new(line.as_bytes(), separator).next().ok().flatten().map(|line| line.fields)
}
