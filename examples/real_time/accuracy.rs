//! How accurate steps of fixed length are on the arm, the shorter they are: the explicit and the linearly implicit one.

use std::f64::consts::TAU;

use plm::{Fault, RadauIia5};
use plm_view::{Axis, Chart, Rule, Series};

use super::plants::{Arm, arm};

/// The controller sets the lever so often, s; it is held in between.
pub const PERIOD: f64 = 1e-3;
/// Steps in a period.
const DIVISIONS: [u32; 8] = [1, 2, 5, 10, 20, 50, 100, 200];

/// Up and down again, once a second.
pub fn lever(period: u32) -> f64 {
    0.2 * (TAU * f64::from(period) * PERIOD).sin()
}

/// What is compared: the angle, rad, and the pressures in cylinder and lines, Pa.
type Sample = [f64; 5];

fn sample(state: &arm::State) -> Sample {
    [
        state.arm().angle,
        state.press_pressure1(),
        state.press_pressure2(),
        state.line1_pressure(),
        state.line2_pressure(),
    ]
}

/// A run of so many periods by a step of fixed length, with so many steps in a period.
///
/// # Errors
/// What ends a step: with steps that are too long the explicit formula leaves all bounds.
pub fn run(
    periods: u32,
    division: u32,
    step: impl Fn(&mut arm::State, f64) -> Result<(), Fault>,
) -> Result<Vec<Sample>, Fault> {
    let mut state = *Arm::new().start()?.state();
    let h = PERIOD / f64::from(division);
    let mut samples = Vec::new();
    for period in 0..periods {
        state.input.lever = lever(period);
        for _ in 0..division {
            step(&mut state, h)?;
        }
        samples.push(sample(&state));
    }
    Ok(samples)
}

/// The same run to a tolerance, by a method of another family.
///
/// # Errors
/// None that is known.
pub fn reference(periods: u32) -> Result<Vec<Sample>, Fault> {
    let mut sim = Arm::new().start_with(RadauIia5::new(1e-11))?;
    let mut samples = Vec::new();
    for period in 0..periods {
        sim.input.lever = lever(period);
        sim.step(PERIOD)?;
        samples.push(sample(sim.state()));
    }
    Ok(samples)
}

/// The largest error of each quantity as a share of the range that it runs through.
pub fn errors(found: &[Sample], known: &[Sample]) -> Sample {
    std::array::from_fn(|k| {
        let (least, most) = known.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), sample| {
            (least.min(sample[k]), most.max(sample[k]))
        });
        let error = found.iter().zip(known).map(|(found, known)| (found[k] - known[k]).abs());
        error.fold(0.0, f64::max) / (most - least)
    })
}

/// The chart of the book, and its numbers as text.
///
/// # Errors
/// If the reference cannot be computed.
pub fn chart(periods: u32) -> Result<(Chart, String), Fault> {
    let known = reference(periods)?;
    let mut chart = Chart::new(Axis::log("step", "s"), Axis::log("largest error, of the range", ""))
        .titled("An arm on a hydraulic jack with thin lines")
        .with_rule(Rule::vertical(PERIOD, "1 kHz"));
    let mut lines = Vec::new();
    let explicit: &dyn Fn(&mut arm::State, f64) -> Result<(), Fault> = &|state, h| state.step_rk4(h);
    let implicit: &dyn Fn(&mut arm::State, f64) -> Result<(), Fault> =
        &|state, h| state.step_linearly_implicit(h);
    for (name, step) in [("linearly implicit", implicit), ("RK4", explicit)] {
        let mut curves = [Vec::new(), Vec::new()];
        for division in DIVISIONS {
            let h = PERIOD / f64::from(division);
            match run(periods, division, step) {
                Ok(found) => {
                    let [angle, pressures @ ..] = errors(&found, &known);
                    let pressure = pressures.into_iter().fold(0.0, f64::max);
                    curves[0].push((h, angle));
                    curves[1].push((h, pressure));
                    lines.push(format!(
                        "{name}, h = {h:e} s: angle {angle:.1e}, pressures {pressure:.1e} of the range"
                    ));
                }
                Err(fault) => lines.push(format!("{name}, h = {h:e} s: {fault}")),
            }
        }
        let family = usize::from(name == "RK4");
        for (variant, (quantity, curve)) in ["angle", "pressures"].into_iter().zip(curves).enumerate() {
            let series = Series::new(format!("{quantity}, {name}"), curve).marked();
            chart = chart.with(series.of_family(family, variant));
        }
    }
    Ok((chart, lines.join("\n")))
}
