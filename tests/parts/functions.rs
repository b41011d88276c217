//! Functions that jump, and tables of two arguments.

use plm::Dop853;

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}");
}

plm::mechanism! {
    pub Jumps {
        allow(W0002);
        ground { port o: (0, 0) m; port p: (3, 0) m; }
        // A wheel that turns by 3 rad/s, from an integer on.
        body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start angle: 3 rad, locked; start omega: 3 rad/s, locked; }
        revolute axle(ground.o, wheel.o);
        let angle = wheel.angle/(1 rad);
        output tooth = floor(angle), back = floor(-angle), place = mod(wheel.angle, 2 rad);

        state stairs: s = 0;
        rate stairs = floor(t/(1 s));
        state saw: s = 0;
        rate saw = mod(angle, 2);
        state downstairs: s = 0;
        rate downstairs = floor(-0.7*angle);
        output stairs, saw, downstairs;

        // Full power towards the middle: arcs of parabolas.
        state x: 1 = 1;
        state speed: 1/s = 0;
        rate x = speed;
        rate speed = -sign(x)/(1 s)^2;
        output x, speed;

        // A periodic prescribed motion.
        body arm { port o: (0, 0) m; }
        revolute elbow(ground.p, arm.o);
        constraint drive: arm.angle = smooth_table(mod(t, 2 s), (0 s, 0 deg), (1 s, 40 deg), (2 s, 0 deg));
        output arm.angle, arm.omega;

        input u: 1 = 0;
        input v: 1 = 0;
        let cell = table(u,
            (0, table(v, (0, 1), (2, 3), (5, 0))),
            (10, table(v, (0, 2), (2, -1), (5, 4))),
            (30, table(v, (0, 5), (2, 5), (5, 6))));
        output cell, level = floor(u), rest = mod(u, v + 3);
    }
}

#[test]
fn each_jump_of_a_floor_is_located() {
    let mut sim = Jumps::new().start_with(Dop853::new(1e-12)).unwrap();
    // An integer belongs to the interval above it.
    assert_eq!([sim.tooth(), sim.back(), sim.place()], [3.0, -3.0, 1.0]);
    for k in 1..=50 {
        let before = sim.stats().switches;
        sim.step_to(0.13 * f64::from(k)).unwrap();
        let t = sim.time();
        let angle = 3.0 + 3.0 * t;
        assert_eq!([sim.tooth(), sim.back()], [angle.floor(), (-angle).floor()]);
        near(sim.place(), angle.rem_euclid(2.0), 1e-11);
        let whole = t.floor();
        near(sim.stairs(), whole * (whole - 1.0) / 2.0 + whole * (t - whole), 1e-11);
        // Integral of mod(3 + 3 t, 2): over a period of 2/3 s it is 2/3, and it begins in the middle of one.
        let area = |angle: f64| (angle / 2.0).floor() * 2.0 + angle.rem_euclid(2.0).powi(2) / 2.0;
        near(sim.saw(), (area(angle) - area(3.0)) / 3.0, 1e-11);
        // Integral of floor(-0.7 angle), by its steps.
        let steps = |y: f64| {
            let n = y.floor();
            n * (n + 1.0) / 2.0 + (n + 1.0) * (y - n)
        };
        near(sim.downstairs(), -(steps(0.7 * angle) - steps(2.1)) / 2.1, 1e-11);
        assert!(sim.stats().switches - before <= 4);
    }
    near(sim.wheel().omega, 3.0, 0.0);
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
        near(sim.x(), half * (1.0 - 0.5 * from * from), 1e-10);
        near(sim.speed(), -half * from, 1e-10);
    }
}

#[test]
fn a_prescribed_motion_is_periodic() {
    let mut sim = Jumps::new().start_with(Dop853::new(1e-10)).unwrap();
    let mut first = Vec::new();
    for k in 0..60 {
        sim.step_to(0.1 * f64::from(k) + 0.05).unwrap();
        let here = [sim.arm_angle(), sim.arm_omega()];
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
            (sim.input.u, sim.input.v) = (u, v);
            sim.step(1e-6).unwrap();
            let (x, y) = (u.clamp(0.0, 30.0), v.clamp(0.0, 5.0));
            let (i, j) = (usize::from(x >= 10.0), usize::from(y >= 2.0));
            let (r, s) = ((x - xs[i]) / (xs[i + 1] - xs[i]), (y - ys[j]) / (ys[j + 1] - ys[j]));
            let known = (1.0 - r) * ((1.0 - s) * values[i][j] + s * values[i][j + 1])
                + r * ((1.0 - s) * values[i + 1][j] + s * values[i + 1][j + 1]);
            near(sim.cell(), known, 1e-12);
            assert_eq!([sim.level(), sim.rest()], [u.floor(), u - (v + 3.0) * (u / (v + 3.0)).floor()]);
        }
    }
}

plm::mechanism! {
    pub Slide {
        sliding_mass block() { mass: 1 kg; start_speed: 1 m/s; }
        slider_ground floor();
        slider_spring pull(floor.slider, block.slider) { preload: 1 N; }
        part dry(a: slider) { force on a: -3 N*sign(rate(a.position)); }
        dry rub(block.slider);
        output block.speed;
    }
}

/// A sign slides as Coulomb's friction does, and does not stick: where the slide should rest, its jumps follow each other.
#[test]
fn friction_by_a_sign_ends_where_it_should_stick() {
    let mut sim = Slide::new().start().unwrap();
    sim.step_to(0.4).unwrap();
    near(sim.block_speed(), 1.0 - 2.0 * 0.4, 1e-12);
    let fault = sim.step_to(1.0).unwrap_err();
    near(fault.time, 0.5, 1e-6);
    assert!(matches!(fault.cause, plm::Cause::Zeno { .. }), "{fault}");
}
