//! Extreme speeds, mass ratios and precision.

use plm_runtime::{Dop853, Fault, Rk4};
use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row};
use crate::scenes::loops;
use crate::scenes::standard::{four_bar, four_bar_in_f32};
use crate::text::{By as _, Named as _};

pub fn fast_crank() -> Result<Figure, Fault> {
    let (mut angles, mut energies) = (Vec::new(), Vec::new());
    for speed in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5] {
        let [off, energy] = loops::whirled(speed, 20, Dop853::default())?;
        angles.push((speed, off.abs()));
        energies.push((speed, energy.abs()));
    }
    let at = |list: &[(f64, f64)]| {
        list.iter().find(|(speed, _)| *speed == 1e4).map_or(f64::NAN, |(_, error)| *error)
    };
    let rows = vec![
        Row::below("crank at 1e4 rad/s, default: angle after 20 turns", 1e-6, " rad", at(&angles)),
        Row::below("crank at 1e4 rad/s, default: energy after 20 turns", 1e-7, "", at(&energies)),
    ];
    let chart = Chart::new(
        Axis::log("speed of the crank", "rad/s"),
        Axis::log("error of the angle after 20 turns", "rad"),
    )
    .titled("A slider-crank without gravity runs freely")
    .noted("The known angle: I(theta) theta'^2 is constant, and the time of a turn a quadrature.")
    .with(Series::new("default method", angles).marked())
    .below(Axis::log("change of energy", ""))
    .with(Series::new("default method", energies).marked());
    Ok(Figure { slug: "fast-crank", chart, rows })
}

pub fn masses() -> Result<Figure, Fault> {
    let mut errors = Vec::new();
    for decade in -6..=6 {
        let bars = 10_f64.powi(decade);
        errors.push((bars, loops::swung(bars, Dop853::default())?.0.abs()));
    }
    let worst = errors.iter().map(|(_, error)| *error).fold(0.0, f64::max);
    let rows = vec![Row::below(
        "swing, bars of 1e-6 to 1e6 times the beam, default: angle after 5/4 periods",
        1e-6,
        " rad",
        worst,
    )];
    let chart = Chart::new(
        Axis::log("mass of a bar over that of the beam", ""),
        Axis::log("error of the angle after 5/4 periods", "rad"),
    )
    .titled("A beam swings on two bars: mass ratios of 1e-6 to 1e6")
    .with(Series::new("default method", errors).marked());
    Ok(Figure { slug: "masses", chart, rows })
}

pub fn precision() -> Result<Figure, Fault> {
    // Angle of the crank of S2 after 1 s, from quadruple precision.
    let known = -4.561_584_698_981_446_17;
    let (mut double, mut single) = (Vec::new(), Vec::new());
    for k in 0..=12 {
        let h = 0.05 * 0.5_f64.powi(k);
        let mut sim = four_bar().by(Rk4::new(h))?;
        sim.step(1.0)?;
        double.push((h, (sim.body_of("crank").angle - known).abs()));
        let mut sim = four_bar_in_f32().by(Rk4::new(h as f32))?;
        sim.step(1.0)?;
        let angle = sim.body(0).map_or(f64::NAN, |crank| f64::from(crank.angle));
        single.push((h, (angle - known).abs()));
    }
    let best = |list: &[(f64, f64)]| list.iter().map(|(_, error)| *error).fold(f64::INFINITY, f64::min);
    let rows = vec![
        Row::below("S2 in f64, RK4: best of all steps", 1e-11, " rad", best(&double)),
        Row::new(
            "S2 in f32, RK4: best of all steps",
            format!("eps = {:.1e}", f32::EPSILON),
            format!("{:.1e} rad", best(&single)),
            best(&single) < 64.0 * f64::from(f32::EPSILON),
        ),
    ];
    let chart =
        Chart::new(Axis::log("step", "s").falling(), Axis::log("error of the crank after 1 s", "rad"))
            .titled("S2, four-bar linkage, RK4: f32 against f64")
            .noted("Shorter steps than where f32 meets its rounding make it worse: there are more of them.")
            .with(Series::new("f64", double).marked())
            .with(Series::new("f32", single).marked())
            .with_rule(Rule::horizontal(f64::from(f32::EPSILON), "f32: distance from 1 to the next number"));
    Ok(Figure { slug: "precision", chart, rows })
}
