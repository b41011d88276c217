//! Gravity as a vector: a mechanism that is turned together with its gravity moves as it did, turned.

use plm::dynamic::{Integrator, Mechanism};
use plm::{BodyState, Dop853, Mechanism as _, Moment as _, Stabilise as _};

use crate::scene::{Given as _, Named as _, of_text};

/// Its sine is -0.6 and its cosine 0.8: gravity is (-5.886, -7.848) m/s^2.
const LEANING: f64 = -0.643_501_108_793_284_4;

/// Gravities, and `tilt`, by which places and angles are turned: twice upright, leaning by a literal, and by a parameter.
const NUMBER: &str = "gravity: 9.81 m/s^2; let tilt = 0 rad;";
const DOWN: &str = "gravity: (0, -9.81) m/s^2; let tilt = 0 rad;";
const TURNED: &str = "gravity: (-5.886, -7.848) m/s^2; let tilt = -0.6435011087932844 rad;";
const ANY: &str = "param tilt: rad = 2 rad; gravity: 9.81 m/s^2*(sin(tilt), -cos(tilt));";

fn declared(gravity: &str, items: &str) -> String {
    format!("pub Turned {{ {gravity} {items} }}")
}

/// Half a second of a mechanism in all four gravities: its bodies and a force are turned.
fn turns(bodies: &[&str], force: &str, items: &str) {
    let started = |gravity| of_text(&declared(gravity, items)).start_with(Dop853::new(1e-12)).unwrap();
    let [mut upright, mut down, mut leaning, mut any] = [NUMBER, DOWN, TURNED, ANY].map(started);
    // A step in which energy comes out of nowhere is a fault.
    leaning.watch_energy(Some(0.1));
    any.watch_energy(Some(0.1));
    for _ in 0..=5 {
        assert_eq!(upright.state().x(), down.state().x());
        assert_eq!(upright.vector_of(force), down.vector_of(force));
        assert_eq!(upright.gravity_energy(), down.gravity_energy());
        for body in bodies {
            assert_turned(body, leaning.state_of(body), upright.state_of(body), LEANING);
            assert_turned(body, any.state_of(body), upright.state_of(body), 2.0);
        }
        assert_close("force", leaning.vector_of(force), about(upright.vector_of(force), LEANING), 1e-7);
        assert_close("force", any.vector_of(force), about(upright.vector_of(force), 2.0), 1e-7);
        for energy in [leaning.gravity_energy(), any.gravity_energy()] {
            assert_close("energy", [energy], [upright.gravity_energy()], 1e-9);
        }
        for sim in [&mut upright, &mut down, &mut leaning, &mut any] {
            sim.step(0.1).unwrap();
        }
    }
}

/// A vector turned by an angle.
fn about([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

#[track_caller]
fn assert_close<const N: usize>(what: &str, found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.iter().zip(&wanted) {
        assert!((found - wanted).abs() < tolerance * (1.0 + wanted.abs()), "{what}: {found} and {wanted}");
    }
}

/// Both are integrated to 1e-12; what is left is that error, grown over half a second.
#[track_caller]
fn assert_turned(what: &str, found: BodyState<f64>, upright: BodyState<f64>, tilt: f64) {
    assert_close(what, [found.x, found.y], about([upright.x, upright.y], tilt), 1e-9);
    assert_close(what, [found.vx, found.vy], about([upright.vx, upright.vy], tilt), 1e-9);
    assert_close(what, [found.angle, found.omega], [upright.angle + tilt, upright.omega], 1e-9);
}

#[test]
fn a_pendulum_turns_with_its_gravity() {
    turns(
        &["bob"],
        "hinge.force",
        "ground { port o: (0, 0) m; }
        body bob { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; start angle: 20 deg + tilt, locked; start omega: 2 rad/s, locked; }
        revolute hinge(ground.o, bob.o);
        output hinge.force;",
    );
}

#[test]
fn a_slide_turns_with_its_gravity() {
    turns(
        &["arm", "shoe"],
        "rail.force",
        "ground { port o: turn((0.1, -0.2) m, tilt); }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port rail: (0.4, -0.2) m, angle: 15 deg; start angle: 20 deg + tilt, locked; start omega: 2 rad/s, locked; }
        body shoe { mass: 1 kg; inertia: 0.05 kg*m^2; port rail: (-0.3, 0.05) m; start x: cos(tilt)*1 m; start y: sin(tilt)*1 m; }
        revolute shoulder(ground.o, arm.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; rest: tilt; }
        prismatic rail(arm.rail, shoe.rail) { stiffness: 50 N/m; }
        output rail.force;",
    );
}

// Long enough that elimination body by body is taken.
#[test]
fn a_chain_turns_with_its_gravity() {
    turns(
        &["bar[0]", "bar[4]", "bar[7]"],
        "hinge.force",
        "ground { port o: turn((1, 2) m, tilt); }
        repeat i in 0..8 {
            body bar[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0.01) m; start angle: 10 deg*i + tilt, locked; }
        }
        revolute hinge(ground.o, bar[0].a);
        repeat i in 1..8 { revolute pin[i](bar[i-1].b, bar[i].a) { damping: 0.01 N*m*s/rad; } }
        output hinge.force;",
    );
}

#[test]
fn a_four_bar_turns_with_its_gravity() {
    turns(
        &["crank", "coupler", "rocker"],
        "drive.force",
        "ground { port a: (0, 0) m; port d: turn((1, 0) m, tilt); }
        body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg + tilt, locked; start omega: 3 rad/s, locked; }
        body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: 30 deg + tilt; }
        body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: cos(tilt)*1 m; start y: sin(tilt)*1 m; start angle: 95 deg + tilt; }
        revolute drive(ground.a, crank.a);
        revolute crank_coupler(crank.b, coupler.b);
        revolute coupler_rocker(coupler.c, rocker.c);
        revolute pivot(ground.d, rocker.d);
        output drive.force;",
    );
}

#[test]
fn absolute_coordinates_turn_with_their_gravity() {
    turns(
        &["arm", "forearm"],
        "shoulder.force",
        "formulation: absolute;
        ground { port o: (0, 0) m; }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; start angle: 20 deg + tilt, locked; }
        body forearm { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; start angle: -50 deg + tilt, locked; }
        revolute shoulder(ground.o, arm.o);
        revolute elbow(arm.p, forearm.p);
        output shoulder.force;",
    );
}

/// The augmented equations of a tree of 28 states, by an implicit method.
#[test]
fn a_chain_turns_with_its_gravity_by_an_implicit_method() {
    let items = "
        ground { port o: (0, 0) m; }
        repeat i in 0..14 {
            body bar[i] { mass: 0.1 kg; inertia: 0.001 kg*m^2; port a: (-0.05, 0) m; port b: (0.05, 0) m; start angle: tilt; }
        }
        revolute pin[0](ground.o, bar[0].a) { damping: 0.01 N*m*s/rad; }
        repeat i in 1..14 { revolute pin[i](bar[i-1].b, bar[i].a) { damping: 0.01 N*m*s/rad; } }";
    let [expected, found] = [NUMBER, TURNED].map(|gravity| {
        let chain = Mechanism::from_text(&declared(gravity, items)).unwrap();
        let mut run = chain.start_with(Integrator::RadauIia5(1e-10)).unwrap();
        run.step_to(0.3).unwrap();
        run.body("bar[13]").unwrap()
    });
    assert_close("tip", [found.x, found.y], about([expected.x, expected.y], LEANING), 1e-7);
    assert_close("tip", [found.angle], [expected.angle + LEANING], 1e-6);
}

scene! {
    /// A pendulum on a board that is tilted.
    pub Board {
        param tilt: rad = 0;
        input pull: m/s^2 = 0;
        gravity: 9.81 m/s^2*(sin(tilt), -cos(tilt)) + (pull, 0);
        ground { port o: (0, 0) m; }
        body bob { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (0, 0.5) m; start angle: 10 deg; }
        revolute hinge(ground.o, bob.o);
        output weight = norm(gravity)*2 kg;
    }
}

/// It hangs along its gravity.
#[test]
fn an_equilibrium_hangs_along_gravity() {
    let found = Board::new().with("tilt", 0.4).stabilise().unwrap().balanced().unwrap();
    let angle = found.values.iter().find(|of| of.name == "bob.angle").unwrap().value;
    assert_close("angle", [angle], [0.4], 1e-9);
}

/// 9.81 m/s^2 down and as much to the right.
#[test]
fn gravity_may_be_an_input() {
    let mut sim = Board::new().start().unwrap();
    sim.set_input("pull", 9.81);
    sim.step(1e-4).unwrap();
    assert_close("weight", [sim.value_of("weight")], [2.0 * 9.81 * 2_f64.sqrt()], 1e-15);
    // The arm of the centre from the hinge is 0.5 m (sin a, -cos a) with a = 10 deg.
    let (sin, cos) = 10_f64.to_radians().sin_cos();
    let torque = 2.0 * 0.5 * (sin * -9.81 + cos * 9.81);
    assert_close("omega", [sim.state_of("bob").omega / 1e-4], [torque / (0.1 + 2.0 * 0.25)], 1e-6);
}
