//! Mechanisms that wait.

use plm_runtime::Fault;
use plm_view::{Axis, Chart, Series};

use super::{Figure, Row, so_far};
use crate::scenes::waiting::{apart, pushed as push, pushed_at_once, turned, turntable};
use crate::text::By as _;

pub fn pushed() -> Result<Figure, Fault> {
    let at_once = pushed_at_once(0.5)?;
    let (mut swings, mut turns, mut errors) = (Ok(()), Ok(()), Vec::new());
    let (mut off, mut momentum) = (0.0_f64, 0.0_f64);
    for (k, wait) in [0.0, 5.0, 1000.0].into_iter().enumerate() {
        let swing = push(wait, 0.5)?;
        let apart = so_far(apart(&swing, &at_once));
        off = apart.iter().fold(off, |off, (_, apart)| off.max(*apart));
        errors.push(Series::new(format!("after {wait} s of rest"), apart).of_family(k, k));
        swings = swings.and(swing.end);
        let turn = turned(&mut turntable(wait).begin()?);
        momentum = momentum.max(turn.largest(1));
        turns = turns.and(turn.end);
    }
    let rows = vec![
        Row::end("four-bar that is pushed after up to 1000 s of rest", &swings),
        Row::below("the same: angles against absolute coordinates without a rest", 1e-7, " rad", off),
        Row::end("four-bar on a turntable that turns after up to 1000 s of rest", &turns),
        Row::below("the same: angular momentum against that of the torque", 5e-9, " N*m*s", momentum),
    ];
    let degrees =
        |column| at_once.over_time(column).into_iter().map(|(time, angle)| (time, angle.to_degrees()));
    let chart = Chart::new(Axis::linear("time since the torque began", "s"), Axis::linear("angle", "deg"))
        .titled("A four-bar rests until a torque grows, and goes through its dead points")
        .noted("Above: in absolute coordinates without a rest. Below: how far the default is from them after a rest.")
        .with(Series::new("pushed bar", degrees(0)))
        .with(Series::new("other bar", degrees(1)))
        .with(Series::new("coupler", degrees(2)))
        .below(Axis::log("largest difference so far", "rad"));
    Ok(Figure { slug: "waiting", chart: errors.into_iter().fold(chart, Chart::with), rows })
}
