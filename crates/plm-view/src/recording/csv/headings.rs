//! The line of headings, and what it says of the lines of numbers.

use csv::StringRecord;

use super::super::Column;
use super::heading::{Heading, column, known_times, of_time, without_brackets};
use super::read::{Lines, fields};

/// A line with its number.
#[derive(Clone, Default)]
pub(super) struct Line {
    pub(super) number: u64,
    pub(super) fields: StringRecord,
}

/// Separators of the fields of a line that are tried.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];
/// Lines before the headings at most: instruments write dates and settings there.
const PREAMBLE: usize = 200;
/// Columns that number the lines, in small letters, as spreadsheets and tables of programs have them.
const INDICES: [&str; 10] = ["", "index", "#", "no", "no.", "nr", "nr.", "row", "sample", "unnamed: 0"];
/// Texts for a missing number, in small letters; of spreadsheets and of tables of programs.
const GAPS: [&str; 6] = ["", "na", "n/a", "#n/a", "#nv", "null"];

/// The line of headings.
pub(super) struct Headings {
    pub(super) separator: u8,
    line: u64,
    /// The last line that belongs to them: that of units, if there is one.
    pub(super) last: u64,
    pub(super) names: StringRecord,
    /// Units below the names; empty ones where there are none.
    units: Vec<String>,
    /// The column of the time.
    time: usize,
    /// Factor and divisor that convert its numbers to s.
    unit: [f64; 2],
}

impl Headings {
    /// The first line by the separator that makes one of its fields a time, with numbers below it where there are some.
    pub(super) fn find(text: &[u8], named: Option<u8>) -> Result<Self, String> {
        let separators = named.map_or_else(|| SEPARATORS.to_vec(), |own| vec![own]);
        let (mut found, mut unknown, mut most) = (Vec::new(), None, None::<Line>);
        for separator in separators {
            let mut lines = Lines::new(text, separator);
            let mut first = None;
            for _ in 0..PREAMBLE {
                let Some(line) = lines.next()? else { break };
                let is_first = first.is_none();
                first.get_or_insert_with(|| line.clone());
                if line.fields.iter().all(|field| number(field, separator).is_some()) {
                    break;
                }
                match Self::at(&line, separator) {
                    Some(Ok(own)) => {
                        found.push(own);
                        break;
                    }
                    Some(Err(why)) if is_first => unknown = unknown.or(Some(why)),
                    _ => {}
                }
            }
            let Some(first) = first else { continue };
            if most.as_ref().is_none_or(|own| own.fields.len() < first.fields.len()) {
                most = Some(first);
            }
        }
        if let Some(why) = unknown.filter(|_| found.is_empty()) {
            return Err(why);
        }
        if found.is_empty() {
            found.extend(Self::in_comment(text, named));
        }
        let has_numbers = |own: &Self| own.numbers_below(text);
        let best = found.iter().position(has_numbers).unwrap_or(0);
        if let Some(own) = found.into_iter().nth(best) {
            return Ok(own.with_units(text));
        }
        let Some(Line { number, fields }) = most else {
            return Err("found no line, expected headings, such as `time (s),arm.angle (deg)`".to_owned());
        };
        let mut words: Vec<String> = fields.iter().take(4).map(shown).collect();
        if fields.len() > words.len() {
            words.push("…".to_owned());
        }
        Err(format!(
            "line {number}: found {}, expected a column of the time, such as `time (s)` or `t (ms)`",
            words.join(", ")
        ))
    }

    /// A line as headings, if one of its fields is a time; the message where its unit is not known.
    fn at(line: &Line, separator: u8) -> Option<Result<Self, String>> {
        let mut unknown = None;
        for (time, name) in line.fields.iter().enumerate() {
            match Heading::of(name) {
                Heading::Other => {}
                Heading::Time(unit) => {
                    let empty = line.fields.iter().rev().take_while(|name| name.is_empty()).count();
                    let names: StringRecord = line.fields.iter().take(line.fields.len() - empty).collect();
                    let units = vec![String::new(); names.len()];
                    let (line, last) = (line.number, line.number);
                    return Some(Ok(Self { separator, line, last, names, units, time, unit }));
                }
                Heading::Unit => {
                    let (line, column, known) = (line.number, time + 1, known_times());
                    unknown = unknown.or(Some(format!(
                        "line {line}, column {column}: found `{name}`, expected a time in one of {known}"
                    )));
                }
            }
        }
        unknown.map(Err)
    }

    /// The headings that stand after `#` or `%` above the numbers, as NumPy writes them.
    fn in_comment(text: &[u8], named: Option<u8>) -> Option<Self> {
        let text = std::str::from_utf8(text).ok()?;
        let separators = named.map_or_else(|| SEPARATORS.to_vec(), |own| vec![own]);
        let comments = text.lines().enumerate().take(PREAMBLE);
        let own = comments.filter_map(|(at, line)| Some((at, line.trim_start().strip_prefix(['#', '%'])?)));
        own.flat_map(|own| separators.iter().map(move |separator| (own, *separator))).find_map(
            |((at, line), separator)| {
                let fields = fields(line, separator).filter(|fields| fields.len() > 1)?;
                Self::at(&Line { number: at as u64 + 1, fields }, separator)?.ok()
            },
        )
    }

    /// Is there a number in the column of the time soon below?
    fn numbers_below(&self, text: &[u8]) -> bool {
        let mut lines = Lines::new(text, self.separator);
        let below = std::iter::from_fn(|| lines.next().ok().flatten()).filter(|line| line.number > self.line);
        below.take(2).any(|line| {
            line.fields.get(self.time).is_some_and(|field| number(field, self.separator).is_some())
        })
    }

    /// With the line of units below the names, if there is one: the unit of a time stands in the column of the time.
    fn with_units(mut self, text: &[u8]) -> Self {
        let mut lines = Lines::new(text, self.separator);
        let mut below = std::iter::from_fn(|| lines.next().ok().flatten());
        let Some(line) = below.find(|line| line.number > self.line) else { return self };
        let has_number = line.fields.iter().any(|field| number(field, self.separator).is_some());
        // Texts without a unit of the time are no units: they are reported as no numbers.
        let unit = line.fields.get(self.time).map(without_brackets).and_then(of_time);
        let Some(unit) = unit.filter(|_| !has_number) else { return self };
        if self.unit == [1.0, 1.0] {
            self.unit = unit;
        }
        self.units = line.fields.iter().map(|unit| without_brackets(unit).to_owned()).collect();
        self.units.resize(self.names.len(), String::new());
        self.last = line.number;
        self
    }

    /// The columns but that of the time, by their places, without those that number the lines and those that have neither a heading nor a
    /// number.
    ///
    /// # Errors
    /// A column of numbers without a heading.
    pub(super) fn columns(&self, rows: &[(f64, Vec<f64>)]) -> Result<Vec<(usize, Column)>, String> {
        let mut columns = Vec::new();
        for (at, name) in self.names.iter().enumerate().filter(|(at, _)| *at != self.time) {
            let values = || rows.iter().map(|(_, row)| row[at]);
            let has_numbers = values().any(|value| !value.is_nan());
            let counts = values().zip(values().skip(1)).all(|(one, next)| next - one == 1.0)
                && values().all(|value| value.fract() == 0.0);
            // Tables of this library have the time in front: no column of theirs is taken for one of numbers of lines.
            let is_index =
                at == 0 && INDICES.contains(&name.to_lowercase().as_str()) && counts && has_numbers;
            // LabVIEW has a column of comments after the others.
            let is_comment = self.separator == b'\t' && name.eq_ignore_ascii_case("comment");
            if is_index || (!has_numbers && (name.is_empty() || is_comment)) {
                continue;
            }
            if name.is_empty() {
                let (line, column) = (self.line, at + 1);
                return Err(format!("line {line}, column {column}: found no heading of a column of numbers"));
            }
            let mut own = column(name);
            if own.unit.is_empty() {
                own.unit = column(&format!("x ({})", self.units[at])).unit;
            }
            columns.push((at, own));
        }
        Ok(columns)
    }

    /// The numbers of a line: the time, s, and those of all columns.
    pub(super) fn row(&self, Line { number: line, fields }: &Line) -> Result<(f64, Vec<f64>), String> {
        let is_longer = fields.iter().skip(self.names.len()).any(|field| !field.is_empty());
        if fields.len() < self.names.len() || is_longer {
            let [found, expected] = [fields.len(), self.names.len()].map(fields_in_words);
            return Err(format!("line {line}: found {found}, expected {expected}, as in line {}", self.line));
        }
        let (mut time, mut row) = (f64::NAN, Vec::with_capacity(fields.len()));
        for (at, (field, heading)) in fields.iter().zip(&self.names).enumerate() {
            let is_gap = at != self.time && GAPS.contains(&field.to_lowercase().as_str());
            let number = if is_gap { Some(f64::NAN) } else { number(field, self.separator) };
            let number = number.ok_or_else(|| self.no_number((*line, at), (field, heading)))?;
            if at == self.time {
                let [by, over] = self.unit;
                time = number * by / over;
            }
            row.push(number);
        }
        Ok((time, row))
    }

    /// The message on a last field that is empty.
    pub(super) fn gap(&self, line: &Line) -> Result<(f64, Vec<f64>), String> {
        let at = line.fields.len().saturating_sub(1);
        Err(self.no_number((line.number, at), ("", self.names.get(at).unwrap_or_default())))
    }

    fn no_number(&self, (line, at): (u64, usize), (field, heading): (&str, &str)) -> String {
        let found = if field.is_empty() { "nothing".to_owned() } else { shown(field) };
        let expected = if at == self.time { "a number" } else { "a number, or `NaN` where there is none" };
        format!("line {line}, column {} (`{heading}`): found {found}, expected {expected}", at + 1)
    }
}

fn number(field: &str, separator: u8) -> Option<f64> {
    let number = field.parse().ok();
    // A point beside the comma would be one of thousands.
    let has_comma = separator != b',' && !field.contains('.');
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
