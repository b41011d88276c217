//! The sheet of a demo: the figures that the manual prints, and values that are known from elsewhere where it prints none.

use std::fmt;

use plm::Fault;

/// A demo of the manual: its name there, and what runs it.
pub type Demo = (&'static str, fn() -> Result<Sheet, Fault>);

/// How the manual wrote a figure down, and how far it may therefore be from the value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// Rounded to so much.
    Rounded(f64),
    /// Digits were cut off: the value is not smaller, and larger by less than this.
    Truncated(f64),
    /// Read off a curve, or called approximate, to so much.
    Approximate(f64),
}

/// Where a known value comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// Printed in the manual.
    Manual(Reading),
    /// A closed form or a law, to so much.
    Theory(f64),
    /// Another program's run of the same demo, to so much.
    Model(f64),
}

/// A value that was computed beside the one that is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it is.
    pub name: String,
    /// What was computed.
    pub value: f64,
    /// Unit of both; `-` for a number.
    pub unit: &'static str,
    /// What is known.
    pub known: f64,
    /// Where from.
    pub source: Source,
}

/// All lines of one demo.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The demo's name in the manual.
    pub demo: &'static str,
    /// In the order in which they were found.
    pub lines: Vec<Line>,
}

impl Line {
    /// How far the value may be from the known one.
    pub fn tolerance(&self) -> f64 {
        match self.source {
            Source::Manual(
                Reading::Rounded(tolerance) | Reading::Truncated(tolerance) | Reading::Approximate(tolerance),
            )
            | Source::Theory(tolerance)
            | Source::Model(tolerance) => tolerance,
        }
    }

    /// Is the value the known one?
    pub fn holds(&self) -> bool {
        let cut_off = matches!(self.source, Source::Manual(Reading::Truncated(_)));
        let not_below = !cut_off || self.value.abs() >= self.known.abs();
        not_below && (self.value - self.known).abs() <= self.tolerance()
    }

    /// Does the manual print it?
    pub fn is_printed(&self) -> bool {
        matches!(self.source, Source::Manual(_))
    }
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let source = match self.source {
            Source::Manual(_) => "manual",
            Source::Theory(_) => "theory",
            Source::Model(_) => "independent model",
        };
        let Line { name, value, known, .. } = self;
        let unit = if self.unit == "-" { String::new() } else { format!(" {}", self.unit) };
        let digits = decimals(self.tolerance());
        let value_shown = match *value {
            0.0 => "0".to_owned(),
            value if *known == 0.0 && digits > 6 => format!("{value:.1e}"),
            value => format!("{value:.digits$}"),
        };
        // The manual's figure as it stands there.
        let known_shown =
            if self.is_printed() || *known == 0.0 { known.to_string() } else { format!("{known:.digits$}") };
        write!(f, "{name} = {value_shown}{unit} ({source}: {known_shown})")?;
        if self.holds() { Ok(()) } else { write!(f, "  MISSED by {:e}", (value - known).abs()) }
    }
}

/// Decimals that show a little more than the tolerance.
pub fn decimals(tolerance: f64) -> usize {
    if tolerance > 0.0 { ((-tolerance.log10()).ceil() + 2.0).clamp(0.0, 12.0) as usize } else { 0 }
}

impl Sheet {
    /// A sheet without lines.
    pub fn new(demo: &'static str) -> Self {
        Self { demo, lines: Vec::new() }
    }

    fn line(&mut self, name: &str, (value, known): (f64, f64), unit: &'static str, source: Source) {
        // The sum takes the sign from a zero.
        self.lines.push(Line { name: name.to_owned(), value: value + 0.0, unit, known, source });
    }

    /// A figure of the manual.
    pub fn manual(&mut self, name: &str, value: f64, unit: &'static str, printed: f64, reading: Reading) {
        self.line(name, (value, printed), unit, Source::Manual(reading));
    }

    /// A value that a law gives.
    pub fn theory(&mut self, name: &str, value: f64, unit: &'static str, known: f64, tolerance: f64) {
        self.line(name, (value, known), unit, Source::Theory(tolerance));
    }

    /// A value of the independent model of the manual's demos.
    pub fn model(&mut self, name: &str, value: f64, unit: &'static str, known: f64, tolerance: f64) {
        self.line(name, (value, known), unit, Source::Model(tolerance));
    }

    /// How many printed figures are reproduced, of how many; and the same of the other lines.
    pub fn counts(&self) -> [(usize, usize); 2] {
        [true, false].map(|printed| {
            let lines = self.lines.iter().filter(|line| line.is_printed() == printed);
            (lines.clone().filter(|line| line.holds()).count(), lines.count())
        })
    }

    /// Does every line hold, and is there one?
    pub fn holds(&self) -> bool {
        !self.lines.is_empty() && self.lines.iter().all(Line::holds)
    }
}

impl fmt::Display for Sheet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.demo)?;
        for line in &self.lines {
            writeln!(f, "  {line}")?;
        }
        let [(reproduced, printed), (held, others)] = self.counts();
        write!(f, "other checks: {held} of {others} hold")?;
        if printed > 0 { write!(f, "\nmanual: {reproduced} of {printed} figures reproduced") } else { Ok(()) }
    }
}
