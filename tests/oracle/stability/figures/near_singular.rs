//! Loops that come next to flat.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Series};

use super::{Figure, Row, so_far};
use crate::scenes::near_singular::{Passed, differing, folding, parallel, swinging};
use crate::text::By as _;

/// Length of a run, s: it passes three poses that are flat or nearly so.
const RUN: f64 = 3.0;

/// Where the linkages go: the longer crank over time.
pub fn turns() -> Result<Figure, Fault> {
    let mut angles = Chart::new(Axis::linear("time", "s"), Axis::linear("angle of the longer crank", "deg"))
        .titled("A four-bar with cranks of 0.5 m and 0.5 m + e on a ground of 2 m")
        .noted("Cranks that are alike turn on at constant speed. The longer of two that differ swings back.");
    let (mut rows, mut energies) = (Vec::new(), Vec::new());
    let differences = [("0", 0.0, 3), ("1e-14 m", 1e-14, 0), ("1e-6 m", 1e-6, 0), ("1e-2 m", 1e-2, 0)];
    for (k, (name, by, known)) in differences.into_iter().enumerate() {
        let mut sim = differing(by).begin()?;
        let trace = swinging(&mut sim, RUN);
        let degrees = trace.over_time(1).into_iter().map(|(time, angle)| (time, angle.to_degrees()));
        angles = angles.with(Series::new(format!("e = {name}"), degrees).of_family(k, k));
        energies.push(Series::new(format!("e = {name}"), so_far(trace.over_time(0))).of_family(k, k));
        rows.push(counts(format!("four-bar, e = {name}: change points"), known, sim.stats().change_points));
    }
    let chart = angles.below(Axis::log("largest change of energy", ""));
    Ok(Figure { slug: "near-flat", chart: energies.into_iter().fold(chart, Chart::with), rows })
}

/// Their errors by the difference of the lengths.
pub fn errors() -> Result<Figure, Fault> {
    type Run = fn(f64, f64) -> Result<Passed, Fault>;
    let scenes: [(_, Run, _); 2] = [("four-bar", parallel, 5e-8), ("slider-crank", folding, 2e-8)];
    let (mut rows, mut times) = (Vec::new(), Vec::new());
    let axis = Axis::log("largest relative change of energy", "").including(1e-6);
    let mut energies = Chart::new(Axis::log("|e|", "m"), axis)
        .titled("Loops that are flat but for a difference e of two lengths")
        .noted("Three nearly flat poses in 3 s. Known: I(s) s'^2 is constant, and the time of a way a quadrature.");
    for (family, (name, run, bound)) in scenes.into_iter().enumerate() {
        let (mut ends, mut counted, mut energy, mut late) = (Ok(()), 0, 0.0_f64, 0.0_f64);
        for (variant, sign) in [1.0, -1.0].into_iter().enumerate() {
            let (mut lost, mut off) = (Vec::new(), Vec::new());
            for decade in -14..=-2 {
                let size = 10_f64.powi(decade);
                let passed = run(sign * size, RUN)?;
                ends = ends.and(passed.end);
                counted += passed.change_points;
                (energy, late) = (energy.max(passed.energy), late.max(passed.late.abs()));
                lost.push((size, passed.energy));
                off.push((size, passed.late.abs()));
            }
            let name = format!("{name}, e {} 0", if sign > 0.0 { '>' } else { '<' });
            energies = energies.with(Series::new(name.clone(), lost).of_family(family, variant).marked());
            times.push(Series::new(name, off).of_family(family, variant).marked());
        }
        rows.push(Row::end(format!("{name}, 26 runs with e from ±1e-14 to ±1e-2 m"), &ends));
        rows.push(counts(format!("{name}: change points in them"), 0, counted));
        rows.push(Row::below(format!("{name}: energy"), 1e-7, "", energy));
        rows.push(Row::below(format!("{name}: time of the way"), bound, " s", late));
    }
    let chart = energies.below(Axis::log("error of the time of the way", "s").including(1e-7));
    Ok(Figure { slug: "near-flat-errors", chart: times.into_iter().fold(chart, Chart::with), rows })
}

fn counts(quantity: String, known: u64, found: u64) -> Row {
    Row::new(quantity, known.to_string(), found.to_string(), found == known)
}
