//! Long runs: drift of joints and energy, phase, chaos.

use plm_run::AnyMethod;
use plm_runtime::method::Gauss;
use plm_runtime::{Dop853, Fault, Rk4};
use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row, so_far};
use crate::scenes::dead::{bars, energy, quadrorhomb_on_a_spring};
use crate::scenes::pins::{FOUR_BAR, QUADRORHOMB, open};
use crate::scenes::run::{Trace, trace};
use crate::scenes::standard;
use crate::scenes::theory::S1_AT_10;
use crate::scenes::trees::{pendulum, phase};
use crate::text::{By as _, Large, Named as _, Scene, deep};

/// Step of the long runs, s.
const STEP: f64 = 1e-3;

/// Relative change of the energy, phi (m), phi_dot (m/s), a thousand times.
type Drift = Trace<3>;

fn four_bar(method: impl Into<AnyMethod<Scene>>, until: f64) -> Result<Drift, Fault> {
    let mut sim = standard::four_bar().by(method)?;
    let energy = sim.kinetic_energy() + sim.gravity_energy();
    Ok(trace(&mut sim, until, until / 1000.0, |s| {
        let [phi, phi_dot] = open(&["crank", "coupler", "rocker"].map(|bar| s.body_of(bar)), &FOUR_BAR);
        [(s.kinetic_energy() + s.gravity_energy()) / energy - 1.0, phi, phi_dot]
    }))
}

fn quadrorhomb(method: impl Into<AnyMethod<Large>> + Send + 'static, until: f64) -> Result<Drift, Fault> {
    deep(move || {
        let mut sim = quadrorhomb_on_a_spring().by(method)?;
        let begun = energy(&sim);
        Ok(trace(&mut sim, until, until / 1000.0, |s| {
            let [phi, phi_dot] = open(&bars(s), &QUADRORHOMB);
            [energy(s) / begun - 1.0, phi, phi_dot]
        }))
    })
}

pub fn drift_of_the_four_bar(steps: u32) -> Result<Figure, Fault> {
    let eighth = Dop853::new(1e-9).with_longest_step(STEP).with_most_steps(u64::MAX);
    let until = f64::from(steps) * STEP;
    let runs = [
        ("DOP853, steps of 1 ms", four_bar(eighth, until)?),
        ("Gauss 6, steps of 1 ms", four_bar(Gauss::<_, 3>::new(STEP), until)?),
        ("RK4, steps of 1 ms", four_bar(Rk4::new(STEP), until)?),
    ];
    let coarse = four_bar(Rk4::new(2.0 * STEP), until)?;
    Ok(drifting("four-bar", ("S2, four-bar linkage", 1.0), steps, &runs, &coarse))
}

pub fn drift_of_the_quadrorhomb(steps: u32) -> Result<Figure, Fault> {
    let eighth = Dop853::new(1e-9).with_longest_step(STEP).with_most_steps(u64::MAX);
    let until = f64::from(steps) * STEP;
    let runs = [
        ("DOP853, steps of 1 ms", quadrorhomb(eighth, until)?),
        ("Gauss 6, steps of 1 ms", quadrorhomb(Gauss::<_, 3>::new(STEP), until)?),
        ("RK4, steps of 1 ms", quadrorhomb(Rk4::new(STEP), until)?),
    ];
    let coarse = quadrorhomb(Rk4::new(2.0 * STEP), until)?;
    let scene = ("Quadrorhomb, swinging on a spring from 40 deg", 1.6);
    Ok(drifting("quadrorhomb-swings", scene, steps, &runs, &coarse))
}

/// `coarse` is the run of Runge-Kutta 4 with steps twice as long.
fn drifting(
    slug: &'static str,
    (name, length): (&str, f64),
    steps: u32,
    runs: &[(&'static str, Drift)],
    coarse: &Drift,
) -> Figure {
    let rounding = 64.0 * f64::EPSILON * length;
    let mut rows = Vec::new();
    for (method, trace) in runs {
        let [energy, phi, phi_dot] = [0, 1, 2].map(|column| trace.largest(column));
        let of = |what| format!("{name}, {steps} steps, {method}: {what}");
        rows.push(Row::end(of("end"), &trace.end));
        if method.starts_with("RK4") {
            // An oscillation of w loses (w h)^6/72 of its energy a step: of order 5 in a second. What comes and goes within a
            // swing is of order 4, and most of it in a short run.
            let ratio = coarse.largest(0) / energy;
            rows.push(Row::new(
                of("energy, and how much more with steps of 2 ms"),
                "16 to 32 times",
                format!("{energy:.1e}, {ratio:.1} times"),
                (15.0..34.0).contains(&ratio),
            ));
        } else {
            rows.push(Row::below(of("energy"), 1e-11, "", energy));
        }
        rows.push(Row::below(of("phi"), rounding, " m", phi));
        rows.push(Row::below(of("phi_dot"), rounding, " m/s", phi_dot));
    }
    let mut chart = Chart::new(Axis::log("time", "s"), Axis::log("change of energy so far", ""))
        .titled(format!("{name}: {steps} steps of 1 ms"))
        .noted("Joints recomputed from exported poses and velocities; L is the length of the mechanism.")
        .with_rule(Rule::horizontal(1e-11, "1e-11"));
    for (method, trace) in runs {
        chart = chart.with(Series::new(*method, so_far(after(trace, 0))));
    }
    for (quantity, unit, column) in [("phi so far", "m", 1), ("phi_dot so far", "m/s", 2)] {
        chart = chart.below(Axis::log(quantity, unit)).with_rule(Rule::horizontal(rounding, "64 eps L"));
        for (method, trace) in runs {
            chart = chart.with(Series::new(*method, so_far(after(trace, column))));
        }
    }
    Figure { slug, chart, rows }
}

/// A column over time, without its start, which has no place on a logarithmic axis.
fn after<const N: usize>(trace: &Trace<N>, column: usize) -> Vec<(f64, f64)> {
    trace.over_time(column).into_iter().filter(|(time, _)| *time > 0.0).collect()
}

pub fn a01(until: f64) -> Result<Figure, Fault> {
    let runs = [
        ("default (1e-9)", phase(&mut pendulum().begin()?, until, 1.0)),
        ("DOP853, 1e-12", phase(&mut pendulum().by(Dop853::new(1e-12))?, until, 1.0)),
        ("Gauss 6, 10 ms", phase(&mut pendulum().by(Gauss::<_, 3>::new(0.01))?, until, 1.0)),
        ("RK4, 1 ms", phase(&mut pendulum().by(Rk4::new(1e-3))?, until, 1.0)),
    ];
    let mut rows = Vec::new();
    let mut chart = Chart::new(Axis::log("time", "s"), Axis::log("error of the phase so far", "rad"))
        .titled(format!("A01, simple pendulum of 1 m over {until} s"))
        .noted("Against the elliptic function. Energy alone does not tell: a wrong frequency adds up.");
    for (method, trace) in &runs {
        rows.push(Row::end(format!("A01 over {until} s, {method}"), &trace.end));
        // A step loses the part (w h)^4/120 (RK4) or (w h)^6/100800 (Gauss) of its phase of w h; w is 3.1 1/s.
        let bound = match *method {
            "default (1e-9)" => 1e-3,
            "Gauss 6, 10 ms" => 1e-9,
            _ => 1e-7,
        };
        rows.push(Row::below(
            format!("A01 over {until} s, {method}: phase"),
            bound,
            " rad",
            trace.largest(0),
        ));
        chart = chart.with(Series::new(*method, so_far(after(trace, 0))));
    }
    chart = chart.below(Axis::log("error of the energy so far", "J"));
    for (method, trace) in &runs {
        chart = chart.with(Series::new(*method, so_far(after(trace, 1))));
    }
    Ok(Figure { slug: "a01", chart, rows })
}

pub fn chaos() -> Result<Figure, Fault> {
    let mut errors = Vec::new();
    for k in 18..=26 {
        let rtol = 10_f64.powf(-0.5 * f64::from(k));
        let mut sim = standard::double_pendulum().by(Dop853::new(rtol))?;
        sim.step(10.0)?;
        let [arm, forearm] = S1_AT_10;
        errors.push((
            rtol,
            (sim.body_of("arm").angle - arm).abs().max((sim.body_of("forearm").angle - forearm).abs()),
        ));
    }
    let best = errors.iter().map(|(_, error)| *error).fold(f64::INFINITY, f64::min);
    let rows = vec![Row::new(
        "S1 over 10 s: best of all tolerances",
        "rounding grows to about 1e-7 rad",
        format!("{best:.1e} rad"),
        (1e-10..1e-5).contains(&best),
    )];
    let chart = Chart::new(
        Axis::log("relative tolerance of DOP853", "").falling(),
        Axis::log("error of an angle after 10 s", "rad"),
    )
    .titled("S1, double pendulum over 10 s")
    .noted("It is chaotic: rounding errors grow 1e8-fold. Below the line there is nothing to be won.")
    .with(Series::new("DOP853", errors).marked())
    .with_rule(Rule::horizontal(1e-7, "floor of rounding"));
    Ok(Figure { slug: "chaos", chart, rows })
}
