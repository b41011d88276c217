//! Readings of an experiment, from a table in units of any kind.

use plm_dynamic::Mechanism;
use plm_studies::optimise::Experiment;
use plm_view::{Column, Recording};

use crate::value::value;

/// The experiment of a table with times, outputs and inputs; of these columns alone where some are named.
///
/// # Errors
/// A unit that is none, or that of another quantity: a message.
pub fn experiment(
    readings: &Recording,
    only: &[String],
    mechanism: &Mechanism,
) -> Result<Experiment, String> {
    let columns = readings.columns();
    let is_read = |column: &Column| only.is_empty() || only.contains(&column.name);
    let kept: Vec<usize> = (0..columns.len()).filter(|k| is_read(&columns[*k])).collect();
    let mut own = Recording::new(kept.iter().map(|k| columns[*k].clone()));
    for (time, row) in readings.times().iter().zip(readings.rows()) {
        own.push(*time, kept.iter().map(|k| row[*k]).collect::<Vec<_>>());
    }
    let mut experiment = Experiment::from_recording(&own);
    for column in own.columns() {
        if let Some((si, factor)) = other_unit(column, mechanism)? {
            experiment = experiment.unit(&column.unit, si, factor);
        }
    }
    Ok(experiment)
}

/// The SI unit of a column that has another one, and by what its values are multiplied to be in SI.
fn other_unit<'a>(column: &Column, mechanism: &'a Mechanism) -> Result<Option<(&'a str, f64)>, String> {
    let mut quantities = mechanism.observables().iter().copied().chain(mechanism.inputs());
    // A column that names no unit has a message of its own.
    let is_other = |si: &str| *si != column.unit && !column.unit.is_empty();
    let own = quantities.find(|(name, si)| *name == column.name && is_other(si));
    let Some((name, si)) = own else { return Ok(None) };
    let factor = value(&format!("1 {}", column.unit), si).map_err(|why| format!("{name}: {why}"))?;
    Ok(Some((si, factor)))
}
