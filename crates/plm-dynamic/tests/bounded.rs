//! Runs that hung, took time without bound, or stopped although they can go on: special values of contact and of conditions.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::f64::consts::PI;

use plm_dynamic::{Mechanism, Run};

/// A run by a method that is named.
fn start(text: &str, method: &str) -> Run {
    Mechanism::from_text(text).unwrap().start_with(method.parse().unwrap()).unwrap()
}

/// The page of `ground_profile`: the ground is a smooth table, whose piece depends on where the point is. Contact asks for its gap when
/// that is known. The sled begins 0.167 m above the ground: until it lands it falls.
#[test]
fn a_gap_over_a_table_begins_in_the_piece_where_the_point_is() {
    let text = "pub Sled {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body sled { mass: 20 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: -2 m; start y: 1 m; }
        ground_profile hill(ground.o, sled.p) {
            height(x): smooth_table(x, (-3 m, 1 m), (0 m, 0 m), (2 m, 0.5 m), (5 m, -1 m));
            friction: 0.1;
        }
        output sled.y, hill.push, hill.gap;
    }";
    for method in ["Dop853", "RadauIia5", "Rk4:1e-3", "MoreauJean:1e-3"] {
        let mut run = start(text, method);
        assert_eq!(run.output("hill.push").unwrap(), 0.0, "{method}");
        run.step_to(0.1).unwrap();
        let fallen = 1.0 - run.output("sled.y").unwrap();
        // A step of MoreauJean is off by a half of the step times the speed.
        assert!((fallen - 0.5 * 9.81 * 0.01).abs() < 0.6e-3, "{method}: {fallen}");
        run.step_to(3.0).unwrap();
        let gap = run.output("hill.gap").unwrap();
        assert!(gap.abs() < 1e-2, "{method}: {gap}");
    }
}

/// Most steps of an event, made or refused.
const PER_EVENT: u64 = 20;

/// A run takes the steps of its smooth motion and those of its events.
fn assert_few_steps(run: &Run, smooth: u64, of: &str) {
    let stats = run.stats();
    assert!(stats.steps + stats.rejected < smooth + PER_EVENT * (stats.switches + 10), "{of}: {stats:?}");
}

/// Two equal masses on equal springs, of which one strikes the other: they go on side by side, and the gap between them falls with each
/// impact, to rounding. Their centre swings on. The time to look at a step grew by 1/sqrt(e) with each impact.
#[test]
fn masses_of_one_frequency_go_on_side_by_side() {
    for (restitution, law) in [(0.3, "poisson"), (0.8, "newton"), (0.5, "sequential"), (0.0, "poisson")] {
        let text = format!(
            "pub Springs {{ allow(W0002); impacts: {law}; ground {{ port o: (0, 0) m; }}
            body b0 {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: -0.5 m, locked; }}
            body b1 {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: 0 m, locked; }}
            prismatic r0(ground.o, b0.p) {{ stiffness: 10 N/m; }}
            prismatic r1(ground.o, b1.p) {{ stiffness: 10 N/m; }}
            UNILATERAL }}"
        );
        let strikes = format!("unilateral u0: b1.x - b0.x >= 0 {{ restitution: {restitution:?}; }}");
        let [apart, text] = ["", &strikes].map(|row| text.replace("UNILATERAL", row));
        for method in ["Dop853:1e-9", "Vern9:1e-9"] {
            let mut smooth = start(&apart, method);
            smooth.step_to(40.0).unwrap();
            let mut run = start(&text, method);
            run.step_to(40.0).unwrap();
            let [a, b] = ["b0", "b1"].map(|body| run.body(body).unwrap().x);
            let expected = -0.5 * (10.0_f64.sqrt() * 40.0).cos();
            assert!((a + b - expected).abs() < 1e-6, "{restitution} {law} {method}: {a} {b} {expected}");
            assert_few_steps(&run, smooth.stats().steps, method);
        }
    }
}

/// The direction of what is at rest, or moves along an axis, is where it is.
#[test]
fn a_direction_of_what_is_at_rest_or_on_an_axis_stays() {
    for (velocity, limit, expected) in
        [("0", 40.0, 1.0), ("-1", 40.0, 1.0), ("1", 0.0, 1.0), ("-1", 180.0, 1.0)]
    {
        let text = format!(
            "pub Rest {{
            body b {{ mass: 1 kg; inertia: 1 kg*m^2; start vx: {velocity} m/s, locked; }}
            discrete n: 1 = 1;
            when atan2(b.vy, b.vx) < {limit:?} deg {{ n = 0; }}
            output n;
            allow(W0002); }}"
        );
        let mut run = start(&text, "Dop853");
        run.step_to(10.0).unwrap();
        assert_eq!(run.output("n").unwrap(), expected, "{velocity} m/s, {limit} deg");
        assert!(run.stats().steps < 100, "{:?}", run.stats());
    }
}

/// A movable pulley between two ropes: whatever it weighs, all accelerations are constant.
#[test]
fn a_light_pulley_takes_no_more_than_a_heavy_one() {
    for wheel in [1e-1, 1e-3, 1e-6, 1e-9] {
        let text = format!(
            "pub Atwood {{
            gravity: 9.81 m/s^2;
            ground {{ port left: (-0.1, 2) m; port right: (0.1, 2) m; port rail: (0.1, 0) m, axis: 90 deg; }}
            sliding_mass m1() {{ mass: 3 kg; x: -0.1 m; angle: 90 deg; start: 1 m; }}
            body wheel {{
                mass: {wheel:?} kg; inertia: 1e-12 kg*m^2; start x: 0.1 m; start y: 1.2 m, locked;
                port top: (0, 0) m; port l: (-0.05, 0) m; port r: (0.05, 0) m; port c: (0, 0) m, angle: 90 deg;
            }}
            prismatic guide(ground.rail, wheel.c);
            sliding_mass m2() {{ mass: 1 kg; x: 0.05 m; angle: 90 deg; start: 0.5 m; }}
            sliding_mass m3() {{ mass: 2 kg; x: 0.15 m; angle: 90 deg; start: 0.6 m; }}
            rope upper() {{ length: 1.8 m; }}
            fall u1(upper.end, m1.frame, ground.left);
            fall u2(upper.end, wheel.top, ground.right);
            rope lower() {{ length: 1.3 m; }}
            fall l1(lower.end, m2.frame, wheel.l);
            fall l2(lower.end, m3.frame, wheel.r);
            output y = m1.frame.position.y; }}"
        );
        let both = 2.0 * 1.0 * 2.0 / (1.0 + 2.0);
        let acceleration = 9.81 * (3.0 - 2.0 * both - wheel) / (3.0 + 2.0 * both + wheel);
        for method in ["Dop853:1e-6", "RadauIia5:1e-6", "Rk4:1e-2"] {
            let mut run = start(&text, method);
            run.step_to(0.1).unwrap();
            let (y, expected) = (run.output("y").unwrap(), 1.0 - 0.005 * acceleration);
            assert!((y - expected).abs() < 1e-6, "{wheel} {method}: {y} {expected}");
            assert_few_steps(&run, 0, method);
        }
    }
}

/// A pebble on stairs by fixed steps: where it has struck a tread it is below it by what it moves in a step, and so after the riser.
#[test]
fn stairs_are_no_place_to_sink_into_by_fixed_steps() {
    for (friction, restitution) in [(0.3, 0.5), (0.0, 0.5), (0.3, 0.0)] {
        let text = format!(
            "pub Stairs {{
            gravity: 9.81 m/s^2;
            ground {{ port o: (0, 0) m; }}
            body pebble {{
                mass: 0.1 kg; inertia: 1e-5 kg*m^2; port p: (0, 0) m; start x: -0.5 m; start y: 1 m; start vx: 1 m/s;
            }}
            point_on_polyline stairs(ground.o, pebble.p) {{
                vertices: (-2, 0), (0, 0), (0, -0.3), (0.4, -0.3), (0.4, -0.6), (3, -0.6) m;
                thickness: 0.2 m; restitution: {restitution:?}; friction: {friction:?};
            }} }}"
        );
        let mut located = start(&text, "Dop853");
        located.step_to(0.8).unwrap();
        let expected = located.body("pebble").unwrap();
        for method in ["Rk4:1e-2", "Rk4:1e-3", "SemiImplicitEuler:1e-3", "MoreauJean:1e-3"] {
            let mut run = start(&text, method);
            for k in 1..=20 {
                run.step_to(0.04 * f64::from(k)).unwrap();
            }
            let found = run.body("pebble").unwrap();
            let near = if method == "Rk4:1e-2" { 0.3 } else { 0.03 };
            let apart = (found.x - expected.x).abs().max((found.y - expected.y).abs());
            assert!(apart < near, "{method} {friction} {restitution}: {found:?} {expected:?}");
        }
    }
}

/// Joints that repeat each other where one of them holds by a condition, with a gap and a friction at the same place.
#[test]
fn rows_that_are_redundant_at_the_start_take_few_steps() {
    let text = "pub Example { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; port p: (1, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 7 deg; }
        body rod { mass: 0.1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; }
        revolute shoulder(ground.o, arm.a); revolute elbow(arm.b, rod.a); revolute extra(rod.b, ground.p);
        point_on_line foot(rod.b, ground.p) { friction: 0.3; }
        friction grip: rate(arm.angle) within 0..3 N*m { static: 0..4 N*m; }
        revolute hook2(rod.b, ground.p) { when: arm.omega > 0; } }";
    let mut run = start(text, "Dop853");
    run.step_to(0.01).unwrap();
    let stats = run.stats();
    assert!(stats.steps + stats.rejected < 100, "{stats:?}");
}

/// The smallest numbers are lengths like others: their quotients are infinite, and no scale of sums that are shared.
#[test]
fn the_smallest_lengths_are_nearly_none() {
    let text = |length: &str| {
        format!(
            "pub Scene {{ allow(W0002); gravity: 9.81 m/s^2;
            ground {{ port g0: (0.5, 0) m; port g1: ({length}, 0.2) m; port g3: (0.1, 0.55) m; port g4: (0.1, -0.9) m; port g2: (0, -0.06) m; }}
            body arm {{ mass: 1 kg; inertia: 0.005 kg*m^2; port a: (-0.12, 0) m; port b: (0.12, 0) m; start angle: -120 deg, locked; }}
            body link {{ mass: 1 kg; inertia: rod(1 kg, 1.23 m); port a: (-0.615, 0) m; port b: (0.615, 0) m; }}
            body rod {{ mass: 0.5 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.87, 0) m; }}
            body slider {{ mass: 0.2 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; }}
            revolute j0(ground.g0, arm.a); revolute j1(ground.g1, link.a); pin_slot j2(link.a, arm.b); revolute j3(link.b, rod.a);
            revolute j4(rod.b, slider.o); prismatic j5(ground.g2, slider.o);
            spring s0(ground.g3, link.b) {{ stiffness: 200 N/m; free_length: 0.93 m; }}
            spring s1(ground.g4, link.a) {{ stiffness: 200 N/m; free_length: 1.04 m; }} }}"
        )
    };
    let places = |length: &str| {
        let mut run = start(&text(length), "Dop853:1e-9");
        run.step_to(0.01).unwrap();
        ["arm", "link", "rod", "slider"].map(|body| run.body(body).unwrap().x)
    };
    let expected = places("0");
    for length in ["5e-324", "-5e-324", "1e-310", "2e-308", "1e-300"] {
        for (found, expected) in places(length).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{length}: {found} {expected}");
        }
    }
}

/// A cycle of an engine: where the angle of the cycle jumps back, what the angle beyond it has decided changes at once.
#[test]
fn what_a_jump_puts_beyond_its_boundary_switches_at_once() {
    for speed in [1.0, 7.0, 40.0, 310.0, 314.0] {
        let text = format!(
            "pub Engine {{
            ground {{ port o: (0, 0) m; }}
            body crank {{ mass: 1 kg; inertia: 0.15 kg*m^2; port o: (0, 0) m; start omega: {speed:?} rad/s, locked; }}
            revolute main(ground.o, crank.o) {{ drive: torque; }}
            let stroke = mod(main.angle, 2 rev);
            let torque = if stroke < 180 deg then 0.01 N*m else if stroke < 540 deg then 0 N*m else -0.01 N*m;
            discrete cycles: 1 = 0;
            when main.angle > 2 rev {{ cycles = cycles + 1; }}
            output cycles, crank.omega, crank.angle; }}"
        );
        for method in ["Dop853:1e-9", "Dopri5:1e-9", "RadauIia5:1e-9"] {
            let mut run = start(&text, method);
            run.step_to(2.5 * 4.0 * PI / speed).unwrap();
            assert_eq!(run.output("cycles").unwrap(), 1.0, "{method}, {speed} rad/s");
            // Its energy is the work of the strokes.
            let [omega, angle] = ["crank.omega", "crank.angle"].map(|name| run.output(name).unwrap());
            let stroke = angle.rem_euclid(4.0 * PI);
            let work = 0.01 * (stroke.min(PI) - (stroke - 3.0 * PI).max(0.0));
            let expected = (speed * speed + 2.0 * work / 0.15).sqrt();
            assert!(
                (omega - expected).abs() < 1e-6 * expected,
                "{method}, {speed} rad/s: {omega} {expected}"
            );
            assert_few_steps(&run, 0, method);
        }
    }
}

/// A circuit breaker: a stiff spring over its dead centre throws an arm on a stop, from which it bounces to rest. Flights between impacts are
/// lower than any tolerance of a step; stages and times that are not more exact than those led below the stop.
#[test]
fn an_arm_comes_to_rest_on_its_stop_at_every_tolerance() {
    let text = "pub Breaker {
        ground { port pivot: (0, 0) mm; port low: (25, 0) mm; }
        body arm {
            mass: 30 gram; inertia: 1e-5 kg*m^2; port pivot: (0, 0) mm; port eye: (0, 25) mm;
            start angle: 22 deg, locked;
        }
        revolute pivot(ground.pivot, arm.pivot) {
            lower_limit: -30 deg; upper_limit: 30 deg; restitution: 0.2; damping: 1e-4 N*m*s/rad;
        }
        spring toggle(ground.low, arm.eye) { stiffness: 2 N/mm; free_length: 10 mm; }
        latch hold(ground.pivot, arm.pivot) {
            motion: rotation; angle: 22 deg; release: if t > 1 ms then 1 else 0; closed: 1;
        }
        output arm.angle, arm.omega;
    }";
    for method in
        ["Dop853", "RadauIia5:1e-4", "RadauIia5:1e-5", "RadauIia5:1e-6", "RadauIia5", "RadauIia5:1e-12"]
    {
        let mut run = start(text, method);
        run.step_to(0.01).unwrap();
        let [angle, omega] = ["arm.angle", "arm.omega"].map(|name| run.output(name).unwrap());
        assert!((angle + PI / 6.0).abs() < 1e-10 && omega == 0.0, "{method}: {angle} rad, {omega} rad/s");
        assert_few_steps(&run, 600, method);
    }
}

/// The page of `gearbox` in a scene: its friction sticks until the load is what the motor can hold, 0.2 N m x 50 / 0.8, and slips back from
/// there as slowly as the square of the time. The dense output of an implicit step goes to the other side first, by less than its tolerance.
#[test]
fn a_slip_that_forces_begin_goes_on_at_every_tolerance() {
    let text = "pub Scene {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 45 deg; }
        body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; }
        revolute shoulder(ground.o, arm.a);
        revolute elbow(arm.b, rod.a);
        rotor motor() { inertia: 1e-4 kg*m^2; drive: 0.2 N*m; }
        gearbox reducer(motor.shaft, shoulder.shaft) { ratio: 50; efficiency: 0.8; }
        output reducer.lost;
    }";
    let end = |method: &str| {
        let mut run = start(text, method);
        run.step_to(0.5).unwrap_or_else(|fault| panic!("{method}: {fault}"));
        assert_few_steps(&run, 300, method);
        run.output("reducer.lost").unwrap()
    };
    let known = end("Dop853:1e-12");
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let lost = end(&format!("RadauIia5:{tolerance:e}"));
        assert!((lost - known).abs() < 300.0 * tolerance, "{tolerance}: {lost} is not {known}");
    }
}

/// A trebuchet throws its stone where four comparisons hold. Impulses that satisfy joints again move the last of them by rounding.
#[test]
fn what_rounding_moves_at_an_event_takes_no_side_again() {
    let text = "pub Trebuchet {
        gravity: 9.81 m/s^2;
        discrete held: 1 = 1;
        ground { port axle: (0, 5) m; port floor: (0, 0) m; }
        body beam {
            mass: 100 kg; inertia: rod(100 kg, 10 m); port axle: (-3, 0) m; port short: (-5, 0) m; port long: (5, 0) m;
            start angle: 215 deg, locked;
        }
        body weight { mass: 2000 kg; inertia: 500 kg*m^2; port hook: (0, 1) m; }
        body stone { mass: 15 kg; inertia: sphere(15 kg, 0.15 m); port pouch: (0, 0) m; start x: -2 m; start y: 0 m; }
        revolute axle(ground.axle, beam.axle);
        revolute hook(beam.short, weight.hook);
        unilateral sling: norm(beam.long.position - stone.pouch.position) <= 5 m { when: held > 0.5; }
        point_on_line trough(ground.floor, stone.pouch);
        when held > 0.5 and stone.vx > 0 m/s and stone.vy < stone.vx and stone.y > 5 m { held = 0; }
        output stone.x;
    }";
    for tolerance in ["1e-4", "1e-5", "1e-6", "1e-7", "1e-9", "1e-12"] {
        let mut run = start(text, &format!("Dop853:{tolerance}"));
        run.step_to(3.0).unwrap();
        let x = run.output("stone.x").unwrap();
        assert!((x - 78.5465).abs() < 1e-3, "{tolerance}: {x}");
    }
}

/// A ball that begins at rest on the floor from which its `when` throws it back: it has no flight, and does not fall through.
#[test]
fn a_ball_at_rest_on_its_floor_does_not_fall_through() {
    let at_rest = "at rest where events without end throw it back, by `ball.y < 0 m`";
    for (law, is_thrown) in [("-0.8*ball.vy", true), ("0 m/s", false), ("ball.vy", false)] {
        let text = format!(
            "pub Rest {{ gravity: 9.81 m/s^2; body ball {{ mass: 1 kg; inertia: 1 kg*m^2; start y: 0 m, locked; }}
            when ball.y < 0 m {{ ball.vy = {law}; }} output ball.y; }}"
        );
        for method in ["Dop853", "Dopri5", "Vern9", "Adams"] {
            let mut run = start(&text, method);
            match run.step_to(1.0) {
                Err(error) if is_thrown => assert!(error.to_string().contains(at_rest), "{method}: {error}"),
                outcome => {
                    outcome.unwrap();
                    let y = run.output("ball.y").unwrap();
                    assert!(!is_thrown && (y + 4.905).abs() < 1e-6, "{law}, {method}: {y}");
                }
            }
        }
    }
}
