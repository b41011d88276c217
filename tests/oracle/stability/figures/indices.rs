//! The order of a method by the index of what it is handed.

use plm_view::{Axis, Chart, Series};

use super::{Figure, Row};
use crate::scenes::indices::{Index, errors, found_orders, orders};

const QUANTITIES: [&str; 3] = ["position", "velocity", "multiplier"];

pub fn order_reduction() -> Figure {
    let mut chart = Chart::new(Axis::log("step", "s"), Axis::log("error after 1 s", ""))
        .titled("Pendulum as a differential-algebraic system, Radau IIA with 3 stages")
        .noted("Position in m, velocity in m/s, multiplier in N/m. The joint coordinates of plm are an ordinary equation.");
    let mut rows = Vec::new();
    for index in [Index::One, Index::Two, Index::Three] {
        let runs = [5, 10, 20, 40, 80].map(|steps| (1.0 / f64::from(steps), errors(index, steps)));
        let found = found_orders(index).unwrap_or([f64::NAN; 3]);
        for (k, quantity) in QUANTITIES.into_iter().enumerate() {
            let points = runs.iter().filter_map(|(h, errors)| Some((*h, errors.as_ref()?[k])));
            let known = orders(index)[k];
            // Orders that are alike lie on each other: of index 1 and 2 what differs is enough.
            if index == Index::Three || k == 2 {
                let label = format!("index {}, {quantity}", index as u8);
                chart = chart.with(Series::new(label, points).marked());
            }
            rows.push(Row::new(
                format!("index {}, order of the {quantity}", index as u8),
                format!("{known}"),
                format!("{:.2}", found[k]),
                (found[k] - known).abs() < 0.2,
            ));
        }
    }
    Figure { slug: "order-reduction", chart, rows }
}
