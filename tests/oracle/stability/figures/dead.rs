//! Dead points, branches, lock-up.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row, so_far};
use crate::scenes::dead as linkages;
use crate::scenes::theory::{QUADRORHOMB_FALL, dead_angle, quadrorhomb_limit};
use crate::text::{By as _, deep};

pub fn triple_rocker() -> Result<Figure, Fault> {
    let mut sim = linkages::triple_rocker().begin()?;
    let trace = linkages::rocking(&mut sim, 60.0);
    let dead = trace.rows.windows(2).filter(|pair| pair[0].1[3] * pair[1].1[3] < 0.0).count();
    let known = dead_angle(0.7, 1.0, 1.1).to_degrees();
    let reached = trace.largest(1).to_degrees();
    let rows = vec![
        Row::end(format!("triple rocker, 60 s, {dead} dead points"), &trace.end),
        Row::new(
            "triple rocker: where the crank turns back",
            format!("{known:.4} deg"),
            format!("{reached:.4} deg"),
            (known - reached).abs() < 6e-3,
        ),
        Row::below("triple rocker: energy over 60 s", 1e-6, "", trace.largest(0)),
        Row::new(
            "triple rocker: changes of the driving bar",
            format!("{dead} or more"),
            sim.stats().charts.to_string(),
            sim.stats().charts >= dead as u64,
        ),
    ];
    let degrees = |column| {
        let turns = trace.over_time(column).into_iter().take_while(|(time, _)| *time <= 20.0);
        turns.map(|(time, angle)| (time, angle.to_degrees())).collect::<Vec<_>>()
    };
    let sines = trace.over_time(3).into_iter().take_while(|(time, _)| *time <= 20.0);
    let chart = Chart::new(Axis::linear("time", "s"), Axis::linear("angle", "deg"))
        .titled("Triple rocker 0.7 / 0.6 / 0.5 / 1.0 m")
        .noted("Where coupler and rocker stretch, the crank cannot drive them: another bar does.")
        .with(Series::new("crank", degrees(1)))
        .with(Series::new("rocker", degrees(2)))
        .with_rule(Rule::horizontal(known, "dead point of the crank"))
        .below(Axis::linear("sin(rocker - coupler)", ""))
        .with(Series::new("0: dead point", sines));
    Ok(Figure { slug: "triple-rocker", chart, rows })
}

pub fn crank_rocker() -> Result<Figure, Fault> {
    let trace = linkages::cranking(&mut linkages::crank_rocker().begin()?, 1);
    let assembled = linkages::assembling()?;
    let worst = assembled.iter().map(|(_, off)| *off).fold(0.0, f64::max);
    let rows = vec![
        Row::end("crank-rocker, a driven turn of the crank", &trace.end),
        Row::below("crank-rocker: angles against the closed form, in motion", 1e-9, " rad", trace.largest(0)),
        Row::below("crank-rocker: the same by 361 assemblies", 1e-12, " rad", worst),
    ];
    let degrees = |(time, off): (f64, f64)| (time.to_degrees(), off);
    let driven = so_far(trace.over_time(0)).into_iter().map(degrees);
    // A difference of zero has no place on the axis.
    let assembled = assembled.into_iter().map(|(degree, off)| (degree, off.max(1e-17)));
    let chart =
        Chart::new(Axis::linear("angle of the crank", "deg"), Axis::log("largest error of an angle", "rad"))
            .titled("Crank-rocker 0.5 / 1.2 / 0.8 / 1.0 m over all angles of its crank")
            .noted("The mirror branch is off by radians.")
            .with(Series::new("driven, default method, so far", driven))
            .with(Series::new("assembled degree by degree", assembled));
    Ok(Figure { slug: "crank-rocker", chart, rows })
}

pub fn quadrorhomb() -> Result<Figure, Fault> {
    let trace = deep(|| Ok::<_, Fault>(linkages::falling(&mut linkages::quadrorhomb(0.0).begin()?)))?;
    let limit = quadrorhomb_limit().to_degrees();
    let farthest = |a: (f64, f64), b: (f64, f64)| if b.1.abs() > a.1.abs() { b } else { a };
    // The first time that it comes there; samples stand 1 ms apart.
    let until = |(time, _): &(f64, f64)| *time < QUADRORHOMB_FALL + 0.01;
    let (time, angle) = trace.over_time(1).into_iter().filter(until).fold((0.0, 0.0), farthest);
    let reached = angle.abs().to_degrees();
    let rows = vec![
        Row::new(
            "Quadrorhomb in free fall: its crank turns back",
            format!("at {QUADRORHOMB_FALL:.5} s"),
            format!("at {time:.3} s"),
            trace.survived() && (time - QUADRORHOMB_FALL).abs() < 1.5e-3,
        ),
        Row::new(
            "Quadrorhomb in free fall: angle of the crank there",
            format!("{limit:.4} deg"),
            format!("{reached:.4} deg"),
            (0.0..0.3).contains(&(limit - reached)),
        ),
        Row::below("Quadrorhomb in free fall: largest error of the energy", 1e-6, " J", trace.largest(0)),
    ];
    let degrees = trace.over_time(1).into_iter().map(|(time, angle)| (time, angle.to_degrees()));
    let chart = Chart::new(Axis::linear("time", "s"), Axis::linear("angle of the crank", "deg"))
        .titled("Quadrorhomb in free fall")
        .noted("Beyond, its cell has folded through.")
        .with(Series::new("default method", degrees))
        .with_rule(Rule::horizontal(-limit, "limit of the crank"))
        .with_rule(Rule::vertical(QUADRORHOMB_FALL, "lock-up by quadrature"))
        .below(Axis::log("largest energy so far", "J"))
        .with(Series::new("default method", so_far(trace.over_time(0))));
    Ok(Figure { slug: "quadrorhomb", chart, rows })
}
