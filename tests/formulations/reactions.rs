//! Reactions of trees by the backward pass, against those that absolute coordinates find with all equations at once.

use plm::{Described as _, Mechanism as _, Moment as _};
use plm_compiler::compile;
use plm_compiler::token::Sources;

use super::formulations::absolute_state;
use crate::random::Random;
use crate::scene::{Named as _, Scene, State, numbers};

/// A tree in joint and in absolute coordinates: the outputs agree to 1e-12 of the largest one in random states. The code of
/// joint coordinates holds the backward pass, and not the equations of absolute ones.
macro_rules! like_absolute_coordinates {
    ($test:ident, { $($item:tt)* }) => {
        mod $test {
            pub(super) mod tree {
                scene! { pub Scene { formulation: tree; $($item)* } }
            }
            pub(super) mod absolute {
                scene! { pub Scene { formulation: absolute; $($item)* } }
            }
        }

        #[test]
        fn $test() {
            let code = emitted(concat!("pub Scene { formulation: tree; ", stringify!($($item)*), "}"));
            assert!(code.contains("fn reactions(") && !code.contains("fn dynamics("));
            have_alike_outputs(&$test::tree::Scene::new(), &$test::absolute::Scene::new());
        }
    };
}

fn have_alike_outputs(tree: &Scene, absolute: &Scene) {
    let (one, other) = (tree.start().unwrap(), absolute.start().unwrap());
    let freedoms = usize::try_from(tree.tables().report.degrees_of_freedom).unwrap();
    let mut random = Random(2026);
    for case in 0..200 {
        let own: Vec<f64> = (0..2 * freedoms).map(|_| 3.0 * random.unit()).collect();
        let (coordinates, rates) = own.split_at(freedoms);
        let time = random.unit();
        let state = State::new(*tree, one.state().held(), time, numbers(coordinates, rates));
        let at = absolute_state(&state.bodies());
        let reference = State::new(*absolute, other.state().held(), time, at);
        let (found, wanted) = (state.outputs(), reference.outputs());
        assert!(found.len() == wanted.len() && !found.is_empty());
        let scale = wanted.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for (k, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
            assert!((found - wanted).abs() < 1e-12 * scale, "seed 2026, case {case}, {k}: {found} {wanted}");
        }
        assert!(!state.undetermined().contains(&true));
    }
}

mod theory {
    scene! {
        pub Pendulum {
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; }
            body rod { mass: 3 kg; inertia: 0.2 kg*m^2; port o: (-0.4, 0) m; start angle: 0 deg, locked; }
            revolute pin(ground.o, rod.o);
            output pin.force;
        }
    }
    scene! {
        pub Slope {
            gravity: 9.81 m/s^2;
            ground { port rail: (0, 0) m, axis: 30 deg; }
            body block { mass: 20 kg; inertia: 1 kg*m^2; port foot: (0.3, 0.1) m; start angle: 30 deg; }
            prismatic guide(ground.rail, block.foot) { stiffness: 10000 N/m; }
            output guide.force, guide.torque;
        }
    }
}

#[test]
fn a_pendulum_pulls_at_its_pin_as_theory_says() {
    // Along the rod, m (w^2 r - g sin); across it, m g cos less what its inertia takes: J / (J + m r^2) of it.
    let pendulum = theory::Pendulum::new();
    let input = pendulum.start().unwrap().state().held();
    for k in 0..12 {
        let (angle, omega) = (f64::from(k) * 0.55, f64::from(k) - 5.0);
        let state = State::new(pendulum, input, 0.0, numbers(&[angle], &[omega]));
        let (sin, cos) = angle.sin_cos();
        let along = 3.0 * (omega * omega * 0.4 - 9.81 * sin);
        let across = -3.0 * 9.81 * cos * 0.2 / (0.2 + 3.0 * 0.16);
        let expected = [along * cos - across * sin, along * sin + across * cos];
        for (found, expected) in state.outputs().iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12 * 100.0, "{angle} {omega}: {found} {expected}");
        }
    }
}

#[test]
fn a_slope_carries_the_weight_across_it() {
    // The manual's block of 20 kg (PLMTRA10) on 30 degrees: 196.2 N cos 30 deg, which it prints as 169.91 N for the spring at
    // 60 degrees. That force and the spring's act at the foot.
    let slope = theory::Slope::new();
    let input = slope.start().unwrap().state().held();
    let state = State::new(slope, input, 0.0, numbers(&[0.02], &[1.5]));
    let [x, y, couple] = *state.outputs() else { panic!("a force and a torque") };
    assert!((x.hypot(y) - 169.91).abs() < 0.005 && y < 0.0, "{x} {y}");
    assert!((y / x + 3.0_f64.sqrt()).abs() < 1e-12, "{x} {y}");
    // Their moment about G is what the couple on the block has to balance, and what the guide's on the ground equals.
    let (normal, spring) = (196.2 * 0.75_f64.sqrt(), -1e4 * 0.02);
    let torque = 0.3 * normal - 0.1 * spring;
    assert!((couple - torque).abs() < 1e-9, "{couple} {torque}");
}

fn emitted(declaration: &str) -> String {
    let mut sources = Sources::new();
    sources.add_text("declaration", declaration);
    compile(&mut sources).code.unwrap().text()
}

like_absolute_coordinates!(double_pendulum, {
    gravity: 9.81 m/s^2;
    ground { port o: (0.1, -0.2) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; start angle: 20 deg, locked; }
    body forearm { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; start angle: -50 deg, locked; }
    revolute shoulder(ground.o, arm.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
    revolute elbow(forearm.p, arm.p) { stiffness: 2 N*m/rad; rest: 30 deg; }
    output shoulder.force, elbow.force, forearm.ax, forearm.alpha;
});

like_absolute_coordinates!(chain_of_eight, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body b0 { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 0.5 m; }
    body b1 { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0.1) m; start x: 1.5 m; }
    body b2 { mass: 2 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 2.5 m; }
    body b3 { mass: 1 kg; inertia: 0.3 kg*m^2; port a: (-0.5, 0.2) m; port b: (0.5, 0) m; start x: 3.5 m; }
    body b4 { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 4.5 m; }
    body b5 { mass: 3 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 5.5 m; }
    body b6 { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 6.5 m; }
    body b7 { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: 7.5 m; }
    revolute p0(ground.o, b0.a);
    revolute p1(b0.b, b1.a);
    revolute p2(b1.b, b2.a);
    revolute p3(b2.b, b3.a);
    revolute p4(b3.b, b4.a);
    revolute p5(b4.b, b5.a);
    revolute p6(b5.b, b6.a);
    revolute p7(b6.b, b7.a);
    output p0.force, p3.force, p7.force, b7.ay;
});

like_absolute_coordinates!(slides, {
    gravity: 9.81 m/s^2;
    input push: N = 4 N;
    ground { port o: (0, 0) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port rail: (0.1, 0.3) m, angle: 25 deg; start angle: 40 deg, locked; }
    body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0.05, -0.02) m, angle: 10 deg; port s: (0.1, 0.1) m, angle: -35 deg; start x: 0.6 m; start y: 0.6 m; start angle: 55 deg; }
    body tip { mass: 0.5 kg; inertia: 0.01 kg*m^2; port p: (0.1, 0) m; start x: 0.9 m; start y: 0.7 m; start angle: 10 deg, locked; }
    revolute hinge(arm.o, ground.o);
    prismatic rail(arm.rail, shoe.a) { stiffness: 200 N/m; damping: 3 N*s/m; free_length: 0.2 m; drive: push; }
    pin_slot slot(shoe.s, tip.p) { stiffness: 150 N/m; damping: 2 N*s/m; rotary_damping: 0.05 N*m*s/rad; }
    output hinge.force, rail.force, rail.torque, slot.force, tip.alpha;
});

like_absolute_coordinates!(slides_from_the_child_to_the_ground, {
    gravity: 9.81 m/s^2;
    ground { port a: (0.2, 0.1) m; }
    body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port rail: (0.05, 0.02) m, angle: 30 deg; port p: (0.2, 0) m; start angle: -30 deg; start x: 0.5 m; }
    body arm { mass: 0.5 kg; inertia: 0.02 kg*m^2; port p: (-0.3, 0) m; start angle: 10 deg, locked; }
    prismatic rail(shoe.rail, ground.a) { stiffness: 100 N/m; }
    pin_slot slot(arm.p, shoe.p) { stiffness: 80 N/m; damping: 1 N*s/m; }
    output rail.force, rail.torque, slot.force;
});

like_absolute_coordinates!(welded_and_free_bodies, {
    gravity: 1.5 m/s^2;
    ground { port o: (0, 0) m; }
    body plate { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port w: (0.2, 0.1) m, angle: 15 deg; start angle: 10 deg, locked; }
    body block { mass: 1 kg; inertia: 0.03 kg*m^2; port w: (-0.1, 0) m; port hook: (0.2, 0) m; start angle: 25 deg; start x: 0.7 m; }
    body bird { mass: 0.3 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; port bell: (0, -0.1) m; start x: 1.5 m, locked; start y: 0.2 m, locked; start angle: 1 rad, locked; }
    body bell { mass: 0.2 kg; inertia: 0.004 kg*m^2; port top: (0, 0.2) m; start x: 1.5 m; start angle: 20 deg, locked; }
    revolute hinge(ground.o, plate.o);
    weld seam(plate.w, block.w);
    revolute chime(bird.bell, bell.top);
    spring leash(block.hook, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }
    output hinge.force, seam.force, seam.torque, chime.force, bird.ay;
});

like_absolute_coordinates!(on_a_moving_pivot, {
    gravity: 9.81 m/s^2;
    ground { port p: (0.1 m * sin(7 rad/s * t), 0.05 m * cos(11 rad/s * t)); }
    body rod { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (0, 0.4) m; start angle: 35 deg, locked; }
    revolute pin(ground.p, rod.p);
    output pin.force, rod.ax, rod.ay;
});

like_absolute_coordinates!(with_a_prescribed_angle, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body rotor { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.1, 0) m; port p: (0.4, 0.1) m; }
    body arm { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (-0.3, 0) m; start angle: 35 deg, locked; }
    revolute bearing(ground.o, rotor.o);
    revolute elbow(rotor.p, arm.p);
    constraint motor: rotor.angle = 0.5 rad*sin(5 rad/s*t);
    output bearing.force, elbow.force, rotor.alpha;
});
