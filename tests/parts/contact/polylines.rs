//! Points and circles on polylines.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _};

use super::{G, near, opens};
use crate::scene::Named as _;

scene! {
    /// A pebble on stairs.
    pub Stairs {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body pebble { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: 1 m; start vx: 1 m/s; }
        point_on_polyline stairs(ground.o, pebble.c) {
            vertices: (-5, 0), (1, 0), (1, -0.5), (5, -0.5) m;
            thickness: 0.2 m;
            restitution: 0.5;
        }
        output stairs.push;
    }
}

scene! {
    /// A disc that rolls off an edge.
    pub Edge {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body disc { mass: 3 kg; inertia: disc(3 kg, 0.2 m); port c: (0, 0) m; start x: 0.9 m; start y: 0.2 m; start vx: 0.3 m/s; start omega: -1.5 rad/s; }
        circle_on_polyline edge(ground.o, disc.c) { vertices: (-5, 0), (1, 0), (1, -3), (5, -3) m; radius: 0.2 m; friction: 1e6; }
        output edge.push, edge.lost;
    }
}

/// It falls by 1 m, bounces twice on the upper step, flies over the edge and falls by 0.5 m.
#[test]
fn a_pebble_bounces_down_stairs() {
    let mut sim = Stairs::new().start_with(Dop853::new(1e-10)).unwrap();
    let first = (2.0 / G).sqrt();
    let (second, up) = (2.0 * first, 0.25 * G * first);
    let third = second + (up + (up * up + G).sqrt()) / G;
    for (time, leaves) in [(first, 0.5 * G * first), (second, up), (third, 0.5 * (up * up + G).sqrt())] {
        sim.step_to(time - 1e-9).unwrap();
        assert!(sim.state_of("pebble").vy < 0.0, "before {time} s");
        sim.step_to(time + 1e-9).unwrap();
        near(sim.state_of("pebble").vy, leaves, 1e-7);
    }
    near(sim.state_of("pebble").x, third, 1e-8);
    near(sim.state_of("pebble").y, -0.5, 1e-8);
    // It comes to rest on the lower step, which bears it.
    sim.step_to(3.5).unwrap();
    assert_eq!((sim.state_of("pebble").vy, sim.contact("stairs.contact[3]")), (0.0, Some(Mode::Closed)));
    near(sim.value_of("stairs.push"), G, 1e-9);
}

/// A disc that rolls off an edge turns about it and leaves at cos = (4 + 3 v^2/(g r))/7.
#[test]
fn a_disc_rolls_off_an_edge() {
    let mut sim = Edge::new().start_with(Dop853::new(1e-10)).unwrap();
    let over = 0.1 / 0.3;
    sim.step_to(over - 1e-6).unwrap();
    near(sim.value_of("edge.push"), 3.0 * G, 1e-9);
    sim.step_to(over + 1e-6).unwrap();
    assert_eq!(sim.contact("edge.corner[1]"), Some(Mode::Closed));
    near(sim.value_of("edge.push"), 3.0 * (G - 0.09 / 0.2), 1e-4);
    opens(&mut sim, "edge.corner[1]");
    // Just before, a friction of a million times the push is not enough.
    near(sim.state_of("disc").y / 0.2, (4.0 + 3.0 * 0.09 / (G * 0.2)) / 7.0, 3e-8);
    near(sim.value_of("edge.lost"), 0.0, 1e-3);
}
