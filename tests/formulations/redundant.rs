//! Rows that say what others say, and rows on bodies that no joint holds: every formulation moves alike.

use plm::{Dop853, Moment as _};

use super::formulations::{all_move_alike, on_both};
use crate::scene::{By as _, Given as _, Named as _, Scene};

/// A mechanism with redundant rows in the formulation that is taken, with so many numbers in its state, and in absolute coordinates.
macro_rules! moves_alike {
    ($test:ident, $states:literal, { $($item:tt)* }) => {
        mod $test {
            pub(super) mod least {
                scene! { pub Scene { allow(W0001); $($item)* } }
            }
            pub(super) mod absolute {
                scene! { pub Scene { formulation: absolute; allow(W0001); $($item)* } }
            }
        }

        #[test]
        fn $test() {
            moves_alike(&$test::least::Scene::new(), &$test::absolute::Scene::new(), $states);
        }
    };
}

fn moves_alike(least: &Scene, absolute: &Scene, states: usize) {
    let mut one = least.by(Dop853::new(1e-11)).unwrap();
    let mut other = absolute.by(Dop853::new(1e-11)).unwrap();
    for _ in 0..=5 {
        all_move_alike(&one, &other, 1e-7);
        one.step(0.1).unwrap();
        other.step(0.1).unwrap();
    }
    // Room that is not used stays zero.
    assert_eq!(one.state().x().iter().filter(|number| **number != 0.0).count(), states);
}

moves_alike!(a_slot_within_a_triangle_takes_no_freedom_away, 4, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m, axis: 0.5 rad; }
    body a {
        mass: 1 kg; inertia: 0.1 kg*m^2;
        port o: (0, 0) m; port p: (0.4, -0.2) m; port q: (0.1, 0.3) m; port s: (0.3, 0.2) m, angle: 0.7 rad;
    }
    body b {
        mass: 1 kg; inertia: 0.1 kg*m^2;
        port p: (-0.1, 0) m; port r: (0.2, 0.6) m; port s: (-0.2, 0.4) m; start x: 0.5 m; start y: -0.2 m;
    }
    body c { mass: 1 kg; inertia: 0.1 kg*m^2; port q: (-0.3, -0.1) m; port r: (0.3, 0) m; start x: 0.4 m; start y: 0.4 m; }
    pin_slot pin(ground.o, a.o);
    revolute ap(a.p, b.p);
    revolute br(b.r, c.r);
    revolute cq(a.q, c.q);
    pin_slot extra(a.s, b.s);
});

// Springs, dampers and a force that follows a body on such a triangle; the slot within is declared last.
moves_alike!(a_loaded_triangle_starts_as_it_is_declared, 4, {
    ground { port p0: (-0.247, 0.331) m, axis: 0.731 rad; port p1: (4.337, -3.802) m, axis: 0 rad; port p2: (3.976, 1.611) m, axis: 0 rad; }
    body b0 { mass: 1.496 kg; inertia: 0.077 kg*m^2; port p0: (-0.195, -0.042) m, angle: -1.122 rad; port p1: (0.664, -0.343) m, angle: 0.192 rad; port p2: (0.202, 0.123) m, angle: -1.911 rad; port p3: (0.525, -0.226) m, angle: 1.931 rad; port p4: (-0.401, 0.31) m, angle: 0 rad; start x: -0.12727410401542022 m; start y: 0.7056903178902191 m; start angle: 2.023 rad; start omega: -3.273 rad/s; }
    body b1 { mass: 2.422 kg; inertia: 0.221 kg*m^2; port p0: (0.033, 0.211) m, angle: -0.762 rad; port p1: (-0.662, -0.443) m, angle: 0.806 rad; port p2: (0.29897580890893527, 0.2921803607424482) m, angle: 0 rad; port p3: (-0.009, -0.171) m, angle: 0 rad; start x: -0.10122773364851198 m; start y: 1.2393950240052143 m; start angle: 0.191 rad; start omega: 0.017 rad/s; }
    body b2 { mass: 0.988 kg; inertia: 0.152 kg*m^2; port p0: (-0.224, -0.162) m, angle: -0.881 rad; port p1: (-0.12073613447847098, 0.19792083649243547) m, angle: 0 rad; port p2: (0.011, 0.202) m, angle: 0 rad; start x: -0.39849689261705745 m; start y: 0.6133707768690598 m; start angle: -0.865 rad; start omega: 1.921 rad/s; }
    pin_slot j0(ground.p0, b0.p0) { stiffness: 4.651 N/m; }
    revolute j1(b0.p1, b1.p0) { stiffness: 3.176 N*m/rad; }
    revolute j2(b1.p1, b2.p0) { stiffness: 8.116 N*m/rad; damping: 0.111 N*m*s/rad; }
    revolute j3(b0.p2, b2.p1);
    pin_slot j4(b0.p3, b1.p2);
    spring s0(ground.p1, b1.p3) { stiffness: 59.498 N/m; damping: 0.762 N*s/m; free_length: 0.751 m; }
    spring s1(ground.p2, b2.p2) { stiffness: 37.198 N/m; damping: 0.98 N*s/m; free_length: 1.174 m; }
    force f0(b0.p4) { axes: body; x: -8.039 N*sin(3.833 rad/s*t); y: -2.531 N; torque: -1.526 N*m; }
});

/// The starts above close all joints: assembly leaves them where they are.
#[test]
fn assembly_leaves_a_loaded_triangle_where_it_is() {
    let scene = a_loaded_triangle_starts_as_it_is_declared::least::Scene::new();
    let sim = scene.begin().unwrap();
    for name in ["b0", "b1", "b2"] {
        let (body, start) = (sim.state_of(name), |of: &str| scene.start_of(&format!("{name}.{of}")).value);
        let off = [body.x - start("x"), body.y - start("y"), body.angle - start("angle")];
        assert!(off.iter().all(|off| off.abs() < 1e-14), "{off:?}");
    }
}

// The first triangle, held at a point more: nothing is left but to slide, and the slot within still says nothing new.
moves_alike!(a_triangle_on_two_pins_swings, 2, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body a { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (0.4, -0.2) m; port q: (0.1, 0.3) m; port s: (0.3, 0.2) m; }
    body b {
        mass: 1 kg; inertia: 0.1 kg*m^2;
        port p: (-0.1, 0) m; port r: (0.2, 0.6) m; port s: (-0.2, 0.4) m; start x: 0.5 m; start y: -0.2 m;
    }
    body c { mass: 1 kg; inertia: 0.1 kg*m^2; port q: (-0.3, -0.1) m; port r: (0.3, 0) m; start x: 0.4 m; start y: 0.4 m; }
    revolute pin(ground.o, a.o);
    revolute ap(a.p, b.p);
    revolute br(b.r, c.r);
    revolute cq(a.q, c.q);
    revolute extra(a.s, b.s);
});

on_both!(a_rolling_wheel, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body wheel { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0) m; }
    body rod { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (-0.3, 0) m; start angle: 20 deg, locked; }
    revolute pin(wheel.p, rod.p);
    constraint on: wheel.y - 0.2 m = 0;
    constraint roll: wheel.x + 0.2 m*wheel.angle = 0;
});

on_both!(a_cam_lifts_a_free_body, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body cam { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.2, 0) m; start angle: 0.3 rad, locked; start omega: 2 rad/s, locked; }
    body lifted { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; }
    revolute pin(ground.o, cam.o);
    constraint lift: lifted.y - 0.1 m*sin(cam.angle) = 0;
    constraint guide: lifted.x - 0.3*lifted.y = 0.2 m;
});
