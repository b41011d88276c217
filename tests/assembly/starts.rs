//! Old final values: a run that goes on from where another one ended.

use plm::{Dop853, Mechanism, StartProblem, read_starts};

mod bar_linkage {
    plm::mechanism! {
        /// A crank with a rocker, a hydraulic buffer on it, and a filter.
        pub Linkage {
            gravity: 9.81 m/s^2;
            ground { port a: (0, 0) m; port d: (1, 0) m; port wall: (1.5, 0.2) m; }
            body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0.1, 0) m; port a: (-0.1, 0) m; port b: (0.2, 0) m; start angle: 60 deg, locked; start omega: 9 rad/s, locked; }
            body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0.1) m; start angle: 20 deg; }
            body rocker { mass: 1.5 kg; inertia: 0.05 kg*m^2; port c: (0.3, 0) m; port d: (-0.3, 0) m; start angle: 80 deg; }
            revolute a(ground.a, crank.a);
            revolute b(crank.b, coupler.b);
            revolute c(coupler.c, rocker.c);
            revolute d(ground.d, rocker.d);
            jack buffer(ground.wall, rocker.c) { drive: pressure*1e-3 m^2; }
            state pressure: Pa = 1e4 Pa;
            rate pressure = -2e7 Pa/m*buffer.speed*0.01 - pressure/0.5 s;
            state seen: rad/s = 0;
            rate seen = (crank.omega - seen)/0.1 s;
            output pressure, seen;
        }
    }
}

/// All that a linkage is at a moment.
fn all(sim: &bar_linkage::linkage::State) -> Vec<f64> {
    let bodies = [sim.crank(), sim.coupler(), sim.rocker()];
    let bodies =
        bodies.into_iter().flat_map(|body| [body.x, body.y, body.angle, body.vx, body.vy, body.omega]);
    bodies.chain([sim.pressure() / 1e4, sim.seen()]).collect()
}

fn assert_alike(one: &[f64], other: &[f64], tolerance: f64) {
    assert_eq!(one.len(), other.len());
    for (k, (one, other)) in one.iter().zip(other).enumerate() {
        assert!((one - other).abs() <= tolerance * one.abs().max(1.0), "{k}: {one} is not {other}");
    }
}

#[test]
fn a_run_that_is_taken_up_again_is_one_run() {
    // The rocker on either side: the branch of the loop is kept.
    for rocker in [80.0_f64, -70.0] {
        let mut linkage = bar_linkage::Linkage::new();
        linkage.start.rocker.angle.value = rocker.to_radians();
        linkage.start.coupler.angle.value = if rocker > 0.0 { 0.35 } else { -0.8 };
        let mut whole = linkage.start_with(Dop853::new(1e-11)).unwrap();
        whole.step(2.0).unwrap();

        let mut first = linkage.start_with(Dop853::new(1e-11)).unwrap();
        first.step(1.0).unwrap();
        linkage.start = first.starts();
        let mut second = linkage.start_with(Dop853::new(1e-11)).unwrap();
        assert_alike(&all(&second), &all(&first), 1e-14);
        second.step(1.0).unwrap();
        assert_alike(&all(&second), &all(&whole), 1e-8);
        // Locks are those of the declaration.
        assert!(
            linkage.start.crank.angle.locked
                && linkage.start.crank.omega.locked
                && !linkage.start.rocker.angle.locked
        );
    }
}

#[test]
fn the_two_branches_are_not_the_same() {
    let mut up = bar_linkage::Linkage::new();
    let mut down = up;
    up.start.rocker.angle.value = 80_f64.to_radians();
    down.start.rocker.angle.value = -70_f64.to_radians();
    down.start.coupler.angle.value = -0.8;
    let (up, down) = (up.start().unwrap(), down.start().unwrap());
    assert!(up.rocker().y > 0.1 && down.rocker().y < -0.1);
}

#[test]
fn start_values_come_back_from_text_to_the_last_bit() {
    let mut sim = bar_linkage::Linkage::new().start().unwrap();
    sim.step(0.3).unwrap();
    let starts = sim.starts();
    let text = starts.to_string();
    assert!(
        text.starts_with("crank.x = ")
            && text.contains("\nrocker.omega = ")
            && text.contains("\npressure = ")
    );
    let read = read_starts(&format!("# after 0.3 s\n\n{text}"), bar_linkage::Linkage::new().start).unwrap();
    assert_eq!(read, starts);
    // In f32 too.
    let mut sim = bar_linkage::Linkage::<f32>::of().start_with(Dop853::new(1e-4)).unwrap();
    sim.step(0.1).unwrap();
    let starts = sim.starts();
    assert_eq!(read_starts(&starts.to_string(), bar_linkage::Linkage::<f32>::of().start), Ok(starts));
}

#[test]
fn what_is_wrong_with_a_text_is_named_all_at_once() {
    let starts = bar_linkage::Linkage::new().start;
    let mut lines: Vec<String> = starts.to_string().lines().map(str::to_owned).collect();
    lines[1] = "crank.height = 3".into();
    lines[2] = "crank.angle = much".into();
    lines[4] = "crank.vx = 1".into();
    lines[5] = "crank.omega = inf".into();
    let problems = read_starts(&lines.join("\n"), starts).unwrap_err();
    assert_eq!(
        problems.to_string(),
        "start values: line 2: there is no `crank.height`; line 3: `crank.angle = much` is not `name = number`; \
         line 5: `crank.vx` stands twice; line 6: `crank.omega = inf` is not `name = number`; \
         `crank.y` is missing; `crank.angle` is missing; `crank.vy` is missing; `crank.omega` is missing"
    );
    let unknown = StartProblem::Unknown { line: 2, name: "crank.height".into() };
    assert_eq!(problems.problems[0], unknown);
}

mod driven {
    plm::mechanism! {
        /// A wheel that is turned by the clock.
        pub Driven {
            ground { port o: (0, 0) m; }
            body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
            body bob { mass: 1 kg; inertia: 1 kg*m^2; port o: (-0.3, 0) m; }
            joint motor(a: frame, b: frame) {
                constraint angle: b.angle - a.angle - 2 rad*sin(3 rad/s*t) = 0;
            }
            revolute o(ground.o, wheel.o);
            motor drive(ground.o, wheel.o);
            revolute hang(wheel.o, bob.o) { stiffness: 5 N*m/rad; }
        }
    }
}

#[test]
fn the_clock_goes_on_where_something_depends_on_it() {
    let mut driven = driven::Driven::new();
    let mut whole = driven.start_with(Dop853::new(1e-11)).unwrap();
    whole.step(2.0).unwrap();
    let mut first = driven.start_with(Dop853::new(1e-11)).unwrap();
    first.step(1.0).unwrap();
    driven.start = first.starts();
    let mut second = driven.start_at(1.0, Dop853::new(1e-11)).unwrap();
    second.step(1.0).unwrap();
    assert_eq!(second.time(), 2.0);
    let angles = |sim: &driven::driven::State| [sim.wheel().angle, sim.bob().angle, sim.bob().omega];
    assert_alike(&angles(&second), &angles(&whole), 1e-9);
}
