//! Stiffness, and the limits of explicit steps.

use plm_runtime::method::RadauIia5;
use plm_runtime::{Dop853, Fault, Rk4};
use std::f64::consts::FRAC_PI_2;

use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row};
use crate::scenes::stiff::{bounce, growth_of_oscillation, limit, spring_pendulum, stabilised};
use crate::scenes::theory::{G, pendulum_angle};
use crate::text::{By as _, Named as _};

pub fn baumgarte() -> Figure {
    // R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 leaves [-1, 1] there.
    let known = 2.785;
    let mut chart = Chart::new(
        Axis::linear("h alpha", ""),
        Axis::log("gap of the hinge after 3000 steps", "m"),
    )
    .titled("Baumgarte's gains against the step: pendulum near rest, RK4, alpha = beta")
    .noted("Beyond the line the stabilisation itself is unstable. Projection, the default, has no gains.")
    .with_rule(Rule::vertical(known, "2.785"));
    let mut rows = Vec::new();
    for h in [1e-2, 1e-3, 1e-4] {
        let found = limit(2.0, 3.5, |h_alpha| stabilised(h, h_alpha, 1e-4, 3000) < 1e-6);
        rows.push(Row::new(
            format!("Baumgarte, RK4, h = {h:e} s: largest stable h alpha"),
            format!("{known}"),
            format!("{found:.4}"),
            (found / known - 1.0).abs() < 5e-3,
        ));
        let gaps = (0..=100).map(|k| 2.0 + 0.01 * f64::from(k));
        let gaps = gaps.map(|h_alpha| (h_alpha, stabilised(h, h_alpha, 1e-4, 3000).max(1e-20)));
        chart = chart.with(Series::new(format!("h = {h:e} s"), gaps.filter(|(_, gap)| *gap < 1e3)));
    }
    Figure { slug: "baumgarte", chart, rows }
}

pub fn end_stop() -> Figure {
    let error = |after: Result<f64, Fault>| after.map_or(f64::INFINITY, |after| (after + 1.0).abs());
    let steps = (0..=48).map(|k| 1e-6 * 10_f64.powf(f64::from(k) / 16.0));
    let fixed = steps.map(|h| (h, error(bounce(Rk4::new(h)))));
    let default = error(bounce(Dop853::default()));
    let known = 8_f64.sqrt() * 1e-4;
    let found = limit(2e-4, 4e-4, |h| growth_of_oscillation(h) < 2.0);
    let resolved = error(bounce(Rk4::new(1e-6)));
    let coarse = error(bounce(Rk4::new(4e-4)));
    let rows = vec![
        Row::below("1 kg against 1e8 N/m, default: error of the speed after", 1e-7, "", default),
        Row::below("the same, RK4, 1 us", 1e-5, "", resolved),
        Row::new("the same, RK4, 0.4 ms", "fails", format!("{coarse:.1e}"), coarse > 0.1),
        Row::new(
            "spring of 1e8 N/m: longest stable step of RK4",
            format!("{known:.4e} s"),
            format!("{found:.4e} s"),
            (found / known - 1.0).abs() < 2e-3,
        ),
    ];
    let chart = Chart::new(Axis::log("step", "s"), Axis::log("relative error of the speed after the bounce", ""))
        .titled("1 kg bounces from a stop of 1e8 N/m")
        .noted("The contact lasts 314 us. Steps of equal length miss its ends, and beyond the line they are unstable.")
        .with(Series::new("RK4", fixed.filter(|(_, error)| *error < 1e6)).marked())
        .with_rule(Rule::horizontal(default, "default method"))
        .with_rule(Rule::vertical(known, "2.83/w"));
    Figure { slug: "end-stop", chart, rows }
}

/// Angle and speed along the circle of the spring pendulum after 1 s.
fn swung(stiffness: f64, rtol: Option<f64>) -> Result<([f64; 2], u64), Fault> {
    let pendulum = spring_pendulum(stiffness);
    let read = |x: f64, y: f64, vx: f64, vy: f64| [x.atan2(-y), (vx * -y + vy * x) / x.hypot(y)];
    let Some(rtol) = rtol else {
        let mut sim = pendulum.by(Dop853::new(1e-13).with_most_steps(u64::MAX))?;
        sim.step(1.0)?;
        let bob = sim.body_of("bob");
        return Ok((read(bob.x, bob.y, bob.vx, bob.vy), sim.stats().steps));
    };
    let mut sim = pendulum.by(RadauIia5::new(rtol).with_most_steps(20_000))?;
    sim.step(1.0)?;
    let bob = sim.body_of("bob");
    Ok((read(bob.x, bob.y, bob.vx, bob.vy), sim.stats().steps))
}

/// What the angle is measured against: DOP853, or, where that takes minutes (one rounding of the length is a force of
/// 1e-4 N), the pendulum of the rigid rod, from which it differs by some g/k.
fn known_angle(stiffness: f64) -> Result<(f64, String), Fault> {
    if stiffness > 1e10 {
        return Ok((-pendulum_angle(G.sqrt(), FRAC_PI_2, 1.0), "against a rigid rod".to_owned()));
    }
    let ([angle, _], steps) = swung(stiffness, None)?;
    Ok((angle, format!("DOP853 at 1e-13: {steps}")))
}

pub fn stiff_spring() -> Result<Figure, Fault> {
    let mut chart = Chart::new(Axis::log("steps in 1 s", ""), Axis::log("error of the angle", "rad"))
        .titled("Pendulum of 1 m on a stiff spring, Radau IIA of order 5")
        .noted("Against DOP853 at 1e-13; on the stiffest spring against a rigid rod.");
    let mut rows = Vec::new();
    for stiffness in [1e2, 1e4, 1e6, 1e8, 1e10, 1e12] {
        let (angle, against) = known_angle(stiffness)?;
        let mut points = Vec::new();
        for k in 4..=20 {
            // Rounding of the force of the stiffest spring ends the tightest runs.
            let Ok(([found, _], steps)) = swung(stiffness, Some(10_f64.powf(-0.5 * f64::from(k)))) else {
                continue;
            };
            points.push((steps as f64, (found - angle).abs(), k));
        }
        let (steps, error, k) = points.last().copied().unwrap_or((0.0, f64::NAN, 0));
        rows.push(Row::new(
            format!("spring of {stiffness:.0e} N/m: Radau IIA, rtol 1e-{}", f64::from(k) / 2.0),
            "< 1e-7 rad",
            format!("{error:.1e} rad in {steps} steps ({against})"),
            error < 1e-7,
        ));
        let points = points.into_iter().map(|(steps, error, _)| (steps, error));
        chart = chart.with(Series::new(format!("{stiffness:.0e} N/m"), points).marked());
    }
    Ok(Figure { slug: "stiff-spring", chart, rows })
}
