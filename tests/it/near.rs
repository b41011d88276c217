//! Conditions that change near a singular pose, where a mechanism goes on in absolute coordinates.

use core::f64::consts::PI;

/// A parallelogram without gravity that turns at 1 rad/s from 1 rad, and is flat at half a turn.
macro_rules! rhomb {
    ($module:ident, { $($more:tt)* }) => {
        mod $module {
            plm::mechanism! {
                pub Rhomb {
                    $($more)*
                    param edge: rad = 3.15 rad;
                    ground { port a: (0, 0) m; port d: (2, 0) m; }
                    body left { mass: 1 kg; inertia: 1 kg*m^2/48; port a: (-0.25, 0) m; port b: (0.25, 0) m; start angle: 1 rad, locked; start omega: 1 rad/s, locked; }
                    body top { mass: 2 kg; inertia: 2 kg*m^2/3; port b: (-1, 0) m; port c: (1, 0) m; start x: 1 m; start y: 0.4 m; }
                    body right { mass: 1 kg; inertia: 1 kg*m^2/48; port d: (-0.25, 0) m; port c: (0.25, 0) m; start x: 2 m; start angle: 1 rad; }
                    revolute a(ground.a, left.a);
                    revolute b(left.b, top.b);
                    revolute c(top.c, right.c);
                    revolute d(ground.d, right.d);
                    state past: s = 0 s;
                    rate past = if left.angle > edge then 1 else 0;
                    output past;
                }
            }
        }
    };
}

rhomb!(least, {
    state area: rad*s = 0 rad*s;
    rate area = max(left.angle - edge, 0);
    output area;
});
rhomb!(absolute, { rung: absolute; });

/// At the end of a run with the edge at `PI + off`: the simulation, and how long it should have been past the edge.
macro_rules! run {
    ($module:ident, $off:expr) => {{
        let mut parallelogram = $module::Rhomb::new();
        parallelogram.edge = PI + $off;
        let mut sim = parallelogram.start().unwrap();
        sim.step(2.5).unwrap();
        assert!(sim.stats().near_singular > 0, "{}: {:?}", $off, sim.stats());
        assert_eq!(sim.stats().switches, 1, "{}", $off);
        (sim, 3.5 - (PI + $off))
    }};
}

#[test]
fn conditions_switch_near_a_flat_pose_where_they_should() {
    for off in [-0.1, -0.01, -1e-3, 1e-3, 0.01, 0.1] {
        let (sim, past) = run!(least, off);
        assert_eq!(sim.stats().change_points, 1, "{off}");
        assert!((sim.past() - past).abs() < 1e-8, "{off}: {:e}", sim.past() - past);
        assert!((sim.area() - 0.5 * past * past).abs() < 1e-6, "{off}: {:e}", sim.area() - 0.5 * past * past);
        let (sim, past) = run!(absolute, off);
        assert!((sim.past() - past).abs() < 1e-8, "{off}: {:e}", sim.past() - past);
    }
}
