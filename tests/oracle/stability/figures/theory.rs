//! Oscillations that theory knows.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Series};

use super::{Figure, Row};
use crate::scenes::{theory, trees};

pub fn kapitza() -> Result<Figure, Fault> {
    let (mut found, mut rows) = (Vec::new(), Vec::new());
    for a in (1..=10).map(|k| 0.01 * f64::from(k)) {
        let (limit, known) = (trees::kapitza_limit(a)?, theory::kapitza_limit(a));
        found.push((a, limit));
        rows.push(Row::new(
            format!("Kapitza's pendulum: least (a w)^2 / (2 g l), a/l = {a:.2}"),
            format!("{known:.6}"),
            format!("{limit:.6}"),
            (limit - known).abs() < 2e-6,
        ));
    }
    let known = (0..=50).map(|k| f64::from(k) * 0.11 / 50.0).map(|a| (a, theory::kapitza_limit(a)));
    let chart = Chart::new(Axis::linear("a/l", ""), Axis::linear("least (a w)^2 / (2 g l)", ""))
        .titled("Kapitza's pendulum: upright from this speed of the pivot on")
        .noted("By the trace of the matrix of one period; theory: Mathieu's equation. As a/l vanishes, 1.")
        .with(Series::new("theory", known))
        .with(Series::new("simulated", found).marked());
    Ok(Figure { slug: "kapitza", chart, rows })
}

pub fn laguerre() -> Result<Figure, Fault> {
    let inertias = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
    let mut chart = Chart::new(
        Axis::log("inertia of a point about itself", "kg*m^2").falling(),
        Axis::log("relative error of the frequency", ""),
    )
    .titled("A hanging chain of five points swings at the zeros of L_5")
    .noted("w^2 l / g = z. A revolute asks a point for an inertia; as it vanishes, so does the error.");
    let mut rows = Vec::new();
    for (mode, z) in theory::laguerre_zeros(5).into_iter().enumerate() {
        let mut errors = Vec::new();
        for inertia in inertias {
            errors.push((inertia, trees::frequency_error(mode, inertia)?.abs()));
        }
        let last = errors.last().map_or(f64::INFINITY, |(_, error)| *error);
        rows.push(Row::below(format!("five points, z = {z:.6}: frequency, 1e-6 kg m^2"), 5e-6, "", last));
        chart = chart.with(Series::new(format!("z = {z:.4}"), errors).marked());
    }
    Ok(Figure { slug: "laguerre", chart, rows })
}
