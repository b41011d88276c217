//! Points and circles on polygons.

use plm::{Dop853, Mechanism as _};

use super::near;
use crate::scene::Named as _;

scene! {
    /// Pairs that fall and strike each other on the line of their centres: a pebble and a disc against plates.
    pub Plates {
        gravity: 9.81 m/s^2;
        body pebble { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start x: -1 m; start y: 5 m; start vx: 2 m/s; }
        body second { mass: 3 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start y: 5 m; }
        point_on_polyline side(second.c, pebble.c) {
            vertices: (-0.2, -0.2), (-0.2, 0.2), (0.2, 0.2), (0.2, -0.2) m;
            ends: closed;
            thickness: 5 cm;
            restitution: 0.5;
        }
        body disc { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start x: -1 m; start y: 10 m; start vx: 2 m/s; }
        body third { mass: 3 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start y: 10 m; start angle: -45 deg; }
        circle_on_polyline edge(third.c, disc.c) {
            vertices: (-0.2, -0.2), (-0.2, 0.2), (0.2, 0.2), (0.2, -0.2) m;
            ends: closed;
            radius: 0.1 m;
            restitution: 0.5;
        }
        output side.position, edge.position;
        allow(W0002);
    }
}

/// A central impact of 1 kg at 2 m/s on 3 kg with restitution 1/2 leaves -1/4 and 3/4 m/s: of a point on a side, and of a circle on the
/// corner between the last side and the first one.
#[test]
fn polygons_are_struck_on_sides_and_corners() {
    let mut sim = Plates::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(1.0).unwrap();
    let bodies = [
        (sim.state_of("pebble"), sim.state_of("second"), 0.8),
        (sim.state_of("disc"), sim.state_of("third"), 0.9 - 0.2 * 2.0_f64.sqrt()),
    ];
    for (light, heavy, gap) in bodies {
        near(light.vx, -0.25, 1e-9);
        near(heavy.vx, 0.75, 1e-9);
        near(heavy.x, 0.75 * (1.0 - gap / 2.0), 1e-9);
        near(light.omega.abs() + heavy.omega.abs(), 0.0, 1e-9);
    }
}
