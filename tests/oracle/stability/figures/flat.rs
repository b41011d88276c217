//! Flat poses.

use std::f64::consts::TAU;

use plm_runtime::{Fault, Rk4};
use plm_view::{Axis, Chart, Series};

use super::{Figure, Row, so_far};
use crate::scenes::flat::{self as linkages, folding, turning, turning_parallelogram};
use crate::scenes::run::Trace;
use crate::scenes::theory::G;
use crate::text::{By as _, deep};

/// Turns of a ladder.
const TURNS: u32 = 5;

pub fn ladders() -> Result<Figure, Fault> {
    let forty = deep(|| Ok::<_, Fault>(turning(&mut linkages::long_ladder(40).begin()?, 2, 100)))?;
    let traces = [
        ("N = 1", turning(&mut linkages::ladder(1).begin()?, TURNS, 100), TURNS),
        ("N = 2", turning(&mut linkages::ladder(2).begin()?, TURNS, 100), TURNS),
        ("N = 40", forty, 2),
        ("N = 2, RK4, 10 ms", turning(&mut linkages::ladder(2).by(Rk4::new(0.01))?, TURNS, 100), TURNS),
    ];
    let adrift = turning(&mut linkages::adrift().by(Rk4::new(0.01))?, TURNS, 100);
    let mut chart = Chart::new(
        Axis::linear("time", "s"),
        Axis::log("largest relative change of energy so far", ""),
    )
    .titled("S4, ladders of N four-bars, through their flat poses")
    .noted("Default method and formulation unless stated otherwise. At a flat pose N + 1 branches cross.");
    let mut rows = Vec::new();
    for (name, trace, turns) in traces {
        let after = trace.last()[3] + f64::from(turns) * TAU;
        rows.push(Row::end(format!("S4, {name}: {turns} turns"), &trace.end));
        rows.push(Row::below(format!("S4, {name}: energy"), 1e-7, "", trace.largest(0)));
        rows.push(Row::below(format!("S4, {name}: windows askew"), 1e-12, " rad", trace.largest(2)));
        if !name.contains("RK4") {
            rows.push(Row::below(
                format!("S4, {name}: angle after {turns} turns"),
                1e-7,
                " rad",
                after.abs(),
            ));
        }
        chart = chart.with(Series::new(name, so_far(trace.over_time(0))));
    }
    rows.push(Row::new(
        "S4, N = 2, RK4, 10 ms, joints not stabilised",
        "fails",
        told(&adrift),
        adrift.largest(0) > 0.1,
    ));
    chart =
        chart.with(Series::new("N = 2, not stabilised, RK4, 10 ms", so_far(adrift.over_time(0))).muted(0));
    Ok(Figure { slug: "ladders", chart, rows })
}

fn told(trace: &Trace<4>) -> String {
    let end = trace.end.as_ref().map_or_else(ToString::to_string, |()| "runs on".to_owned());
    format!("energy off by {:.1e}, windows askew by {:.1e} rad; {end}", trace.largest(0), trace.largest(2))
}

pub fn folded() -> Result<Figure, Fault> {
    let traces = [
        (
            "bars of 1 m and a slider",
            4.0 * 5.0 / 3.0 + 8.0 + G * 0.5_f64.sqrt(),
            folding(&mut linkages::folded().begin()?, 10.0),
        ),
        (
            "r = l, pin in a slot",
            39.0 + G * 0.75_f64.sqrt(),
            folding(&mut linkages::equal_bars().begin()?, 10.0),
        ),
    ];
    let mut chart =
        Chart::new(Axis::linear("time", "s"), Axis::log("largest relative change of energy so far", ""))
            .titled("Slider-cranks that fold")
            .noted("At a crank angle of 90 deg the rod lies on the crank, and two branches cross.");
    let mut rows = Vec::new();
    for (name, known, trace) in traces {
        let change = |(time, energy): (f64, f64)| (time, energy / known - 1.0);
        let changes = so_far(trace.over_time(0).into_iter().map(change).collect());
        let lost = changes.last().map_or(0.0, |(_, lost)| *lost);
        rows.push(Row::end(format!("{name}: 10 s"), &trace.end));
        rows.push(Row::new(
            format!("{name}: energy after 10 s"),
            format!("{known:.4} J"),
            format!("{:.4} J", trace.last()[0]),
            lost < 1e-6,
        ));
        rows.push(Row::below(format!("{name}: mirror image"), 1e-12, " rad", trace.largest(1)));
        chart = chart.with(Series::new(name, changes));
    }
    Ok(Figure { slug: "folded", chart, rows })
}

pub fn parallelogram() -> Result<Figure, Fault> {
    let mut sim = linkages::parallelogram().begin()?;
    let trace = turning_parallelogram(&mut sim, TURNS);
    let rows = vec![
        Row::end("parallelogram, 5 turns through 10 change points", &trace.end),
        Row::below("parallelogram: energy", 1e-9, "", trace.largest(0)),
        Row::below("parallelogram: bars askew", 1e-12, " rad", trace.largest(1)),
        Row::below("parallelogram: angle against a turn at constant speed", 1e-8, " rad", trace.largest(2)),
        Row::new(
            "parallelogram: change points that were counted",
            "10",
            sim.stats().change_points.to_string(),
            sim.stats().change_points == 10,
        ),
    ];
    let chart = Chart::new(Axis::linear("time", "s"), Axis::log("largest difference so far", "rad"))
        .titled("A parallelogram of 2 m by 0.5 m turns at constant speed")
        .noted("At a change point, twice a turn, it could go on as an antiparallelogram: it would be askew by radians.")
        .with(Series::new("bars askew", so_far(trace.over_time(1))))
        .with(Series::new("turn of the crank", so_far(trace.over_time(2))));
    Ok(Figure { slug: "parallelogram", chart, rows })
}
