//! The numbers of the state: names, parts, typical sizes.

use crate::collect::CollectVec;
use crate::derive::Equations;
use crate::formulate::{Reduced, coordinate_name};
use crate::model::Model;

/// The start values of a body.
pub(crate) const OF_BODY: [&str; 6] = ["x", "y", "angle", "vx", "vy", "omega"];

/// Sizes for absolute tolerances: the scene's length for displacements, one radian for angles, both per second for
/// rates, one of the unit that it is declared in for a state.
pub(crate) fn typical(
    model: &Model,
    equations: &Equations,
    reduced: Option<&Reduced>,
    length: f64,
) -> Vec<f64> {
    let angles: Vec<bool> = match reduced.and_then(Reduced::first) {
        Some(chart) => chart.turning.iter().map(Option::is_some).collect_vec(),
        None => (0..equations.q.len()).map(|k| k % 3 == 2).collect_vec(),
    };
    let coordinates = angles.iter().chain(&angles).map(|angle| if *angle { 1.0 } else { length });
    let states = model.states.iter().map(|state| state.unit.factor.to_f64());
    coordinates.chain(states).collect_vec()
}

/// The part that each number of the state belongs to.
pub(crate) fn parts(model: &Model, equations: &Equations, reduced: Option<&Reduced>) -> Vec<String> {
    let coordinates = match reduced.and_then(Reduced::first) {
        Some(chart) => chart.parts.clone(),
        None => (0..equations.q.len()).map(|k| model.bodies[k / 3].name.text.clone()).collect_vec(),
    };
    let states = model.states.iter().map(|state| &state.name.text);
    coordinates.iter().chain(&coordinates).chain(states).cloned().collect_vec()
}

/// Names of the numbers of the state; a coordinate has one in every chart.
pub(crate) fn names(model: &Model, equations: &Equations, reduced: Option<&Reduced>) -> Vec<String> {
    let charts: Vec<Vec<String>> = match reduced {
        None => vec![(0..equations.q.len()).map(|k| coordinate_name(model, k)).collect_vec()],
        Some(reduced) => reduced.charts.iter().map(|chart| chart.names.clone()).collect_vec(),
    };
    let in_all = |k: usize, name: fn(&str) -> String| {
        let mut known = Vec::new();
        for name in charts.iter().filter_map(|names| names.get(k)).map(|of| name(of)) {
            if !known.contains(&name) {
                known.push(name);
            }
        }
        known.join(" or ")
    };
    let count = charts.first().map_or(0, Vec::len);
    let coordinates = (0..count).map(|k| in_all(k, str::to_owned));
    let rates = (0..count).map(|k| in_all(k, rate_of));
    coordinates.chain(rates).chain(model.states.iter().map(|state| state.name.text.clone())).collect_vec()
}

/// The name of the rate of a coordinate: that of `arm.angle` is `arm.omega`.
pub(crate) fn rate_of(coordinate: &str) -> String {
    let (owner, what) = coordinate.rsplit_once('.').unwrap_or(("", coordinate));
    let rate = match what {
        "angle" => "omega".to_owned(),
        "displacement" => "speed".to_owned(),
        axis => format!("v{axis}"),
    };
    format!("{owner}.{rate}")
}
