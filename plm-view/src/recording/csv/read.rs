//! Tables of text as instruments, spreadsheets and programs write them.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::super::{Column, Recording};

/// What stands between the fields of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Comma,
    /// Numbers may have a decimal comma then.
    Semicolon,
    Tab,
}

const SEPARATORS: [Separator; 3] = [Separator::Comma, Separator::Semicolon, Separator::Tab];

/// Names of the time, in small letters.
const TIMES: [&str; 2] = ["time", "t"];

/// Units of the time. A number in one is multiplied by the first and divided by the second to be in s: 0.001 is no number of two's powers,
/// and 100 ms are to be 0.1 s.
const UNITS: [(&str, [f64; 2]); 12] = [
    ("s", [1.0, 1.0]),
    ("ms", [1.0, 1e3]),
    ("us", [1.0, 1e6]),
    ("ns", [1.0, 1e9]),
    ("min", [60.0, 1.0]),
    ("h", [3600.0, 1.0]),
    ("sec", [1.0, 1.0]),
    ("seconds", [1.0, 1.0]),
    ("msec", [1.0, 1e3]),
    // Both letters that are read as micro.
    ("\u{b5}s", [1.0, 1e6]),
    ("\u{3bc}s", [1.0, 1e6]),
    ("minutes", [60.0, 1.0]),
];

/// Reads a table into an empty recording, as far as it is right.
///
/// # Errors
/// What is wrong, with its line and column, what was found and what was expected.
pub(super) fn into(recording: &mut Recording, bytes: &[u8]) -> Result<(), String> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err("line 1: found UTF-16, expected text in UTF-8".to_owned());
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let headings = Headings::find(bytes)?;
    *recording = Recording::new(headings.others().map(column));
    let mut lines = Lines::new(bytes, headings.separator);
    while let Some((line, fields)) = lines.next()? {
        if line > headings.line {
            let (time, row) = headings.row(line, &fields).map_err(|what| {
                let is_last = bytes.last() != Some(&b'\n') && lines.next().is_ok_and(|line| line.is_none());
                if is_last { format!("{what}; the file is cut off there") } else { what }
            })?;
            recording.push(time, row);
        }
    }
    Ok(())
}

/// Lines that are neither blank nor comments, as fields.
struct Lines<'a> {
    bytes: &'a [u8],
    reader: csv::Reader<&'a [u8]>,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8], separator: Separator) -> Self {
        let delimiter = match separator {
            Separator::Comma => b',',
            Separator::Semicolon => b';',
            Separator::Tab => b'\t',
        };
        let mut builder = ReaderBuilder::new();
        builder.delimiter(delimiter).comment(Some(b'#')).has_headers(false).flexible(true).trim(Trim::All);
        Self { bytes, reader: builder.from_reader(bytes) }
    }

    /// The next line with its number.
    fn next(&mut self) -> Result<Option<(u64, StringRecord)>, String> {
        let mut fields = StringRecord::new();
        while self.reader.read_record(&mut fields).map_err(|error| self.told(&error))? {
            let is_comment = fields.get(0).is_some_and(|field| field.starts_with('#'));
            if !is_comment && fields.iter().any(|field| !field.is_empty()) {
                let line = fields.position().map_or(0, |at| self.line(at));
                return Ok(Some((line, fields)));
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

    fn told(&self, error: &csv::Error) -> String {
        match error.kind() {
            csv::ErrorKind::Utf8 { pos, err } => {
                let line = pos.as_ref().map_or(0, |at| self.line(at));
                format!(
                    "line {line}, column {}: found bytes that are no text, expected UTF-8",
                    err.field() + 1
                )
            }
            _ => error.to_string(),
        }
    }
}

/// The line of headings.
struct Headings {
    separator: Separator,
    line: u64,
    names: StringRecord,
    /// The column of the time.
    time: usize,
    /// What its numbers are multiplied and divided by to be in s.
    unit: [f64; 2],
}

impl Headings {
    /// The first line by the separator that makes one of its fields a time.
    fn find(bytes: &[u8]) -> Result<Self, String> {
        let mut most: Option<(u64, StringRecord)> = None;
        for separator in SEPARATORS {
            let Some((line, names)) = Lines::new(bytes, separator).next()? else {
                return Err("found no line, expected headings, such as `time (s),arm.angle (deg)`".to_owned());
            };
            for (time, name) in names.iter().enumerate() {
                match Heading::of(name) {
                    Heading::Other => {}
                    Heading::Time(unit) => return Ok(Self { separator, line, names, time, unit }),
                    Heading::Unit => {
                        let known: Vec<&str> = UNITS[..6].iter().map(|(name, _)| *name).collect();
                        let known = known.join(", ");
                        let column = time + 1;
                        return Err(format!(
                            "line {line}, column {column}: found `{name}`, expected a time in one of {known}"
                        ));
                    }
                }
            }
            if most.as_ref().is_none_or(|(_, own)| own.len() < names.len()) {
                most = Some((line, names));
            }
        }
        let (line, names) = most.unwrap_or_default();
        let mut found: Vec<String> = names.iter().take(4).map(shown).collect();
        if names.len() > found.len() {
            found.push("…".to_owned());
        }
        Err(format!(
            "line {line}: found {}, expected a column of the time, such as `time (s)` or `t (ms)`",
            found.join(", ")
        ))
    }

    /// Headings but that of the time.
    fn others(&self) -> impl Iterator<Item = &str> {
        self.names.iter().enumerate().filter(|(at, _)| *at != self.time).map(|(_, name)| name)
    }

    /// The numbers of a line: the time, s, and the others.
    fn row(&self, line: u64, fields: &StringRecord) -> Result<(f64, Vec<f64>), String> {
        if fields.len() != self.names.len() {
            let [found, expected] = [fields.len(), self.names.len()].map(fields_in_words);
            return Err(format!("line {line}: found {found}, expected {expected}, as in line {}", self.line));
        }
        let (mut time, mut row) = (f64::NAN, Vec::with_capacity(fields.len()));
        for (at, (field, heading)) in fields.iter().zip(&self.names).enumerate() {
            let number = number(field, self.separator).ok_or_else(|| {
                let found = if field.is_empty() { "nothing".to_owned() } else { shown(field) };
                let expected =
                    if at == self.time { "a number" } else { "a number, or `NaN` where there is none" };
                format!("line {line}, column {} (`{heading}`): found {found}, expected {expected}", at + 1)
            })?;
            if at == self.time {
                let [by, over] = self.unit;
                time = number * by / over;
            } else {
                row.push(number);
            }
        }
        Ok((time, row))
    }
}

fn number(field: &str, separator: Separator) -> Option<f64> {
    let number = field.parse().ok();
    // A point beside the comma would be one of thousands.
    let has_comma = separator == Separator::Semicolon && !field.contains('.');
    number.or_else(|| if has_comma { field.replacen(',', ".", 1).parse().ok() } else { None })
}

/// A text between quotes, of a bounded length.
fn shown(text: &str) -> String {
    const MOST: usize = 40;
    let end = text.char_indices().nth(MOST).map_or(text.len(), |(at, _)| at);
    let more = if end < text.len() { "…" } else { "" };
    format!("`{}{more}`", text[..end].escape_debug())
}

fn fields_in_words(count: usize) -> String {
    if count == 1 { "1 field".to_owned() } else { format!("{count} fields") }
}

/// A heading, as far as it tells the time.
enum Heading {
    /// Another quantity.
    Other,
    /// The time, by what its numbers are multiplied and divided to be in s.
    Time([f64; 2]),
    /// The time in a unit that is not known.
    Unit,
}

impl Heading {
    fn of(heading: &str) -> Self {
        let apart = |mark| heading.rsplit_once(mark);
        let parts = bracketed(heading).or_else(|| apart('/')).or_else(|| apart('_'));
        let (name, unit) = parts.map_or((heading, "s"), |(name, unit)| (name.trim(), unit.trim()));
        if !TIMES.contains(&name.to_lowercase().as_str()) {
            return Self::Other;
        }
        UNITS.iter().find(|(own, _)| *own == unit).map_or(Self::Unit, |(_, factors)| Self::Time(*factors))
    }
}

/// Name and unit of a heading with brackets at its end, which may have others within: `b (N/(m/s))`.
fn bracketed(heading: &str) -> Option<(&str, &str)> {
    let (open, close) = [('(', ')'), ('[', ']')].into_iter().find(|(_, close)| heading.ends_with(*close))?;
    let mut depth = 0_usize;
    let (at, _) = heading.char_indices().rfind(|(_, letter)| {
        depth += usize::from(*letter == close);
        depth -= usize::from(*letter == open);
        depth == 0
    })?;
    let unit = heading.get(at + 1..heading.len() - 1)?;
    Some((heading.get(..at)?.trim_end(), unit.trim()))
}

/// Of a heading: `arm.angle (deg)`, `arm.angle [deg]`. Brackets without a blank before them may be part of a name: `link[2]`.
fn column(heading: &str) -> Column {
    let parts = bracketed(heading).filter(|(name, _)| heading[name.len()..].starts_with(char::is_whitespace));
    let (name, unit) = parts.unwrap_or((heading, ""));
    // A degree's sign is its unit in the language.
    (name, if unit == "\u{b0}" { "deg" } else { unit }).into()
}
