//! Angles that turn without end: the pose is as exact after many turns as after one, and who reads the angle sees all of them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use std::f64::consts::TAU;

use plm::live::Live;
use plm::{Dop853, Mechanism as _, Moment as _, Rk4, mechanism};

use scene::{Given as _, Named as _};

macro_rules! shafts {
    ($declare:ident, $name:ident) => {
        $declare! {
            /// A shaft, and a second one in its bearing that a spring holds to it; past 40 rad the second is pushed.
            $name {
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
    };
}
shafts!(scene, Shafts);
// In single precision there are compiled mechanisms alone.
shafts!(mechanism, ShaftsInSingle);

/// A crank that turns round, a rocker, and a wheel beside them that touches no loop.
macro_rules! cranked {
    ($name:ident, $formulation:ident) => {
        scene! {
            $name {
                formulation: $formulation;
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
    };
}
cranked!(Cranked, loops);
cranked!(CrankedAbsolute, absolute);

scene! {
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

scene! {
    /// A pendulum that winds up a weak spring.
    Wound {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0.2) m; start angle: 0 rad, locked; start omega: 40 rad/s, locked; }
        revolute hinge(ground.o, bob.o) { stiffness: 0.01 N*m/rad; }
    }
}

scene! {
    /// A slider on an arm that turns round. Its joint, a pair by its own word, says by a sine that it does not turn.
    Slid {
        joint slide(a: frame, b: frame) {
            pair: prismatic;
            constraint normal: cross(b.position - a.position, a.axis) = 0;
            constraint angle: cross(a.axis, b.axis) = 0;
        }
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start omega: 10 rad/s, locked; }
        body rider { mass: 1 kg; inertia: 0.1 kg*m^2; port q: (0, 0) m; start x: 0.2 m; }
        revolute hinge(ground.o, arm.o);
        slide way(arm.p, rider.q);
        spring hold(arm.o, rider.q) { stiffness: 1000 N/m; free_length: 0.1 m; }
    }
}

scene! {
    /// The same with the joint of the library, whose row reads the angles, in absolute coordinates.
    SlidAbsolute {
        formulation: absolute;
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.1, 0) m; start omega: 10 rad/s, locked; }
        body rider { mass: 1 kg; inertia: 0.1 kg*m^2; port q: (0, 0) m; start x: 0.2 m; }
        revolute hinge(ground.o, arm.o);
        prismatic way(arm.p, rider.q);
        spring hold(arm.o, rider.q) { stiffness: 1000 N/m; free_length: 0.1 m; }
    }
}

scene! {
    /// A tool that a motor turns on an arm, which turns freely.
    Apart {
        formulation: absolute;
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (1, 0) m; start omega: 7 rad/s, locked; }
        body tool { mass: 1 kg; inertia: 0.01 kg*m^2; port q: (0, 0) m; start x: 1 m; }
        revolute hinge(ground.o, arm.o);
        revolute wrist(arm.p, tool.q);
        constraint motor: tool.angle - arm.angle = 20 rad/s*t;
    }
}

/// A plate on the pins of three cranks, which turn as one and wind up a spring: an angle and three slides at once.
macro_rules! plate_on_cranks {
    ($name:ident, $($formulation:tt)*) => {
        scene! {
            $name {
                $($formulation)*
                gravity: 9.81 m/s^2;
                ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
                body crank[0] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.1 m; start angle: 20 deg, locked; start omega: 12 rad/s, locked; }
                body crank[1] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 1.1 m; start angle: 20 deg; }
                body crank[2] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.6 m; start y: 0.9 m; start angle: -20 deg; }
                body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port a: (-0.4, -0.3) m, angle: 35 deg; port b: (0.4, -0.3) m, angle: 140 deg; port c: (0, 0.4) m, angle: 100 deg; start x: 0.5 m; start y: 0.3 m; }
                revolute o0(ground.a, crank[0].o) { stiffness: 0.05 N*m/rad; }
                revolute o1(ground.b, crank[1].o);
                revolute o2(ground.c, crank[2].o);
                pin_slot slot[0](plate.a, crank[0].p) { stiffness: 100 N/m; }
                pin_slot slot[1](plate.b, crank[1].p);
                pin_slot slot[2](plate.c, crank[2].p);
                constraint gear: crank[1].angle - crank[0].angle = 0;
                constraint back: crank[2].angle - crank[0].angle = -40 deg;
            }
        }
    };
}
plate_on_cranks!(Plate,);
plate_on_cranks!(PlateAbsolute, formulation: absolute;);

/// 200 s at 1000 revolutions a minute, in single precision and in steps of a millisecond.
#[test]
fn a_shaft_turns_for_long_in_single_precision() {
    let mut sim = ShaftsInSingle::<f32>::of().start_with(Rk4::new(1e-3)).unwrap();
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
    let shafts = Shafts::new().with("push", 3.0);
    let mut sim = shafts.start().unwrap();
    let speed = 104.719_755_12;
    sim.step_to(1.0).unwrap();
    // Both together have the momentum of the push, from the time at which the first has come to 40 rad.
    let momentum = 0.1 * (sim.state_of("first").omega + sim.state_of("second").omega - 2.0 * speed);
    let mut other = shafts.start().unwrap();
    let begun = crossing(|t| {
        other.reset().unwrap();
        other.step_to(t).unwrap();
        other.state_of("first").angle - 40.0
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
            (sim.state_of("crank").angle, other.state_of("crank").angle),
            (sim.state_of("rocker").angle, other.state_of("rocker").angle),
            (sim.state_of("coupler").angle, other.state_of("coupler").angle),
            (sim.state_of("wheel").angle, -30.0 * time),
            (other.state_of("wheel").angle, -30.0 * time),
            (sim.value_of("crank.angle"), sim.state_of("crank").angle),
        ] {
            assert!((angle - reference).abs() < 1e-7, "{time}: {angle} {reference}");
        }
        // Within the last step, where it is that long: before or after an angle was brought back.
        if let Ok(before) = sim.at(time - 1e-3) {
            let turned = sim.state_of("crank").angle - before.state_of("crank").angle;
            assert!((turned - 1e-3 * sim.state_of("crank").omega).abs() < 1e-3);
        }
    }
    assert!(sim.state_of("crank").angle.abs() > TAU, "{}", sim.state_of("crank").angle);
    assert!(sim.state_of("wheel").angle < -40.0 * TAU);
    assert!(other.x().iter().take(12).all(|number| number.abs() < 6.0));
}

/// A start from a moment keeps all turns: the spring of the crank reads them.
#[test]
fn a_start_from_a_moment_has_all_turns() {
    let mut sim = Cranked::new().start().unwrap();
    sim.step_to(3.0).unwrap();
    let again = Cranked::new().with_starts(&sim.starts());
    let mut again = again.start_at(3.0, Dop853::default()).unwrap();
    assert!((again.state_of("crank").angle - sim.state_of("crank").angle).abs() < 1e-9);
    sim.step_to(3.5).unwrap();
    again.step_to(3.5).unwrap();
    assert!((again.state_of("crank").angle - sim.state_of("crank").angle).abs() < 1e-6);
    assert!((again.state_of("wheel").angle - sim.state_of("wheel").angle).abs() < 1e-9);
}

/// Whole turns of one wheel are none of the other.
#[test]
fn a_gear_keeps_its_ratio_over_many_turns() {
    let mut sim = Geared::new().start().unwrap();
    for k in 1..=40 {
        sim.step_to(f64::from(k)).unwrap();
        let expected = 30.0 * f64::from(k);
        assert!((sim.state_of("second").angle - expected).abs() < 1e-8 * expected);
        let [x, y] = sim.vector_of("second.p.position");
        assert!((x - 1.0 - 0.1 * expected.cos()).abs() < 1e-6 && (y - 0.1 * expected.sin()).abs() < 1e-6);
    }
}

/// An equilibrium, and a pose by hand, begin where the mechanism is: with the spring as it is wound up.
#[test]
fn a_wound_spring_is_wound_up_where_it_is_stabilised_or_placed() {
    let mut sim = Wound::new().start().unwrap();
    sim.step_to(1.0).unwrap();
    let angle = sim.state_of("bob").angle;
    assert!(angle > 5.0 * TAU && sim.x()[0] < 5.0);
    let found = plm::stabilise(&sim).unwrap();
    assert_eq!(found.values[2].value.to_bits(), angle.to_bits());
    // The angle is locked: its lock holds the weight (the centre is below the hinge by 0.2 m times the cosine) and the spring.
    let expected = 9.81 * 0.2 * angle.sin() + 0.01 * angle;
    assert!((found.residuals[0].value - expected).abs() < 1e-9, "{:?}", found.residuals);

    let mut live = Live::new(Wound::new());
    assert!((0..100).all(|_| live.step(0.01)));
    let pose = live.read()[1..4].to_vec();
    assert!((pose[2] - angle).abs() < 1e-6);
    assert!(live.place(0, [pose[0], pose[1], pose[2] + 0.1]));
    assert!((live.read()[3] - pose[2]).abs() < 0.11, "{} {}", live.read()[3], pose[2]);
}

/// Bodies that a pair keeps from turning against each other have one angle and one count, whatever its rows look like.
#[test]
fn a_slider_turns_as_its_guide_does() {
    let mut sim = Slid::new().start().unwrap();
    let mut other = SlidAbsolute::new().start_with(Dop853::new(1e-11)).unwrap();
    for k in 1..=8 {
        sim.step_to(0.5 * f64::from(k)).unwrap();
        other.step_to(0.5 * f64::from(k)).unwrap();
        assert_eq!(sim.state_of("rider").angle.to_bits(), sim.state_of("arm").angle.to_bits());
        for (angle, reference) in [
            (sim.state_of("arm").angle, other.state_of("arm").angle),
            (other.state_of("rider").angle, other.state_of("arm").angle),
        ] {
            assert!((angle - reference).abs() < 1e-6, "{angle} {reference}");
        }
        let x = other.x();
        assert!(sim.x()[0].abs() < 5.0 && x[2].abs() < 5.0 && x[5].abs() < 5.0, "{:?} {x:?}", sim.x());
    }
    assert!(sim.state_of("arm").angle > 5.0 * TAU);
}

/// Angles whose difference grows cannot both be near: the first is, and nothing is brought back and forth.
#[test]
fn a_motor_between_turning_bodies_keeps_its_speed() {
    let mut sim = Apart::new().start().unwrap();
    let steps = 20_u32;
    for k in 1..=steps {
        let time = f64::from(k);
        sim.step_to(time).unwrap();
        for (angle, speed) in [(sim.state_of("arm").angle, 7.0), (sim.state_of("tool").angle, 27.0)] {
            assert!((angle - speed * time).abs() < 1e-7, "{time}: {angle}");
        }
        assert!(sim.x()[2].abs() < 5.0);
    }
}

/// What Newton's iteration starts from is brought back with the angles, and bodies that a row keeps at a difference count
/// as one.
#[test]
fn iterations_go_on_over_whole_turns() {
    let mut sim = Plate::new().start_with(Dop853::new(1e-11)).unwrap();
    let mut other = PlateAbsolute::new().start_with(Dop853::new(1e-11)).unwrap();
    for k in 1..=4 {
        let time = 0.5 * f64::from(k);
        sim.step_to(time).unwrap();
        other.step_to(time).unwrap();
        for (angle, reference) in [
            (sim.state_of("crank[0]").angle, other.state_of("crank[0]").angle),
            (sim.state_of("crank[2]").angle, other.state_of("crank[2]").angle),
            (sim.state_of("plate").angle, other.state_of("plate").angle),
            (sim.state_of("crank[2]").angle, sim.state_of("crank[0]").angle - 40_f64.to_radians()),
        ] {
            assert!((angle - reference).abs() < 1e-8, "{time}: {angle} {reference}");
        }
        assert!(sim.x()[0].abs() < 5.0 && [2, 5, 8].iter().all(|&k| other.x()[k].abs() < 6.0));
    }
    assert_eq!((sim.stats().charts, other.held().turns.iter().max()), (0, Some(&1)));
}
