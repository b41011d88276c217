//! Bodies without mass: their motion is that of bodies with any mass, to the bit.

use plm::{Described, Dop853, Stabilise as _};

/// Mechanisms whose bodies have the mass and the inertia that are written, or none.
macro_rules! driven {
    ($module:ident $($mass:tt)*) => {
        mod $module {
            plm::mechanism! {
                /// A four-bar linkage: its loop is a dyad.
                pub FourBar {
                    gravity: 9.81 m/s^2;
                    param speed: rad/s = 3 rad/s;
                    ground { port o: (0, 0) m; port r: (0.4, 0) m; }
                    body crank { $($mass)* port o: (-0.05, 0) m; port pin: (0.05, 0) m; start angle: 60 deg; }
                    body coupler { $($mass)* port a: (-0.2, 0) m; port b: (0.2, 0) m; port tip: (0.02, 0.1) m; }
                    body rocker { $($mass)* port a: (0.15, 0) m; port r: (-0.15, 0) m; start angle: 90 deg; }
                    revolute drive(ground.o, crank.o);
                    revolute pin(crank.pin, coupler.a);
                    revolute knee(coupler.b, rocker.a);
                    revolute pivot(ground.r, rocker.r);
                    spring cord(ground.r, coupler.tip) { stiffness: 100 N/m; free_length: 0.1 m; }
                    constraint turns: crank.angle = 60 deg + speed*t + 0.2 rad*sin(5 rad/s*t);
                    output coupler.tip.position, coupler.tip.velocity, ratio = rocker.omega/crank.omega, cord.force;
                    output tip_acceleration = coupler.tip.acceleration, rocker.alpha;
                }
            }
            plm::mechanism! {
                /// A plate on three legs: its loops are solved by Newton's iteration.
                pub Plate {
                    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
                    body crank[0] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: 20 deg; }
                    body crank[1] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: 20 deg; }
                    body crank[2] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: -20 deg; }
                    body plate {
                        $($mass)*
                        port a: (-0.4, -0.3) m, angle: 35 deg;
                        port b: (0.4, -0.3) m, angle: 140 deg;
                        port c: (0, 0.4) m, angle: 100 deg;
                        start x: 0.5 m;
                        start y: 0.3 m;
                    }
                    revolute o[0](ground.a, crank[0].o);
                    revolute o[1](ground.b, crank[1].o);
                    revolute o[2](ground.c, crank[2].o);
                    pin_slot slot[0](plate.a, crank[0].e);
                    pin_slot slot[1](plate.b, crank[1].e);
                    pin_slot slot[2](plate.c, crank[2].e);
                    constraint first: crank[0].angle = 0.4 rad*sin(3 rad/s*t);
                    constraint second: crank[1].angle = 0.3 rad*cos(2 rad/s*t);
                    constraint third: crank[2].angle = 0.2 rad*sin(4 rad/s*t) - 0.1 rad;
                    output plate.position, plate.velocity, plate.angle, plate.omega;
                    output plate.acceleration, plate.alpha;
                }
            }
            plm::mechanism! {
                /// A pendulum with a mass on a crank that is driven.
                pub Hanging {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    body crank { $($mass)* port o: (0, 0) m; port pin: (0.1, 0) m; }
                    body bob { mass: 0.5 kg; inertia: 0.01 kg*m^2; port pin: (0, 0.2) m; start angle: 20 deg, locked; }
                    revolute drive(ground.o, crank.o);
                    revolute pin(crank.pin, bob.pin) { damping: 0.01 N*m*s/rad; }
                    constraint turns: crank.angle = 1 rad*(1 - cos(7 rad/s*t));
                    output bob.position, bob.velocity, pin.angle, bob.x, bob.y, bob.omega;
                    output bob.alpha, pin.force;
                }
            }
        }
    };
}

driven!(without);
driven!(heavy mass: 7 kg; inertia: 0.3 kg*m^2;);
driven!(light mass: 0.05 kg; inertia: 1e-3 kg*m^2;);

/// Runs three mechanisms that are declared alike, and compares: outputs that read no acceleration to the bit, those behind them to
/// rounding.
macro_rules! compare {
    ($name:ident, $exact:expr, $accelerations:expr) => {
        let mut runs = (
            without::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
            heavy::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
            light::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
        );
        for step in 0..40 {
            let found = runs.0.outputs();
            for other in [runs.1.outputs(), runs.2.outputs()] {
                for k in 0..$exact {
                    assert_eq!(found[k].to_bits(), other[k].to_bits(), "output {k} at step {step}");
                }
                for k in $exact..$exact + $accelerations {
                    let scale = 1.0 + found[k].abs();
                    assert!((found[k] - other[k]).abs() < 1e-11 * scale, "output {k} at step {step}");
                }
            }
            runs.0.step(0.05).unwrap();
            runs.1.step(0.05).unwrap();
            runs.2.step(0.05).unwrap();
        }
    };
}

#[test]
fn a_driven_linkage_needs_no_masses() {
    compare!(FourBar, 6, 3);
    compare!(Plate, 6, 3);
}

#[test]
fn a_driven_crank_needs_no_mass_where_a_pendulum_hangs() {
    compare!(Hanging, 8, 3);
}

#[test]
fn equilibria_and_linearisations_need_no_masses_of_driven_bodies() {
    let mut free = (without::Hanging::new(), heavy::Hanging::new());
    (free.0.start.bob.angle.locked, free.1.start.bob.angle.locked) = (false, false);
    let hangs =
        (free.0.stabilise().unwrap().balanced().unwrap(), free.1.stabilise().unwrap().balanced().unwrap());
    assert!(hangs.0.residuals.is_empty(), "{}", hangs.0);
    let hangs = (hangs.0.start().unwrap(), hangs.1.start().unwrap());
    assert!(hangs.0.bob().angle.abs() < 1e-9 && (hangs.0.bob().y + 0.2).abs() < 1e-12, "{:?}", hangs.0.bob());
    let found = (plm::linearise(&hangs.0).unwrap(), plm::linearise(&hangs.1).unwrap());
    assert_eq!(found.0.a.shape(), (2, 2));
    assert!((&found.0.a - &found.1.a).amax() < 1e-9, "{}{}", found.0.a, found.1.a);
    assert!((&found.0.c - &found.1.c).amax() < 1e-9, "{}{}", found.0.c, found.1.c);
}

#[test]
fn a_body_without_mass_says_so() {
    let (without, heavy) = (without::FourBar::new(), heavy::FourBar::new());
    let known = |k| (without.mass(k), without.inertia(k), heavy.mass(k), heavy.inertia(k));
    assert_eq!(known(1), (None, None, Some(7.0), Some(0.3)));
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("massless.npz");
    plm::view::Recorder::new(&without.start().unwrap()).recording().write(&path).unwrap();
    let run = &plm::view::Results::read(&path).unwrap().runs[0];
    let crank = &run.about.mechanism.bodies[0];
    assert!(crank.mass.is_nan() && crank.inertia.is_nan() && crank.ports[0].x == -0.05);
    assert_eq!(<without::FourBar as Described>::TABLES.parameters.len(), 1);
}
