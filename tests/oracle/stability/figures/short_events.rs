//! Conditions that last a small part of a run.

use plm_runtime::{Dop853, Fault, Rk4};
use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row};
use crate::scenes::short_events::{braked, cleared};

pub fn conditions() -> Result<Figure, Fault> {
    let parts: Vec<f64> = (2..=12).map(|half| 10_f64.powf(-0.5 * f64::from(half))).collect();
    let mut chart = Chart::new(
        Axis::log("part of the run that the brush lasts", "").falling(),
        Axis::log("error of the speed", "rad/s"),
    )
    .titled("A rotor at 1 rad/s loses a quarter of its energy to a brush, once in 10 s")
    .noted("An `if` on the height of its tip. In the end the rounding of that height is left.");
    let (mut found, mut off, mut ended, mut early) = (0, 0.0_f64, 0, 0.0_f64);
    let intervals = [10.0, 0.1, 1e-3];
    for interval in intervals {
        let mut errors = Vec::new();
        for part in &parts {
            let ([_, speed], stats) = braked(*part, interval, Dop853::default())?;
            found += u32::from(stats.switches == 2);
            off = off.max(speed.abs());
            // A difference of zero has no place on the axis.
            errors.push((*part, speed.abs().max(1e-17)));
            if let Some(time) = cleared(*part, interval)? {
                ended += 1;
                early = early.max(time.abs());
            }
        }
        chart = chart.with(Series::new(format!("default, intervals of {interval} s"), errors).marked());
    }
    let (mut errors, mut counted) = (Vec::new(), 0);
    for part in &parts {
        let ([_, speed], stats) = braked(*part, 10.0, Rk4::new(0.01))?;
        counted += u32::from(stats.switches == 2 || stats.passed_over == 1);
        errors.push((*part, speed.abs()));
    }
    let runs = parts.len() * intervals.len();
    let all = |quantity: &str, of: usize, found: u32| {
        Row::new(quantity, format!("{of} of {of}"), format!("{found} of {of}"), found as usize == of)
    };
    let rows = vec![
        all("brush of 0.1 to 1e-6 of the run, in intervals of 10, 0.1 and 0.001 s: found", runs, found),
        Row::below("the same: speed after the run", 5e-8, " rad/s", off),
        all("`require` of the same heights: runs that it ends", runs, ended),
        Row::below("the same: time of the end", 5e-11, " s", early),
        all("RK4, 10 ms: found, or counted as passed over", parts.len(), counted),
    ];
    let chart = chart
        .with(Series::new("RK4, 10 ms", errors).muted(0))
        .with_rule(Rule::horizontal(1.0 - 0.75_f64.sqrt(), "not found"));
    Ok(Figure { slug: "brief", chart, rows })
}
