//! Signals beside closed forms.

use crate::assert_near;

plm::mechanism! {
    pub Signals {
        allow(W0002);
        body anything { mass: 1 kg; inertia: 1 kg*m^2; }
        ramps command() {
            duration1: 0.5 s; start1: 1; end1: 2;
            duration2: 0.25 s; start2: -1; end2: -3;
            duration4: 1 s; start4: 4; end4: 0.5;
        }
        ramps long() {
            duration1: 1 s; end1: 1; duration2: 1 s; start2: 1; end2: 3; duration3: 1 s; start3: 3; end3: 6;
            duration4: 1 s; start4: 6; end4: 10; duration5: 1 s; start5: 10; end5: 15;
            duration6: 1 s; start6: 15; end6: 21; duration7: 1 s; start7: 21; end7: 28;
            duration8: 1 s; start8: 28; end8: 36;
        }
        ramps jagged() {
            duration1: 1 s; start1: 8; end1: 7; duration2: 1 s; start2: -2; end2: 5; duration3: 1 s; start3: 3; end3: -6;
            duration4: 1 s; start4: -1; end4: 4; duration5: 1 s; start5: 6; end5: 2; duration6: 1 s; start6: -5; end6: 1;
            duration7: 1 s; start7: 9; end7: -3; duration8: 1 s; start8: -4; end8: -7;
        }
        ramps first_only() { duration1: 1 s; start1: 2; end1: 3; }
        ramps until2() { duration2: 1 s; start2: 2; end2: 4; }
        ramps until3() { duration3: 1 s; start3: 2; end3: 5; }
        ramps until5() { duration5: 1 s; start5: 2; end5: 6; }
        ramps until6() { duration6: 1 s; start6: 2; end6: 7; }
        ramps until7() { duration7: 1 s; start7: 2; end7: 8; }
        lag first() { signal: 3; gain: 2; time_constant: 0.4 s; value: 1; }
        lag2 second() { signal: 3; gain: 2; frequency: 2 Hz; damping_ratio: 0.3; value: 1; }
        pid control() { error: 2 + 3 Hz*t; proportional: 5; integral: 7 Hz; derivative: 0.3 s; filter: 0.2 s; }
        output jagged.value, first_only.value, until2.value, until3.value, until5.value, until6.value, until7.value;
        output command.value, long.value, first.value, second.value, speed = second.speed, control.value;
    }
}

fn command(t: f64) -> f64 {
    match t {
        t if t < 0.5 => 1.0 + 2.0 * t,
        t if t < 0.75 => -1.0 - 8.0 * (t - 0.5),
        t if t < 1.75 => 4.0 - 3.5 * (t - 0.75),
        _ => 0.5,
    }
}

/// Eight stages of a second; the starts are no ends.
fn jagged(t: f64) -> f64 {
    let stages = [
        [8.0, 7.0],
        [-2.0, 5.0],
        [3.0, -6.0],
        [-1.0, 4.0],
        [6.0, 2.0],
        [-5.0, 1.0],
        [9.0, -3.0],
        [-4.0, -7.0],
    ];
    let stage = (t.floor() as usize).min(7);
    let [start, end] = stages[stage];
    start + (end - start) * (t - stage as f64).min(1.0)
}

#[test]
fn stages_lags_and_the_controller_are_what_their_equations_say() {
    let mut sim = Signals::new().start_with(plm::Dop853::new(1e-12)).unwrap();
    for k in 0..=90 {
        let t = sim.time();
        // Not where a stage jumps.
        if ![5, 7, 8, 17, 18].contains(&k) {
            assert_near(sim.command_value(), command(t), 1.0, &format!("command at {t}"));
        }
        let whole = t.floor().min(8.0);
        let long = if t < 8.0 { whole * (whole + 1.0) / 2.0 + (whole + 1.0) * (t - whole) } else { 36.0 };
        assert_near(sim.long_value(), long, 1.0, &format!("long at {t}"));
        // Not where a stage jumps.
        if k % 10 != 0 || k == 0 || k > 80 {
            assert_near(sim.jagged_value(), jagged(t), 1.0, &format!("jagged at {t}"));
        }
        // Stages without duration are left out, in front and after; then the end of the last is held.
        let single = |end: f64| 2.0 + (end - 2.0) * t.min(1.0);
        let alone = [
            (sim.first_only_value(), 3.0),
            (sim.until2_value(), 4.0),
            (sim.until3_value(), 5.0),
            (sim.until5_value(), 6.0),
            (sim.until6_value(), 7.0),
            (sim.until7_value(), 8.0),
        ];
        for (found, end) in alone {
            assert_near(found, single(end), 1.0, &format!("the one stage to {end} at {t}"));
        }
        assert_near(sim.first_value(), 6.0 - 5.0 * f64::exp(-t / 0.4), 1.0, "lag");
        let (omega, ratio) = (4.0 * std::f64::consts::PI, 0.3);
        let (decay, swing) = (ratio * omega, omega * f64::sqrt(1.0 - ratio * ratio));
        let (sin, cos) = (swing * t).sin_cos();
        let expected = 6.0 - 5.0 * f64::exp(-decay * t) * (cos + decay / swing * sin);
        assert_near(sim.second_value(), expected, 1.0, "lag of second order");
        let expected = 5.0 * f64::exp(-decay * t) * omega * omega / swing * sin;
        assert_near(sim.speed(), expected, omega, "its speed");
        // The filter lags behind 2 + 3 t, from 0.
        let (error, late) = (2.0 + 3.0 * t, f64::exp(-t / 0.2));
        let slope = 3.0 + (2.0 / 0.2 - 3.0) * late;
        let expected = 5.0 * error + 7.0 * (2.0 * t + 1.5 * t * t) + 0.3 * slope;
        assert_near(sim.control_value(), expected, 1.0, "controller");
        sim.step(0.1).unwrap();
    }
}
