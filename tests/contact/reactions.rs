//! Reactions of joints that bound frictions, in coordinates of joints against absolute coordinates, and the rate of rows that slip against
//! that of a system of equations.

use plm::runtime::System;
use plm::runtime::contact::{self, Contacts};
use plm::{Dop853, Fault, Moment, mechanism};

use crate::near;

macro_rules! linkage {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            /// A slider-crank whose rod moves a rocker, beside a yoke on a wheel that is driven.
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                param mu = 0.1;
                param arm: m = 4 mm;
                ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; port e: (0.35, 0.3) m; port w: (-1, 0) m; port guide: (-1, 0.5) m, axis: 0 deg; }
                body crank {
                    mass: 1 kg; inertia: 0.01 kg*m^2;
                    port o: (0, 0) m; port a: (0.1, 0) m;
                    start angle: 40 deg, locked; start omega: 6 rad/s, locked;
                }
                body rod {
                    mass: 0.5 kg; inertia: 0.004 kg*m^2;
                    port a: (-0.15, 0) m; port b: (0.15, 0) m; port c: (0, 0.05) m;
                    start x: 0.22 m; start y: 0.03 m; start angle: -12 deg;
                }
                body slider { mass: 2 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.37 m; }
                body link {
                    mass: 0.3 kg; inertia: 0.002 kg*m^2; port c: (-0.1, 0) m; port d: (0.1, 0) m;
                    start x: 0.23 m; start y: 0.18 m; start angle: 94 deg;
                }
                body rocker {
                    mass: 0.4 kg; inertia: 0.003 kg*m^2; port d: (-0.07, 0) m; port e: (0.06, 0.01) m;
                    start x: 0.29 m; start y: 0.29 m;
                }
                revolute o(ground.o, crank.o);
                revolute a(crank.a, rod.a);
                revolute b(slider.b, rod.b);
                prismatic rail(ground.rail, slider.b);
                revolute c(rod.c, link.c);
                revolute d(rocker.d, link.d);
                revolute e(ground.e, rocker.e);
                body wheel {
                    mass: 1 kg; inertia: 0.02 kg*m^2; port w: (0.01, 0) m; port pin: (0.1, 0.02) m;
                    start x: -1 m;
                }
                body yoke { mass: 0.7 kg; inertia: 0.01 kg*m^2; port guide: (0.05, 0) m; port slot: (0, -0.4) m, axis: 80 deg; start x: -1 m; start y: 0.4 m; }
                revolute w(ground.w, wheel.w);
                prismatic guide(ground.guide, yoke.guide);
                pin_slot slot(yoke.slot, wheel.pin);
                constraint drive: wheel.angle = 0.3 rad + 2 rad/s*t;
                friction on_rail: rate(slider.x) within mu*norm(rail.force);
                friction in_a: rate(rod.angle - crank.angle) within arm*norm(a.force);
                friction in_b: rate(rod.angle) within 0.5*arm*norm(b.force);
                friction in_c: rate(link.angle - rod.angle) within arm*norm(c.force);
                friction in_e: rate(rocker.angle) within arm*norm(e.force);
                friction on_guide: rate(guide.displacement) within mu*norm(guide.force);
                friction on_slot: rate(slot.displacement) within 0.2*mu*norm(slot.force);
                output drags = reaction(on_rail) + reaction(on_guide) + reaction(on_slot);
                output torques = reaction(in_a) + reaction(in_b) + reaction(in_c) + reaction(in_e);
                output first = crank.angle, second = rocker.angle, third = link.x;
            }
        }
    };
}

linkage!(LinkageInCharts, loops);
linkage!(LinkageInAbsolute, absolute);

macro_rules! collar {
    ($name:ident, $formulation:ident) => {
        mechanism! {
            /// A collar on an arm, with a bob that hangs from it; some frictions are bounded by two reactions.
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                param mu = 0.1;
                param arm: m = 4 mm;
                ground { port o: (0, 0) m; }
                body bar {
                    mass: 1 kg; inertia: 0.1 kg*m^2;
                    port o: (-0.3, 0) m; port guide: (0, 0.02) m, axis: 5 deg;
                    start angle: -20 deg, locked; start omega: 3 rad/s, locked;
                }
                body collar {
                    mass: 0.4 kg; inertia: 0.001 kg*m^2; port guide: (0, 0.01) m; port p: (0.02, -0.03) m;
                    start vx: 0.2 m/s;
                }
                body bob { mass: 0.5 kg; inertia: 0.003 kg*m^2; port p: (0, 0.2) m; start omega: -2 rad/s, locked; start angle: 30 deg, locked; }
                revolute o(ground.o, bar.o);
                prismatic guide(bar.guide, collar.guide) { stiffness: 40 N/m; }
                revolute p(collar.p, bob.p) { damping: 0.01 N*m*s/rad; }
                friction in_o: rate(bar.angle) within arm*norm(o.force);
                friction on_guide: rate(guide.displacement) within mu*norm(guide.force) + 0.05*mu*norm(p.force);
                friction in_p: rate(bob.angle - bar.angle) within arm*norm(p.force) + 0.3*arm*norm(o.force);
                friction slow: rate(bob.x) within 0.05 N;
                output drags = reaction(on_guide);
                output torques = reaction(in_o) + reaction(in_p);
                output first = bar.angle, second = collar.x, third = bob.angle;
            }
        }
    };
}

collar!(CollarInTree, tree);
collar!(CollarInAbsolute, absolute);

/// The rate at a state by sweeps is that of the system of equations of all rows.
#[track_caller]
fn sweeps_solve_the_system<M, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X)
where
    M: Contacts<N> + System<S = f64, X: AsRef<[f64]> + Copy>,
{
    let (mut found, mut known) = (*x, *x);
    let _ = system.rate(t, u, x, &mut found);
    let _ = contact::rate(system, t, u, x, &mut known);
    let size = known.as_ref().iter().fold(0.0, |size: f64, number| size.max(number.abs()));
    for (found, known) in found.as_ref().iter().zip(known.as_ref()) {
        near(*found, *known, 1e-13 * size);
    }
}

/// Outputs every 10 ms.
macro_rules! course {
    ($mechanism:expr, $rows:literal) => {{
        let run = || -> Result<Vec<[f64; 5]>, Fault> {
            let mechanism = $mechanism;
            let mut sim = mechanism.start_with(Dop853::new(1e-12))?;
            let (mut rows, mut swept) = (Vec::new(), 0);
            for k in 0..=40 {
                sim.step_to(0.01 * f64::from(k))?;
                let state = sim.state();
                sweeps_solve_the_system::<_, $rows>(&mechanism, state.time(), &state.held(), state.x());
                let sizes = Contacts::<$rows>::sliding(&mechanism, state.time(), &state.held(), state.x());
                swept += u32::from(sizes.is_some());
                rows.push([sim.drags(), sim.torques(), sim.first(), sim.second(), sim.third()]);
            }
            assert!(sim.stats().switches > 0, "{:?}", sim.stats());
            assert!(swept > 20, "{swept}");
            Ok(rows)
        };
        run().unwrap()
    }};
}

#[track_caller]
fn agree(one: &[[f64; 5]], other: &[[f64; 5]]) {
    for (one, other) in one.iter().flatten().zip(other.iter().flatten()) {
        near(*one, *other, 1e-9 * (1.0 + other.abs()));
    }
}

#[test]
fn loops_pass_on_the_reactions_of_absolute_coordinates() {
    agree(&course!(LinkageInCharts::new(), 7), &course!(LinkageInAbsolute::new(), 7));
}

#[test]
fn a_tree_passes_on_the_reactions_of_absolute_coordinates() {
    agree(&course!(CollarInTree::new(), 4), &course!(CollarInAbsolute::new(), 4));
}
