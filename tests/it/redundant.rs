//! Rows that say what others say, and rows on bodies that no joint holds: every rung moves alike.

use plm::runtime::Absolute;
use plm::{Dop853, Moment, System};

use super::rungs::{close, on_both, on_rung_5, values};

/// A mechanism with redundant rows on the rung that is taken, with so many numbers in its state, and on rung 5.
macro_rules! moves_alike {
    ($test:ident, $states:literal, [$($body:ident),+], { $($item:tt)* }) => {
        mod $test {
            pub(super) mod least {
                plm::mechanism! { pub Scene { allow(W0001); $($item)* } }
            }
            pub(super) mod absolute {
                plm::mechanism! { pub Scene { rung: absolute; allow(W0001); $($item)* } }
            }
        }

        #[test]
        fn $test() {
            let mut one = $test::least::Scene::new().start_with(Dop853::new(1e-11)).unwrap();
            let mut other = $test::absolute::Scene::new().start_with(Dop853::new(1e-11)).unwrap();
            assert_eq!(one.state().x().len(), $states);
            for _ in 0..=5 {
                $(close(stringify!($body), values(one.$body()), values(other.$body()), 1e-7);)+
                one.step(0.1).unwrap();
                other.step(0.1).unwrap();
            }
        }
    };
}

moves_alike!(a_slot_within_a_triangle_takes_no_freedom_away, 4, [a, b, c], {
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

// The same triangle, held at a point more: nothing is left but to slide, and the slot within still says nothing new.
moves_alike!(a_triangle_on_two_pins_swings, 2, [a, b, c], {
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

on_both!(a_rolling_wheel, [wheel, rod], [], {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body wheel { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0) m; }
    body rod { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (-0.3, 0) m; start angle: 20 deg, locked; }
    revolute pin(wheel.p, rod.p);
    constraint on: wheel.y - 0.2 m = 0;
    constraint roll: wheel.x + 0.2 m*wheel.angle = 0;
});

on_both!(a_cam_lifts_a_free_body, [cam, lifted], [], {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body cam { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.2, 0) m; start angle: 0.3 rad, locked; start omega: 2 rad/s, locked; }
    body lifted { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; }
    revolute pin(ground.o, cam.o);
    constraint lift: lifted.y - 0.1 m*sin(cam.angle) = 0;
    constraint guide: lifted.x - 0.3*lifted.y = 0.2 m;
});
