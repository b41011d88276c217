//! Angles that turn without end: the pose is as exact after many turns as after one, and who reads the angle sees all of them.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::f64::consts::TAU;

use plm::{Dop853, Mechanism, Moment, Rk4};

plm::mechanism! {
    /// A shaft, and a second one in its bearing that a spring holds to it; past 40 rad the second is pushed.
    Shafts {
        param push: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body first { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start omega: 104.71975512 rad/s, locked; }
        body second { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start angle: 0.5 rad; start omega: 104.71975512 rad/s, locked; }
        revolute bearing(ground.o, first.o);
        revolute coupling(first.o, second.o) { stiffness: 20 N*m/rad; }
        force pushed(second.o) { torque: if first.angle > 40 rad then push else 0 N*m; }
        output first.p.position, coupling.angle, coupling.torque;
    }
}

plm::mechanism! {
    /// A crank that turns round, a rocker, and a wheel beside them that touches no loop; all by closed forms.
    Cranked {
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port b: (4, 0) m; port c: (0, 5) m; }
        body crank { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (-0.5, 0) m; port p: (0.5, 0) m; start angle: 60 deg, locked; start omega: 20 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.2 kg*m^2; port p: (-1.75, 0) m; port q: (1.75, 0) m; start x: 2 m; start y: 1.5 m; }
        body rocker { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (-1.25, 0) m; port q: (1.25, 0) m; start x: 4 m; start y: 1 m; start angle: 90 deg; }
        body wheel { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (0, 0) m; port p: (1, 0) m; start y: 5 m; start omega: -30 rad/s; }
        revolute main(ground.a, crank.o) { stiffness: 0.2 N*m/rad; damping: 0.01 N*m*s/rad; }
        revolute first(crank.p, coupler.p);
        revolute second(coupler.q, rocker.q);
        revolute third(ground.b, rocker.o);
        revolute axle(ground.c, wheel.o);
        output crank.angle, rocker.q.position, wheel.p.position;
    }
}

plm::mechanism! {
    /// The same in absolute coordinates.
    CrankedAbsolute {
        rung: absolute;
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port b: (4, 0) m; port c: (0, 5) m; }
        body crank { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (-0.5, 0) m; port p: (0.5, 0) m; start angle: 60 deg, locked; start omega: 20 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.2 kg*m^2; port p: (-1.75, 0) m; port q: (1.75, 0) m; start x: 2 m; start y: 1.5 m; }
        body rocker { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (-1.25, 0) m; port q: (1.25, 0) m; start x: 4 m; start y: 1 m; start angle: 90 deg; }
        body wheel { mass: 1 kg; inertia: 0.2 kg*m^2; port o: (0, 0) m; port p: (1, 0) m; start y: 5 m; start omega: -30 rad/s; }
        revolute main(ground.a, crank.o) { stiffness: 0.2 N*m/rad; damping: 0.01 N*m*s/rad; }
        revolute first(crank.p, coupler.p);
        revolute second(coupler.q, rocker.q);
        revolute third(ground.b, rocker.o);
        revolute axle(ground.c, wheel.o);
        output crank.angle, rocker.q.position, wheel.p.position;
    }
}

plm::mechanism! {
    /// A wheel that a gear keeps at one and a half times the speed of another: there whole turns are not nothing.
    Geared {
        ground { port a: (0, 0) m; port b: (1, 0) m; }
        body first { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start omega: 20 rad/s, locked; }
        body second { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start x: 1 m; }
        revolute a(ground.a, first.o);
        revolute b(ground.b, second.o);
        constraint gear: second.angle = 1.5*first.angle;
        output second.p.position;
    }
}

/// 200 s at 1000 revolutions a minute, in single precision and in steps of a millisecond.
#[test]
fn a_shaft_turns_for_long_in_single_precision() {
    let mut sim = Shafts::<f32>::of().start_with(Rk4::new(1e-3)).unwrap();
    let steps = 200_000;
    for _ in 0..steps {
        sim.step(1e-3).unwrap();
    }
    assert!(sim.x()[..2].iter().all(|angle| angle.abs() < 5.0), "{:?}", sim.x());
    // 20 000 rad in floating point of 24 bits are known to a millirad; the point turns on its circle all the same.
    let [x, y] = sim.first_p_position();
    assert!((x.hypot(y) - 0.1).abs() < 1e-7);
    let turned = f64::from(sim.first().angle);
    // Each step rounds the speed by up to 4e-6 rad/s, at random: by some 2e-3 rad/s in the end.
    assert!((turned / (200.0 * 104.719_755_12) - 1.0).abs() < 5e-5, "{turned}");
    // What the spring reads is the difference of two large angles, and is as exact as at the start.
    let period = TAU / f64::sqrt(2.0 * 20.0 / 0.1);
    let expected = 0.5 * (TAU * 200.0 / period).cos();
    assert!((f64::from(sim.coupling_angle()) - expected).abs() < 2e-2, "{} {expected}", sim.coupling_angle());
}

/// A condition and a spring read all turns; the run is that of angles that are never brought back.
#[test]
fn conditions_and_springs_see_all_turns() {
    let mut shafts = Shafts::new();
    shafts.push = 3.0;
    let mut sim = shafts.start().unwrap();
    let speed = 104.719_755_12;
    sim.step_to(1.0).unwrap();
    // Both together have the momentum of the push, from the time at which the first has come to 40 rad.
    let momentum = 0.1 * (sim.first().omega + sim.second().omega - 2.0 * speed);
    let mut other = shafts.start().unwrap();
    let begun = crossing(|t| {
        other.reset().unwrap();
        other.step_to(t).unwrap();
        other.first().angle - 40.0
    });
    assert!((momentum - 3.0 * (1.0 - begun)).abs() < 1e-8, "{momentum} {begun}");
    assert_eq!(sim.stats().switches, 1);
}

/// Where a function changes its sign in (0, 1), by halving.
fn crossing(mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        *(if f(middle) < 0.0 { &mut low } else { &mut high }) = middle;
    }
    low
}

/// In charts, and in absolute coordinates: the same motion, with the same turns.
#[test]
fn loops_count_as_absolute_coordinates_do() {
    let mut sim = Cranked::new().start_with(Dop853::new(1e-11)).unwrap();
    let mut other = CrankedAbsolute::new().start_with(Dop853::new(1e-11)).unwrap();
    for k in 1..=20 {
        let time = 0.5 * f64::from(k);
        sim.step_to(time).unwrap();
        other.step_to(time).unwrap();
        for (angle, reference) in [
            (sim.crank().angle, other.crank().angle),
            (sim.rocker().angle, other.rocker().angle),
            (sim.coupler().angle, other.coupler().angle),
            (sim.wheel().angle, -30.0 * time),
            (other.wheel().angle, -30.0 * time),
            (sim.crank_angle(), sim.crank().angle),
        ] {
            assert!((angle - reference).abs() < 1e-7, "{time}: {angle} {reference}");
        }
        // Within the last step, where it is that long: before or after an angle was brought back.
        if let Ok(before) = sim.at(time - 1e-3) {
            let turned = sim.crank().angle - before.crank().angle;
            assert!((turned - 1e-3 * sim.crank().omega).abs() < 1e-3);
        }
    }
    assert!(sim.crank().angle.abs() > TAU, "{}", sim.crank().angle);
    assert!(sim.wheel().angle < -40.0 * TAU);
    assert!(other.x().iter().take(12).all(|number| number.abs() < 6.0));
}

/// A start from a moment keeps all turns: the spring of the crank reads them.
#[test]
fn a_start_from_a_moment_has_all_turns() {
    let mut sim = Cranked::new().start().unwrap();
    sim.step_to(3.0).unwrap();
    let mut again = Cranked::new();
    again.start = sim.starts();
    let mut again = again.start_at(3.0, Dop853::default()).unwrap();
    assert!((again.crank().angle - sim.crank().angle).abs() < 1e-9);
    sim.step_to(3.5).unwrap();
    again.step_to(3.5).unwrap();
    assert!((again.crank().angle - sim.crank().angle).abs() < 1e-6);
    assert!((again.wheel().angle - sim.wheel().angle).abs() < 1e-9);
}

/// Whole turns of one wheel are none of the other.
#[test]
fn a_gear_keeps_its_ratio_over_many_turns() {
    let mut sim = Geared::new().start().unwrap();
    for k in 1..=40 {
        sim.step_to(f64::from(k)).unwrap();
        let expected = 30.0 * f64::from(k);
        assert!((sim.second().angle - expected).abs() < 1e-8 * expected);
        let [x, y] = sim.second_p_position();
        assert!((x - 1.0 - 0.1 * expected.cos()).abs() < 1e-6 && (y - 0.1 * expected.sin()).abs() < 1e-6);
    }
}
