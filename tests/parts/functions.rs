//! Functions that jump, and tables of two arguments.

use plm::{Dop853, Mechanism as _, Moment as _};

use crate::declared::{Jumps, Slide};
use crate::scene::Named as _;

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}");
}

#[test]
fn each_jump_of_a_floor_is_located() {
    let mut sim = Jumps::new().start_with(Dop853::new(1e-12)).unwrap();
    // An integer belongs to the interval above it.
    assert_eq!([sim.value_of("tooth"), sim.value_of("back"), sim.value_of("place")], [3.0, -3.0, 1.0]);
    for k in 1..=50 {
        let before = sim.stats().switches;
        sim.step_to(0.13 * f64::from(k)).unwrap();
        let t = sim.time();
        let angle = 3.0 + 3.0 * t;
        assert_eq!([sim.value_of("tooth"), sim.value_of("back")], [angle.floor(), (-angle).floor()]);
        near(sim.value_of("place"), angle.rem_euclid(2.0), 1e-11);
        let whole = t.floor();
        near(sim.value_of("stairs"), whole * (whole - 1.0) / 2.0 + whole * (t - whole), 1e-11);
        // Integral of mod(3 + 3 t, 2): over a period of 2/3 s it is 2/3, and it begins in the middle of one.
        let area = |angle: f64| (angle / 2.0).floor() * 2.0 + angle.rem_euclid(2.0).powi(2) / 2.0;
        near(sim.value_of("saw"), (area(angle) - area(3.0)) / 3.0, 1e-11);
        // Integral of floor(-0.7 angle), by its steps.
        let steps = |y: f64| {
            let n = y.floor();
            n * (n + 1.0) / 2.0 + (n + 1.0) * (y - n)
        };
        near(sim.value_of("downstairs"), -(steps(0.7 * angle) - steps(2.1)) / 2.1, 1e-11);
        assert!(sim.stats().switches - before <= 4);
    }
    near(sim.state_of("wheel").omega, 3.0, 0.0);
}

/// x = 1 - t^2/2 up to the middle at t = sqrt(2), and so on: the period is 4 sqrt(2).
#[test]
fn each_jump_of_a_sign_is_located() {
    let mut sim = Jumps::new().start_with(Dop853::new(1e-12)).unwrap();
    let quarter = 2.0_f64.sqrt();
    for k in 1..=60 {
        sim.step_to(0.25 * f64::from(k)).unwrap();
        let phase = sim.time().rem_euclid(4.0 * quarter);
        let half = if phase < quarter || phase > 3.0 * quarter { 1.0 } else { -1.0 };
        let from = match phase / quarter {
            p if p < 1.0 => phase,
            p if p < 3.0 => phase - 2.0 * quarter,
            _ => phase - 4.0 * quarter,
        };
        near(sim.value_of("x"), half * (1.0 - 0.5 * from * from), 1e-10);
        near(sim.value_of("speed"), -half * from, 1e-10);
    }
}

#[test]
fn a_prescribed_motion_is_periodic() {
    let mut sim = Jumps::new().start_with(Dop853::new(1e-10)).unwrap();
    let mut first = Vec::new();
    for k in 0..60 {
        sim.step_to(0.1 * f64::from(k) + 0.05).unwrap();
        let here = [sim.value_of("arm.angle"), sim.value_of("arm.omega")];
        first.push(here);
        let known = first[k as usize % 20];
        near(here[0], known[0], 1e-12);
        near(here[1], known[1], 1e-10);
    }
    // 40 deg in the middle of a period.
    assert!((0.68..0.7).contains(&first[9][0]), "{}", first[9][0]);
}

#[test]
fn a_table_of_tables_is_bilinear() {
    let mut sim = Jumps::new().start().unwrap();
    let (xs, ys) = ([0.0, 10.0, 30.0], [0.0, 2.0, 5.0]);
    let values = [[1.0, 3.0, 0.0], [2.0, -1.0, 4.0], [5.0, 5.0, 6.0]];
    for u in [-3.0, 0.0, 2.5, 10.0, 17.0, 30.0, 99.0_f64] {
        for v in [-1.0, 0.0, 0.8, 2.0, 3.1, 5.0, 7.0_f64] {
            sim.set_input("u", u);
            sim.set_input("v", v);
            sim.step(1e-6).unwrap();
            let (x, y) = (u.clamp(0.0, 30.0), v.clamp(0.0, 5.0));
            let (i, j) = (usize::from(x >= 10.0), usize::from(y >= 2.0));
            let (r, s) = ((x - xs[i]) / (xs[i + 1] - xs[i]), (y - ys[j]) / (ys[j + 1] - ys[j]));
            let known = (1.0 - r) * ((1.0 - s) * values[i][j] + s * values[i][j + 1])
                + r * ((1.0 - s) * values[i + 1][j] + s * values[i + 1][j + 1]);
            near(sim.value_of("cell"), known, 1e-12);
            assert_eq!(
                [sim.value_of("level"), sim.value_of("rest")],
                [u.floor(), u - (v + 3.0) * (u / (v + 3.0)).floor()]
            );
        }
    }
}

/// A sign slides as Coulomb's friction does, and does not stick: where the slide should rest, its jumps follow each other.
#[test]
fn friction_by_a_sign_ends_where_it_should_stick() {
    let mut sim = Slide::new().start().unwrap();
    sim.step_to(0.4).unwrap();
    near(sim.value_of("block.speed"), 1.0 - 2.0 * 0.4, 1e-12);
    let fault = sim.step_to(1.0).unwrap_err();
    near(fault.time, 0.5, 1e-6);
    assert!(matches!(fault.cause, plm::Cause::Zeno { .. }), "{fault}");
}
