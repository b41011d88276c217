//! Extreme speeds, mass ratios and precision.

use plm_runtime::{Dop853, Rk4};

use crate::scenes::standard::{four_bar, four_bar_in_f32};
use crate::scenes::{loops, trees};
use crate::text::{By as _, Named as _};

#[test]
fn a_crank_at_1e4_rad_per_s_turns_as_a_slow_one_does() {
    for speed in [1.0, 1e4] {
        let [off, energy] = loops::whirled(speed, 20, Dop853::new(1e-11)).unwrap();
        assert!(off.abs() < 1e-8 && energy.abs() < 1e-9, "{speed} rad/s: {off:e} rad, {energy:e}");
    }
}

#[test]
fn bars_of_a_millionth_or_a_million_times_the_load_swing_with_their_period() {
    for bars in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
        let (off, stats) = loops::swung(bars, Dop853::new(1e-11)).unwrap();
        assert!(off.abs() < 1e-9, "{bars:e} kg: {off:e} rad, {stats:?}");
    }
}

#[test]
fn a_load_on_bars_of_next_to_no_mass_falls_as_a_point() {
    // The bars change the motion in proportion to their mass.
    let off = trees::speed_below(1e-3).unwrap();
    assert!(off.abs() < 1e-3, "{off:e}");
    let off = trees::speed_below(1e-5).unwrap();
    assert!(off.abs() < 1e-5, "{off:e}");
}

#[test]
fn single_precision_ends_where_its_digits_do() {
    // Angle of the crank of S2 after 1 s: references in quadruple precision.
    let known = -4.561_584_698_981_446_17;
    let double = |h: f64| {
        let mut sim = four_bar().by(Rk4::new(h)).unwrap();
        sim.step(1.0).unwrap();
        (sim.body_of("crank").angle - known).abs()
    };
    let single = |h: f32| {
        let mut sim = four_bar_in_f32().by(Rk4::new(h)).unwrap();
        sim.step(1.0).unwrap();
        (f64::from(sim.body(0).unwrap().angle) - known).abs()
    };
    // While truncation rules, both are alike; then f32 stops at its rounding and f64 goes on.
    let (coarse64, coarse32) = (double(0.02), single(0.02));
    assert!((coarse32 / coarse64 - 1.0).abs() < 0.1, "{coarse32:e} {coarse64:e}");
    let (fine64, fine32) = (double(1e-3), single(1e-3));
    assert!(fine64 < 1e-8 && (1e-8..1e-4).contains(&fine32), "{fine32:e} {fine64:e}");
}
