//! Numbers over an interval hold what they say: every value and every slope in it.

use plm_runtime::{Dual, Enclosed, Interval, Scalar};

use crate::random::Random;

/// Every operation of a right-hand side, some of them one in another.
fn operation<S: Scalar>(which: usize, x: S, y: S) -> S {
    let lit = S::lit;
    match which {
        0 => x + y * x - y,
        1 => x * x / (y * y + lit(0.1)),
        2 => x / y,
        3 => (x * lit(3.0)).sin() * y.cos(),
        4 => (x * y).sqrt(),
        5 => (x + y).tan(),
        6 => (x * lit(0.3)).asin() + (y * lit(0.3)).acos(),
        7 => x.atan2(y),
        8 => (x - y).exp(),
        9 => (x * x + y).ln(),
        10 => (x - y).abs() + x.signum0() + y.floor(),
        11 => x.min(y).max(lit(0.2) * x),
        12 => x.powi(3) - y.powi(4) + (x + lit(4.0)).powi(-2),
        13 => S::select(x.lt(y), x * y, y + lit(1.0)),
        14 => x.mul_add(y, x) - y.powi(0),
        15 => (lit(1.0) - x.cos() * y.cos()).sqrt() / (lit(2.0) + x),
        _ => S::sin_cos_all([x, y]).1[1] * x,
    }
}

#[test]
fn every_value_and_slope_in_an_interval_is_enclosed() {
    let mut random = Random(7);
    let mut bounded = 0;
    for case in 0..20_000 {
        let which = case % 17;
        let (a, b) = ([3.0 * random.unit(), 2.0 * random.unit()], [3.0 * random.unit(), random.unit()]);
        let radius = 10.0_f64.powf(-3.0 + 3.0 * random.unit());
        // Lines of the variable s in [-radius, radius].
        let line = |[at, slope]: [f64; 2]| Enclosed {
            middle: at,
            value: Interval::between(at - slope * radius, at + slope * radius),
            slope: Interval::point(slope),
        };
        let enclosure = operation(which, line(a), line(b));
        let range = enclosure.range(radius);
        bounded += u32::from(range.is_bounded());
        for k in 0..=16 {
            let s = radius * (f64::from(k) / 8.0 - 1.0);
            let at = |[at, slope]: [f64; 2]| Dual::<f64, 1> { value: at + slope * s, tangents: [slope] };
            let found = operation(which, at(a), at(b));
            let what = format!("operation {which} of {a:?}, {b:?} within {radius:e} at {s:e}: {enclosure:?}");
            // Within rounding of the lines, which are rounded differently here, over how steep it is.
            let slack = 1e-14 * (1.0 + found.value.abs()) + 1e-14 * found.tangents[0].abs();
            let near =
                |range: Interval<f64>, x: f64, slack: f64| range.low - slack <= x && x <= range.high + slack;
            // Outside the domain there is nothing to enclose.
            if found.value.is_finite() {
                assert!(near(enclosure.value, found.value, slack), "{what}, value {}", found.value);
                // What jumps inside has no slope that bounds it.
                assert!(near(range, found.value, slack), "{what}, value {} outside {range:?}", found.value);
            }
            if found.value.is_finite() && found.tangents[0].is_finite() {
                let slack = 1e-9 * (1.0 + found.tangents[0].abs());
                assert!(
                    near(enclosure.slope, found.tangents[0], slack),
                    "{what}, slope {}",
                    found.tangents[0]
                );
            }
        }
    }
    assert!(bounded > 15_000, "{bounded}: an enclosure of everything tells nothing");
}

#[test]
fn the_range_narrows_with_the_square_of_the_interval() {
    // x - x^2 next to its top: the natural range is as wide as the interval.
    let width = |radius: f64| {
        let x = Enclosed {
            middle: 0.5,
            value: Interval::between(0.5 - radius, 0.5 + radius),
            slope: Interval::point(1.0),
        };
        let range = (x - x * x).range(radius);
        range.high - range.low
    };
    let ratio = width(1e-3) / width(1e-4);
    assert!((ratio - 100.0).abs() < 5.0, "{ratio}");
}
