//! Figures of a publication beside the ones that were computed.

use std::fmt;
use std::process::ExitCode;

/// A printed figure and its counterpart.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Name, e.g. `locked xG1`.
    pub name: String,
    /// Computed value.
    pub value: f64,
    /// Unit of both.
    pub unit: String,
    /// Published value.
    pub stated: f64,
    /// How far the two may differ: the rounding or truncation of the print.
    pub tolerance: f64,
}

impl Figure {
    /// Do the two agree?
    pub fn is_reproduced(&self) -> bool {
        (self.value - self.stated).abs() <= self.tolerance
    }
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = decimals(self.tolerance) + 2;
        let Figure { name, value, unit, stated, .. } = self;
        write!(f, "{name} = {value:.digits$} {unit} (manual: {stated})")?;
        if self.is_reproduced() { Ok(()) } else { write!(f, "  MISSED by {:e}", (value - stated).abs()) }
    }
}

/// Decimals that a tolerance is worth.
fn decimals(tolerance: f64) -> usize {
    if tolerance > 0.0 { (-tolerance.log10()).ceil().clamp(0.0, 12.0) as usize } else { 0 }
}

/// The figures of one example, printed as they are found.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    list: Vec<Figure>,
}

impl Figures {
    /// No figures yet.
    pub fn new() -> Figures {
        Figures::default()
    }

    /// Prints a figure beside the manual's and remembers whether they agree.
    pub fn compare(&mut self, name: &str, value: f64, unit: &str, stated: f64, tolerance: f64) {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        let figure = Figure { name, value, unit, stated, tolerance };
        println!("{figure}");
        self.list.push(figure);
    }

    /// All figures so far.
    pub fn list(&self) -> &[Figure] {
        &self.list
    }

    /// Prints how many figures were reproduced; a failure if one was missed, or if there is none.
    pub fn finish(&self) -> ExitCode {
        let reproduced = self.list.iter().filter(|figure| figure.is_reproduced()).count();
        println!("manual: {reproduced} of {} figures reproduced", self.list.len());
        let all = reproduced > 0 && reproduced == self.list.len();
        if all { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(value: f64) -> Figure {
        Figure { name: "angle".into(), value, unit: "deg".into(), stated: 68.1934, tolerance: 1e-4 }
    }

    #[test]
    fn a_figure_shows_both_values() {
        assert_eq!(figure(68.193_440_04).to_string(), "angle = 68.193440 deg (manual: 68.1934)");
        assert!(figure(68.193_440_04).is_reproduced());
    }

    #[test]
    fn a_missed_figure_says_by_how_much() {
        let missed = figure(68.5);
        assert!(!missed.is_reproduced());
        assert!(missed.to_string().contains("MISSED by 3.06"), "{missed}");
    }
}
