//! Dyads that come to their own limits.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Rule, Series};

use super::{Figure, Row};
use crate::scenes::dyads::{apart, leading, stephenson};
use crate::scenes::theory::stephenson_limits;
use crate::text::By as _;

pub fn six_bar() -> Result<Figure, Fault> {
    let mut sim = stephenson().begin()?;
    let trace = leading(&mut sim, 3.0);
    let [low, high] = stephenson_limits().map(f64::to_degrees);
    let crank = trace.over_time(1).into_iter().map(|(_, angle)| angle.to_degrees());
    let (least, most) =
        crank.fold((f64::MAX, f64::MIN), |(low, high), angle| (low.min(angle), high.max(angle)));
    let stretched = trace.rows.windows(2).filter(|pair| pair[0].1[3] * pair[1].1[3] < 0.0).count();
    let turns = |which: &str, known: f64, found: f64| {
        let quantity = format!("six-bar: where its crank turns back, {which}");
        // Samples stand 0.2 ms apart, at accelerations of up to 1e3 rad/s^2.
        Row::new(quantity, format!("{known:.4} deg"), format!("{found:.4} deg"), (known - found).abs() < 1e-3)
    };
    let rows = vec![
        Row::end(format!("six-bar, 3 s, its second dyad stretches {stretched} times"), &trace.end),
        turns("forwards", high, most),
        turns("backwards", low, least),
        Row::below("six-bar: energy", 1e-7, "", trace.largest(0)),
        Row::below("six-bar, at 1e-11: angles against absolute coordinates", 5e-8, " rad", apart(3.0)?),
        Row::new(
            "six-bar: changes of the driving bar",
            format!("{stretched} or more"),
            sim.stats().charts.to_string(),
            sim.stats().charts >= stretched as u64,
        ),
    ];
    let first = |column| trace.over_time(column).into_iter().take_while(|(time, _)| *time <= 1.0);
    let degrees = |column| first(column).map(|(time, angle)| (time, angle.to_degrees()));
    let chart = Chart::new(Axis::linear("time", "s"), Axis::linear("angle", "deg"))
        .titled("Stephenson's six-bar: a four-bar leads a dyad")
        .noted("Where link and arm stretch, the crank cannot drive them: the arm does, and the crank turns back.")
        .with(Series::new("crank", degrees(1)))
        .with(Series::new("arm", degrees(2)))
        .with_rule(Rule::horizontal(high, "limit of the crank"))
        .with_rule(Rule::horizontal(low, "limit of the crank"))
        .below(Axis::linear("sin(link - arm)", ""))
        .with(Series::new("0: link and arm stretch", first(3)));
    Ok(Figure { slug: "six-bar", chart, rows })
}
