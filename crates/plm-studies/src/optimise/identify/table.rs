//! An identification as a table of text.

use std::fmt::Write;

use super::fit::{Estimate, Figure, Fit};
use crate::optimise::mechanism::Optimisable;

impl<M: Optimisable> Fit<M> {
    /// A line for each unknown: its value, its standard deviation, its unit, and its correlations with the unknowns above. Below stand
    /// combinations that no reading determines, the residuals of each output, and the reading that is farthest from the model.
    pub fn table(&self) -> String {
        let heads = ["unknown", "value", "deviation", "unit", "correlation"].map(str::to_owned);
        let correlation = self.correlation();
        let mut lines: Vec<Vec<String>> = vec![heads.to_vec()];
        for (i, estimate) in self.estimates.iter().enumerate() {
            let mut line = head(estimate);
            line.extend((0..=i).map(|k| match correlation[(i, k)] {
                own if own.is_finite() => format!("{own:.3}"),
                _ => "-".to_owned(),
            }));
            lines.push(line);
        }
        let mut text = aligned(&lines);
        for combination in &self.undetermined {
            let _ = writeln!(text, "{combination}");
        }
        for residuals in &self.residuals {
            let _ = writeln!(text, "{residuals}");
        }
        if let Some(farthest) = self.farthest() {
            let _ = writeln!(text, "{farthest}");
        }
        text
    }
}

/// Name, value, deviation and unit.
fn head(estimate: &Estimate) -> Vec<String> {
    let Estimate { name, experiment, value, standard_error, unit, factor, bound } = estimate;
    let name = experiment.map_or(name.clone(), |number| format!("{name} (experiment {number})"));
    let deviation = match bound {
        Some(_) => "at its bound".to_owned(),
        None if standard_error.is_infinite() => "not told".to_owned(),
        None => format!("{:.3}", Figure(standard_error / factor)),
    };
    let unit = if unit.is_empty() { "1" } else { unit };
    vec![name, format!("{:.6}", Figure(value / factor)), deviation, unit.to_owned()]
}

/// Columns of one width, two blanks apart; texts are aligned to the left, correlations to the right.
fn aligned(lines: &[Vec<String>]) -> String {
    let columns = lines.iter().map(Vec::len).max().unwrap_or_default();
    let width = |column: usize| {
        lines.iter().filter_map(|line| line.get(column)).map(|cell| cell.chars().count()).max()
    };
    let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or_default()).collect();
    let mut text = String::new();
    for (number, line) in lines.iter().enumerate() {
        let cells = line.iter().enumerate().map(|(column, cell)| {
            let width = widths[column];
            // The heading of the correlations is longer than one of them.
            if column >= 4 && number > 0 {
                format!("{cell:>6}")
            } else if column >= 4 {
                cell.clone()
            } else {
                format!("{cell:<width$}")
            }
        });
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text
}
