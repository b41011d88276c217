//! Contact on loops: joint coordinates against absolute coordinates, which know no charts.

use plm::{Dop853, Fault, mechanism};

use crate::near;

/// A four-bar linkage whose rocker strikes a buffer and rubs in its bearing.
macro_rules! four_bar {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                ground { port a: (0, 0) m; port d: (4, 0) m; }
                body crank {
                    mass: 1 kg; inertia: 0.2 kg*m^2;
                    port a: (-1, 0) m; port b: (1, 0) m;
                    start angle: 60 deg, locked;
                    start x: 0.5 m;
                    start y: 0.9 m;
                }
                body coupler {
                    mass: 2 kg; inertia: 0.6 kg*m^2;
                    port b: (-2, 0) m; port c: (2, 0) m;
                    start x: 3 m; start y: 2.6 m; start angle: 20 deg;
                }
                body rocker {
                    mass: 1.5 kg; inertia: 0.4 kg*m^2;
                    port c: (1.5, 0) m; port d: (-1.5, 0) m;
                    start x: 4.5 m; start y: 1.4 m; start angle: 80 deg;
                }
                revolute a(ground.a, crank.a);
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c);
                revolute d(ground.d, rocker.d);
                unilateral buffer: rocker.c.x - 3 m >= 0 m { restitution: 0.4; }
                friction bearing: rate(rocker.angle) within 0.8 N*m;
                output push = reaction(buffer);
                output drag = reaction(bearing);
                output joint = b.force.x;
            }
        }
    };
}

four_bar!(InCharts, loops);
four_bar!(InAbsolute, absolute);

/// Crank, rocker, a reaction of a joint, push and drag, every 0.05 s; the last two, and all reactions, where they are determined.
macro_rules! course {
    ($mechanism:expr) => {{
        let run = || -> Result<Vec<[f64; 5]>, Fault> {
            let mut sim = $mechanism.start_with(Dop853::new(1e-11))?;
            let mut rows = Vec::new();
            for k in 1..=80 {
                sim.step_to(0.05 * f64::from(k))?;
                let loads = [sim.joint(), sim.push(), sim.drag()];
                let [joint, push, drag] = loads.map(|load| if sim.is_undetermined() { 0.0 } else { load });
                rows.push([sim.crank().angle, sim.rocker().omega, joint, push, drag]);
            }
            assert!(sim.is_undetermined(), "buffer and bearing hold one freedom");
            assert!(sim.contact_stats().impacts > 9, "{:?}", sim.contact_stats());
            Ok(rows)
        };
        run().unwrap()
    }};
}

#[test]
fn a_linkage_strikes_and_rubs_the_same_in_all_coordinates() {
    let (charts, absolute) = (course!(InCharts::new()), course!(InAbsolute::new()));
    for (one, other) in charts.iter().flatten().zip(absolute.iter().flatten()) {
        near(*one, *other, 1e-8 * (1.0 + other.abs()));
    }
}
