//! `plm-view` with hostile numbers.

use std::hint::black_box;

use plm_view::{Axis, Chart, Recording, Results, Rule, Series};

use super::{Call, Hostile, Outcome, ended};

pub(super) const CALLS: &[Call] =
    &[Call { name: "view::chart", call: chart }, Call { name: "view::recording", call: recording }];

fn chart(h: &mut Hostile) -> Outcome {
    let points: Vec<(f64, f64)> = h.list(20).into_iter().map(|x| (x, x)).collect();
    let other: Vec<(f64, f64)> = (0..5).map(|_| (h.number(), h.number())).collect();
    let axis = |h: &mut Hostile| {
        let own = if h.draw.chance(0.5) { Axis::linear("x", "m") } else { Axis::log("x", "m") };
        let own = if h.draw.chance(0.3) { own.including(h.number()) } else { own };
        if h.draw.chance(0.3) { own.range(h.number(), h.number()) } else { own }
    };
    let own = Chart::new(axis(h), axis(h))
        .with(Series::new("a", points))
        .with(Series::new("b", other).as_points())
        .with_rule(Rule::vertical(h.number(), "here"))
        .with_rule(Rule::horizontal(h.number(), "there"));
    black_box(own.to_svg());
    Outcome::Done
}

fn recording(h: &mut Hostile) -> Outcome {
    let mut own = Recording::new([("x", "m"), ("y", "rad")]);
    for _ in 0..h.draw.below(20) {
        own.push(h.number(), h.numbers::<2>());
    }
    black_box(Chart::over_time(&own).to_svg());
    let mut bytes = Vec::new();
    let written = own.write_csv_to(&mut bytes);
    let results = Results { runs: vec![own], ..Results::default() };
    let packed = results.to_bytes().map(|bytes| Results::from_bytes(&bytes).1);
    ended(written.and(packed))
}
