//! Gravity as a vector: a mechanism that is turned together with its gravity moves as it did, turned.

use plm::{BodyState, Dop853, Moment, RadauIia5, Stabilise};

/// Its sine is -0.6 and its cosine 0.8: gravity is (-5.886, -7.848) m/s^2.
const LEANING: f64 = -0.643_501_108_793_284_4;

/// A mechanism whose places and angles are turned by `tilt`: upright, leaning by a literal, and by a parameter.
macro_rules! turned {
    ($name:ident, [$($body:ident),+], $force:ident, { $($item:tt)* }) => {
        mod $name {
            pub(super) mod number {
                plm::mechanism! { pub Scene { gravity: 9.81 m/s^2; let tilt = 0 rad; $($item)* } }
            }
            pub(super) mod down {
                plm::mechanism! { pub Scene { gravity: (0, -9.81) m/s^2; let tilt = 0 rad; $($item)* } }
            }
            pub(super) mod leaning {
                plm::mechanism! {
                    pub Scene { gravity: (-5.886, -7.848) m/s^2; let tilt = -0.6435011087932844 rad; $($item)* }
                }
            }
            pub(super) mod any {
                plm::mechanism! {
                    pub Scene { param tilt: rad = 2 rad; gravity: 9.81 m/s^2*(sin(tilt), -cos(tilt)); $($item)* }
                }
            }
        }

        #[test]
        fn $name() {
            let mut upright = $name::number::Scene::new().start_with(Dop853::new(1e-12)).unwrap();
            let mut down = $name::down::Scene::new().start_with(Dop853::new(1e-12)).unwrap();
            let mut leaning = $name::leaning::Scene::new().start_with(Dop853::new(1e-12)).unwrap();
            let mut any = $name::any::Scene::new().start_with(Dop853::new(1e-12)).unwrap();
            // A step in which energy comes out of nowhere is a fault.
            leaning.watch_energy(Some(0.1));
            any.watch_energy(Some(0.1));
            for _ in 0..=5 {
                assert_eq!(upright.state().x(), down.state().x());
                assert_eq!(upright.$force(), down.$force());
                assert_eq!(upright.gravity_energy(), down.gravity_energy());
                $(
                    assert_turned(stringify!($body), leaning.$body(), upright.$body(), LEANING);
                    assert_turned(stringify!($body), any.$body(), upright.$body(), 2.0);
                )+
                assert_close("force", leaning.$force(), about(upright.$force(), LEANING), 1e-7);
                assert_close("force", any.$force(), about(upright.$force(), 2.0), 1e-7);
                for energy in [leaning.gravity_energy(), any.gravity_energy()] {
                    assert_close("energy", [energy], [upright.gravity_energy()], 1e-9);
                }
                upright.step(0.1).unwrap();
                down.step(0.1).unwrap();
                leaning.step(0.1).unwrap();
                any.step(0.1).unwrap();
            }
        }
    };
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

turned!(a_pendulum_turns_with_its_gravity, [bob], hinge_force, {
    ground { port o: (0, 0) m; }
    body bob { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; start angle: 20 deg + tilt, locked; start omega: 2 rad/s, locked; }
    revolute hinge(ground.o, bob.o);
    output hinge.force;
});

turned!(a_slide_turns_with_its_gravity, [arm, shoe], rail_force, {
    ground { port o: turn((0.1, -0.2) m, tilt); }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port rail: (0.4, -0.2) m, angle: 15 deg; start angle: 20 deg + tilt, locked; start omega: 2 rad/s, locked; }
    body shoe { mass: 1 kg; inertia: 0.05 kg*m^2; port rail: (-0.3, 0.05) m; start x: cos(tilt)*1 m; start y: sin(tilt)*1 m; }
    revolute shoulder(ground.o, arm.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; rest: tilt; }
    prismatic rail(arm.rail, shoe.rail) { stiffness: 50 N/m; }
    output rail.force;
});

// Long enough that elimination body by body is taken.
turned!(a_chain_turns_with_its_gravity, [bar_0, bar_4, bar_7], hinge_force, {
    ground { port o: turn((1, 2) m, tilt); }
    repeat i in 0..8 {
        body bar[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0.01) m; start angle: 10 deg*i + tilt, locked; }
    }
    revolute hinge(ground.o, bar[0].a);
    repeat i in 1..8 { revolute pin[i](bar[i-1].b, bar[i].a) { damping: 0.01 N*m*s/rad; } }
    output hinge.force;
});

turned!(a_four_bar_turns_with_its_gravity, [crank, coupler, rocker], drive_force, {
    ground { port a: (0, 0) m; port d: turn((1, 0) m, tilt); }
    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg + tilt, locked; start omega: 3 rad/s, locked; }
    body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: 30 deg + tilt; }
    body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: cos(tilt)*1 m; start y: sin(tilt)*1 m; start angle: 95 deg + tilt; }
    revolute drive(ground.a, crank.a);
    revolute crank_coupler(crank.b, coupler.b);
    revolute coupler_rocker(coupler.c, rocker.c);
    revolute pivot(ground.d, rocker.d);
    output drive.force;
});

turned!(absolute_coordinates_turn_with_their_gravity, [arm, forearm], shoulder_force, {
    formulation: absolute;
    ground { port o: (0, 0) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; start angle: 20 deg + tilt, locked; }
    body forearm { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; start angle: -50 deg + tilt, locked; }
    revolute shoulder(ground.o, arm.o);
    revolute elbow(arm.p, forearm.p);
    output shoulder.force;
});

/// A chain in two gravities, for implicit methods on large trees.
macro_rules! chain {
    ($module:ident, { $($gravity:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub Chain {
                    $($gravity)*
                    ground { port o: (0, 0) m; }
                    repeat i in 0..14 {
                        body bar[i] { mass: 0.1 kg; inertia: 0.001 kg*m^2; port a: (-0.05, 0) m; port b: (0.05, 0) m; start angle: tilt; }
                    }
                    revolute pin[0](ground.o, bar[0].a) { damping: 0.01 N*m*s/rad; }
                    repeat i in 1..14 { revolute pin[i](bar[i-1].b, bar[i].a) { damping: 0.01 N*m*s/rad; } }
                }
            }
        }
    };
}

chain!(upright, { gravity: 9.81 m/s^2; let tilt = 0 rad; });
chain!(leaning, { gravity: (-5.886, -7.848) m/s^2; let tilt = -0.6435011087932844 rad; });

/// The augmented equations of a tree of 28 states.
#[test]
fn a_chain_turns_with_its_gravity_by_an_implicit_method() {
    let mut upright = upright::Chain::new().start_with(RadauIia5::new(1e-10)).unwrap();
    let mut leaning = leaning::Chain::new().start_with(RadauIia5::new(1e-10)).unwrap();
    upright.step(0.3).unwrap();
    leaning.step(0.3).unwrap();
    let (found, expected) = (leaning.bar_13(), upright.bar_13());
    assert_close("tip", [found.x, found.y], about([expected.x, expected.y], LEANING), 1e-7);
    assert_close("tip", [found.angle], [expected.angle + LEANING], 1e-6);
}

mod board {
    plm::mechanism! {
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
}

/// It hangs along its gravity.
#[test]
fn an_equilibrium_hangs_along_gravity() {
    let board = board::Board { tilt: 0.4, ..board::Board::new() };
    let found = board.stabilise().unwrap().balanced().unwrap();
    let angle = found.values.iter().find(|of| of.name == "bob.angle").unwrap().value;
    assert_close("angle", [angle], [0.4], 1e-9);
}

/// 9.81 m/s^2 down and as much to the right.
#[test]
fn gravity_may_be_an_input() {
    let mut sim = board::Board::new().start().unwrap();
    sim.input.pull = 9.81;
    sim.step(1e-4).unwrap();
    assert_close("weight", [sim.weight()], [2.0 * 9.81 * 2_f64.sqrt()], 1e-15);
    // The arm of the centre from the hinge is 0.5 m (sin a, -cos a) with a = 10 deg.
    let (sin, cos) = 10_f64.to_radians().sin_cos();
    let torque = 2.0 * 0.5 * (sin * -9.81 + cos * 9.81);
    assert_close("omega", [sim.bob().omega / 1e-4], [torque / (0.1 + 2.0 * 0.25)], 1e-6);
}
