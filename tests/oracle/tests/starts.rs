//! Starts from text: as drawn, far away, at change points, of geared loops; and parts that end where they have no direction or no room.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_dynamic::{Error, Integrator, Mechanism, Run};

fn started(text: &str) -> Result<Run, Error> {
    Mechanism::from_text(text)?.start_with(Integrator::Dop853(1e-9))
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found}, expected {expected}");
}

/// Two pulleys on a line of centres at an angle in deg, tied by an elastic belt.
fn belt(line: f64, starts: [&str; 2]) -> String {
    let (sin, cos) = line.to_radians().sin_cos();
    format!(
        "pub Belts {{
    ground {{ port m: (0, 0) m; port p: ({cos:?}, {sin:?}) m; }}
    body motor {{ mass: 1 kg; inertia: 1e-3 kg*m^2; port o: (0, 0) m; {} }}
    body wheel {{ mass: 3 kg; inertia: 0.02 kg*m^2; port o: (0, 0) m; {} }}
    revolute a(ground.m, motor.o);
    revolute b(ground.p, wheel.o);
    elastic_belt drive(ground.m, motor.o, wheel.o) {{
        radius_a: 0.05 m; radius_b: 0.15 m; distance: 1 m; stiffness: 2e4 N/m; damping: 100 N*s/m; preload: 200 N;
    }}
    output drive.tension_left, drive.tension_right;
}}",
        starts[0], starts[1]
    )
}

/// Both strands have the preload, whichever way the line of centres points and however the wheels are drawn: at 0, or as the line.
#[test]
fn issue_047_a_belt_begins_as_drawn_all_round_the_circle() {
    for line in [0.0, 37.0, 90.0, 180.0, 199.0, 270.0, -90.0] {
        let turned = format!("start angle: {line:?} deg;");
        for starts in
            [["", ""], [turned.as_str(), turned.as_str()], [turned.as_str(), ""], ["", turned.as_str()]]
        {
            let run = started(&belt(line, starts)).unwrap();
            for strand in ["drive.tension_left", "drive.tension_right"] {
                near(run.output(strand).unwrap(), 200.0, 1e-6);
            }
        }
    }
}

/// A wheel that begins out of phase strains the belt by what it is turned.
#[test]
fn a_belt_begins_strained_where_a_wheel_is_drawn_out_of_phase() {
    for line in [0.0_f64, 37.0, 180.0] {
        let starts = [format!("start angle: {line:?} deg;"), format!("start angle: {:?} deg;", line + 1.0)];
        let run = started(&belt(line, [&starts[0], &starts[1]])).unwrap();
        let strain = 2e4 * 0.15 * 1_f64.to_radians();
        near(run.output("drive.tension_left").unwrap(), (200.0 - strain).max(0.0), 1e-6);
        near(run.output("drive.tension_right").unwrap(), 200.0 + strain, 1e-6);
    }
}

/// The gear gives the wheel, and two bars of 0.5 m close the rest.
#[test]
fn issue_047_a_lock_that_determines_a_geared_loop_is_not_redundant() {
    let bar = |name: &str, length: f64, start: &str| {
        format!(
            "body {name} {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({length:?}, 0) m; {start} }}"
        )
    };
    let text = format!(
        "pub Scene {{
    ground {{ port o: (0, 0) m; port p: (0.4, 0) m; }}
    {} {} {} {}
    revolute j0(ground.o, crank.a);
    revolute j1(ground.p, wheel.a);
    revolute j2(crank.b, link.a);
    revolute j3(link.b, arm.b);
    revolute j4(wheel.b, arm.a);
    gear mesh(ground.o, crank.a, wheel.a) {{ radius_a: 0.1 m; radius_b: 0.2 m; }}
}}",
        bar("crank", 0.3, "start angle: 90 deg, locked;"),
        bar("wheel", 0.2, ""),
        bar("link", 0.5, ""),
        bar("arm", 0.5, "")
    );
    let run = started(&text).unwrap();
    near(run.body("crank").unwrap().angle, 90_f64.to_radians(), 1e-12);
    near(run.body("wheel").unwrap().angle, -45_f64.to_radians(), 1e-10);
    for name in ["link", "arm"] {
        assert!(run.body(name).unwrap().angle.abs() < 7.0, "{name}");
    }
}

const BIKE: &str = "pub Bike {
    gravity: 9.81 m/s^2;
    PARAM
    ground { port main: (0, 0.34) m; port rocker: (0.02, 0.62) m; }
    body chainstay { port main: (-0.2, 0) m; port horst: (0.2, 0) m; start angle: 180 deg; start x: -0.2 m; start y: 0.34 m; }
    body seatstay { port horst: (0, 0) m; port top: (0.38, 0) m; port axle: (-0.02, 0.01) m; start angle: 40 deg; start x: -0.4 m; start y: 0.34 m; }
    body rocker { port pivot: (0, 0) m; port stay: (-0.12, 0) m; start angle: 0 deg; start x: 0.02 m; start y: 0.62 m; }
    revolute a(ground.main, chainstay.main);
    revolute b(chainstay.horst, seatstay.horst);
    revolute c(seatstay.top, rocker.stay);
    revolute d(ground.rocker, rocker.pivot);
    constraint wheel: seatstay.axle.y = HEIGHT;
}";

/// No pose near the drawing closes: the run tells so, also where the compiler cannot, and the compiler's pose is the run's.
#[test]
fn issue_047_a_start_that_closes_only_far_away_is_told() {
    for (param, height) in [("", "0.34 m"), ("param height: m = 0.34 m;", "height")] {
        let text = BIKE.replace("PARAM", param).replace("HEIGHT", height);
        let mechanism = Mechanism::from_text(&text).unwrap();
        let told = mechanism.far_start().unwrap();
        assert!(told.contains("chainstay.angle is turned by -177.6 deg"), "{told}");
        let run = mechanism.start().unwrap();
        near(run.body("rocker").unwrap().angle.to_degrees(), 104.02, 0.01);
    }
}

/// A four-bar whose default angles lie in one line: two motions leave there, and the assembled velocities are those of neither.
#[test]
fn issue_047_a_start_in_one_line_is_told_as_what_it_is() {
    let text = "pub Scene {
    param base: m = 0.7 m;
    ground { port a: (0, 0) m; port d: (base, 0 m); }
    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.4, 0) m; start omega: -5 rad/s, locked; }
    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (0.9, 0) m; }
    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (0.6, 0) m; }
    revolute p_a(ground.a, crank.a);
    revolute p_b(crank.b, coupler.b);
    revolute p_c(coupler.c, rocker.c);
    revolute p_d(ground.d, rocker.d);
}";
    let fault = started(text).unwrap_err().to_string();
    assert!(fault.contains("the start is a change point"), "{fault}");
    let literal = started(&text.replace("param base: m = 0.7 m;", "").replace("base", "0.7 m"))
        .unwrap_err()
        .to_string();
    assert!(literal.contains("E0508") && !literal.contains("W0001"), "{literal}");
}

/// One rope over a pulley in two halves: one of them winds up in the other sense. a = g/7 for 3 and 2 kg and J/r^2 = 2 kg.
#[test]
fn issue_047_a_winch_winds_up_in_either_sense() {
    let run = started(
        "pub Atwood {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 2) m; port l: (-0.1, 2) m; port r: (0.1, 2) m; }
    body pulley { mass: 4 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 2 m; }
    revolute axle(ground.o, pulley.hub);
    sliding_mass a() { mass: 3 kg; x: -0.1 m; angle: 90 deg; start: 1 m; }
    sliding_mass b() { mass: 2 kg; x: 0.1 m; angle: 90 deg; start: 0.5 m; }
    rope left() { length: 1 m; }
    winch wl(left.end, axle.shaft) { radius: -0.1 m; }
    fall fl(left.end, a.frame, ground.l);
    rope right() { length: 1.5 m; }
    winch wr(right.end, axle.shaft) { radius: 0.1 m; }
    fall fr(right.end, b.frame, ground.r);
    output a.frame.acceleration.y, left.tension, right.tension;
}",
    )
    .unwrap();
    near(run.output("a.frame.acceleration.y").unwrap(), -9.81 / 7.0, 1e-9);
    near(run.output("left.tension").unwrap(), 3.0 * 9.81 * 6.0 / 7.0, 1e-8);
    near(run.output("right.tension").unwrap(), 2.0 * 9.81 * 8.0 / 7.0, 1e-8);
}

/// The mass comes to the point of its fall at sqrt(2 0.5 m/(g/3)).
#[test]
fn issue_047_a_fall_that_meets_its_point_ends_the_run_by_name() {
    let mut run = started(
        "pub Short {
    gravity: 9.81 m/s^2;
    ground { port l: (-0.1, 2) m; port r: (0.1, 2) m; }
    sliding_mass a() { mass: 2 kg; x: -0.1 m; angle: 90 deg; start: 1 m; }
    sliding_mass b() { mass: 1 kg; x: 0.1 m; angle: 90 deg; start: 1.5 m; }
    rope line() { length: 1.5 m; }
    fall fl(line.end, a.frame, ground.l);
    fall fr(line.end, b.frame, ground.r);
}",
    )
    .unwrap();
    let fault = run.step_to(1.0).unwrap_err().to_string();
    assert!(fault.contains("fr.apart"), "{fault}");
    near(run.time(), (3.0_f64 / 9.81).sqrt(), 1e-5);
}

/// The piston leaves no volume at the time at which 0.06 (1 - cos t) is 0.1 m.
#[test]
fn issue_047_a_chamber_without_room_ends_the_run_by_name() {
    let text = "pub Squeeze {
    ground { port g: (0, 0) m; }
    body plunger { mass: 10 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: 0 m; }
    prismatic guide(ground.g, plunger.p);
    constraint stroke: plunger.x = 0.06 m*(1 - cos(1 rad/s*t));
    chamber barrel() { dead_volume: 0 L; pressure: 1 bar; }
    piston ram(guide.slider, barrel.port) { diameter: 100 mm; length: 0.1 m; opens: backwards; }
    oil_tank tank() { pressure: 1 bar; }
    orifice out(barrel.port, tank.port) { rated_flow: 100 L/min; }
}";
    // An implicit method of this size has matrices on its stack, which are copied where nothing is optimised.
    let run = || {
        let mut run = Mechanism::from_text(text).unwrap().start_with(Integrator::RadauIia5(1e-6)).unwrap();
        let fault = run.step_to(2.4).unwrap_err().to_string();
        assert!(fault.contains("barrel.has_room"), "{fault}");
        near(run.time(), (-2.0_f64 / 3.0).acos(), 1e-5);
    };
    std::thread::scope(|scope| {
        std::thread::Builder::new().stack_size(8 << 20).spawn_scoped(scope, run).unwrap().join().unwrap();
    });
    let none = started(&text.replace("length: 0.1 m", "length: 0 m")).unwrap_err().to_string();
    // Of no volume at all the compiler tells, at the chamber.
    assert!(none.contains("E0403") && none.contains("barrel.pressure"), "{none}");
}
